// Reading G-code; see gcode_reader.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/machine/gcode_reader.h"

#include "core/machine/gcode_state.h"

namespace patchmill {
namespace {

class Reader {
 public:
  Reader(const BallEndMill& tool, const ReadOptions& options) : tool_(tool), options_(options) {}
  void read(std::string_view text, long number) {
    const GcodeBlock block = read_block(text, number, options_, state_);
    if (block.dwell) dwell(block);
    if (block.moves()) move(block);
  }
  Program take() {
    close_section();
    return std::move(program_);
  }

 private:
  void move(const GcodeBlock& block);
  void dwell(const GcodeBlock& block);
  void append(const Vec3& end, const std::array<double, 3>& angles, double turns, MoveKind kind,
              long line);
  void close_section();

  BallEndMill tool_;
  ReadOptions options_;
  GcodeState state_;
  ProgramSection section_;
  Program program_;
};

void Reader::move(const GcodeBlock& block) {
  if (state_.motion == MotionMode::None) refuse_block(block, "no G0, G1 or G33 is in force.");
  const bool was_known = state_.known_position();
  Vec3 end = state_.at;
  double turned = 0.0;
  std::array<double, 3> angles = state_.angles;
  for (int i = 0; i < 3; ++i) {
    if (!std::isnan(block.axis[i])) {
      end[i] = block.axis[i] * state_.unit;
      state_.known[i] = true;
    }
    if (!std::isnan(block.angle[i])) angles[i] = block.angle[i];
    turned = std::hypot(turned, angles[i] - state_.angles[i]);
  }
  const Vec3 way = end - state_.at;
  const double turns = block_turns(block, state_, options_.dialect, way, turned);
  if (way.norm() == 0.0 && turned == 0.0 && was_known) return;
  const bool timed = was_known && state_.running_speed > 0.0;
  append(end, angles, timed ? turns : kUnknownTurns,
         state_.motion == MotionMode::Rapid ? MoveKind::Rapid : MoveKind::Cut, block.number);
  if (!was_known) ++section_.unplaced;
}

void Reader::dwell(const GcodeBlock& block) {
  if (std::isnan(block.p)) refuse_block(block, "G4 needs a P word.");
  const bool turning = state_.running_speed > 0.0;
  append(state_.at, state_.angles, turning ? block.p * state_.running_speed : kUnknownTurns,
         MoveKind::Link, block.number);
}

std::array<double, 3> radians(const std::array<double, 3>& degrees) {
  std::array<double, 3> out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = Angle::degrees(degrees[i]).radians();
  return out;
}

void Reader::append(const Vec3& end, const std::array<double, 3>& angles, double turns,
                    MoveKind kind, long line) {
  const Spindle spindle{state_.running_speed, state_.sense};
  ToolPath& path = section_.path;
  const bool same = path.spindle.speed == spindle.speed && path.spindle.sense == spindle.sense &&
                    section_.tool_number == state_.tool_number;
  if (!same || path.moves.empty()) {
    close_section();
    section_.tool_number = state_.tool_number;
    path = ToolPath{tool_, spindle, {state_.at, Vec3::UnitZ()}, {}};
    if (options_.rotary) section_.angles.push_back(radians(state_.angles));
  }
  path.moves.push_back({{end, Vec3::UnitZ()}, turns, kNoDimple, kind});
  section_.lines.push_back(line);
  if (options_.rotary) {
    section_.angles.push_back(radians(angles));
    section_.tcp.push_back(state_.tcp);
  }
  state_.at = end;
  state_.angles = angles;
}

void Reader::close_section() {
  if (!section_.path.moves.empty()) program_.sections.push_back(std::move(section_));
  section_ = ProgramSection();
}

}  // namespace

Program read_gcode(std::string_view text, const BallEndMill& tool, const ReadOptions& options) {
  Reader reader(tool, options);
  long number = 0;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    reader.read(text.substr(0, end), ++number);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  }
  return reader.take();
}

}  // namespace patchmill

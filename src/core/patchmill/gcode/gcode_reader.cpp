// Reading G-code; see gcode_reader.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/gcode_reader.h"

#include "patchmill/gcode/gcode_state.h"
#include "patchmill/geometry/error.h"

#include <algorithm>

namespace patchmill::gcode {
namespace {

constexpr double kChord = 1e-3;     // of lines in the place of an arc [mm]
constexpr double kSpread = 0.0127;  // of an arc's radii at its ends, as LinuxCNC allows [mm]

class Reader {
 public:
  Reader(const Tool& tool, const ReadOptions& options) : tool_(tool), options_(options) {}
  void read(std::string_view text, long number) {
    const GcodeBlock block = read_block(text, number, options_, state_);
    if (block.offset) lose_position();
    if (block.dwell) return dwell(block);
    if (block.machine || block.reference) return to_the_machine(block);
    if (state_.absolute_centre && !block.moves()) return pole(block);
    if (block.moves() || full_circle(block)) move(block);
  }
  Program take() {
    close_section();
    return std::move(program_);
  }

 private:
  /// An arc that names its centre alone ends where it begins.
  bool full_circle(const GcodeBlock& block) const {
    return (state_.motion == MotionMode::Clockwise || state_.motion == MotionMode::Counter) &&
           std::any_of(block.lead, block.lead + 3, [](double w) { return !std::isnan(w); });
  }
  void move(const GcodeBlock& block);
  void straight(const GcodeBlock& block, const Vec3& end, const std::array<double, 3>& angles,
                bool was_known);
  void arc(const GcodeBlock& block, const Vec3& end);
  void cycle(const GcodeBlock& block, const Vec3& end);
  void dwell(const GcodeBlock& block);
  void pole(const GcodeBlock& block);
  void to_the_machine(const GcodeBlock& block);
  void lose_position() {
    close_section();
    state_.known[0] = state_.known[1] = state_.known[2] = state_.pole_known = false;
  }
  void append(const Vec3& end, const std::array<double, 3>& angles, double turns, MoveKind kind,
              long line);
  void close_section();

  Tool tool_;
  ReadOptions options_;
  GcodeState state_;
  ProgramSection section_;
  Program program_;
};

void Reader::move(const GcodeBlock& block) {
  if (state_.motion == MotionMode::None) refuse_block(block, "no G0, G1 or G33 is in force.");
  const bool was_known = state_.known_position();
  if (state_.motion == MotionMode::Cycle) return cycle(block, state_.at);
  Vec3 end = state_.at;
  std::array<double, 3> angles = state_.angles;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!std::isnan(block.axis[i])) {
      end[i] = block.axis[i] * state_.unit + (state_.relative ? state_.at[i] : 0.0);
      state_.known[i] = state_.known[i] || !state_.relative;
    }
    if (!std::isnan(block.angle[i]))
      angles[k] = block.angle[i] + (state_.relative ? state_.angles[k] : 0.0);
  }
  if (state_.motion == MotionMode::Clockwise || state_.motion == MotionMode::Counter) {
    if (!was_known) refuse_block(block, "an arc begins nobody knows where.");
    if (angles != state_.angles) refuse_block(block, "a rotary axis turns in an arc.");
    return arc(block, end);
  }
  straight(block, end, angles, was_known);
}

// I, J, K are of arcs, and of moves that follow the spindle; R is of arcs and cycles.
void refuse_arc_words(const GcodeBlock& block, bool synchronised) {
  const bool leads =
      std::any_of(block.lead, block.lead + 3, [](double w) { return !std::isnan(w); });
  if (!std::isnan(block.r) || (leads && !synchronised))
    refuse_block(block, "I, J, K and R belong to no straight move.");
}

void Reader::straight(const GcodeBlock& block, const Vec3& end, const std::array<double, 3>& angles,
                      bool was_known) {
  refuse_arc_words(block, state_.motion == MotionMode::Synchronised);
  double turned = 0.0;
  for (std::size_t i = 0; i < 3; ++i) turned = std::hypot(turned, angles[i] - state_.angles[i]);
  const Vec3 way = end - state_.at;
  const double turns = block_turns(block, state_, *options_.control, way, way.norm(), turned);
  if (way.norm() == 0.0 && turned == 0.0 && was_known) return;
  const bool timed = was_known && state_.running_speed > 0.0;
  append(end, angles, timed ? turns : kUnknownTurns,
         state_.motion == MotionMode::Rapid ? MoveKind::Rapid : MoveKind::Cut, block.number);
  if (!was_known) ++section_.unplaced;
}

void Reader::arc(const GcodeBlock& block, const Vec3& end) {
  Arc arc{state_.at, end, state_.at, state_.plane, state_.motion == MotionMode::Clockwise};
  bool given = false;
  for (int i = 0; i < 3; ++i) {
    if (std::isnan(block.lead[i])) continue;
    given = true;
    arc.centre[i] = block.lead[i] * state_.unit + (state_.absolute_centre ? 0.0 : state_.at[i]);
  }
  const int across = arc.plane == ArcPlane::XY ? 2 : arc.plane == ArcPlane::ZX ? 1 : 0;
  if (!std::isnan(block.lead[across]))
    refuse_block(block, "the centre of an arc is in its plane: there is one word too many.");
  if (!std::isnan(block.r) && !given) {
    const auto centre = arc_centre(arc.from, end, block.r * state_.unit, arc.plane, arc.clockwise);
    if (!centre) refuse_block(block, "no arc of that radius goes from here to there.");
    arc.centre = *centre;
  } else if (!std::isnan(block.r) || (!given && !state_.pole_known)) {
    refuse_block(block, "an arc needs its centre or its radius.");
  } else if (!given) {
    arc.centre = state_.pole;
  }
  if (arc_spread(arc) > kSpread)
    refuse_block(block, "the ends of the arc are not equally far from its centre.");
  const double length = arc_length(arc);
  const double turns = block_turns(block, state_, *options_.control, end - arc.from, length, 0.0);
  const std::vector<Vec3> points = arc_points(arc, kChord);
  const double part =
      state_.running_speed > 0.0 ? turns / static_cast<double>(points.size()) : kUnknownTurns;
  for (const Vec3& point : points) append(point, state_.angles, part, MoveKind::Cut, block.number);
}

void Reader::cycle(const GcodeBlock& block, const Vec3& from) {
  for (int i = 0; i < 2; ++i) state_.known[i] = state_.known[i] || !std::isnan(block.axis[i]);
  if (!state_.known_position() || state_.relative || state_.plane != ArcPlane::XY)
    refuse_block(block,
                 "a cycle begins at a known place, in absolute coordinates, in the plane XY.");
  if (!std::isnan(block.l) && block.l != 1.0) refuse_block(block, "a cycle is done once: L1.");
  for (const double angle : block.angle)
    if (!std::isnan(angle)) refuse_block(block, "a rotary axis turns in a cycle.");
  DrillingCycle& cycle = state_.cycle;
  const auto take = [&](double value, double unit, double& into, bool& known) {
    if (std::isnan(value)) return;
    into = value * unit;
    known = true;
  };
  bool ignored = false;
  take(block.axis[2], state_.unit, cycle.bottom, state_.cycle_bottom);
  take(block.r, state_.unit, cycle.retract, state_.cycle_retract);
  take(block.q, state_.unit, cycle.peck, ignored);
  take(block.p, 1.0, cycle.seconds, ignored);
  if (!state_.cycle_bottom || !state_.cycle_retract)
    refuse_block(block, "a cycle needs its Z and R.");
  Vec3 over = from;
  for (int i = 0; i < 2; ++i)
    if (!std::isnan(block.axis[i])) over[i] = block.axis[i] * state_.unit;
  over.z() = std::max(from.z(), cycle.retract);
  std::vector<CycleStep> steps;
  try {
    steps = cycle_steps(cycle);
  } catch (const InputError& error) {
    refuse_block(block, error.remedy());
  }
  if (over.z() > from.z())
    append({from.x(), from.y(), over.z()}, state_.angles, kUnknownTurns, MoveKind::Rapid,
           block.number);
  if (over != state_.at) append(over, state_.angles, kUnknownTurns, MoveKind::Rapid, block.number);
  for (const CycleStep& step : steps) {
    const Vec3 end(over.x(), over.y(), step.z);
    const bool feeds = step.kind == CycleStep::Kind::Feed,
               waits = step.kind == CycleStep::Kind::Dwell;
    if (!waits && end == state_.at) continue;
    if (feeds && state_.mode == FeedMode::InverseTime)
      refuse_block(block, "a cycle has no feed in inverse time.");
    const Vec3 way = end - state_.at;
    double turns = kUnknownTurns;
    if (feeds) turns = block_turns(block, state_, *options_.control, way, way.norm(), 0.0);
    if (waits) turns = step.seconds * state_.running_speed;
    if (!(state_.running_speed > 0.0)) turns = kUnknownTurns;
    append(end, state_.angles, turns,
           feeds   ? MoveKind::Cut
           : waits ? MoveKind::Link
                   : MoveKind::Rapid,
           block.number);
  }
}

void Reader::dwell(const GcodeBlock& block) {
  if (std::isnan(block.p)) refuse_block(block, "G4 needs its time.");
  const bool turning = state_.running_speed > 0.0;
  append(state_.at, state_.angles, turning ? block.p * state_.running_speed : kUnknownTurns,
         MoveKind::Link, block.number);
}

void Reader::pole(const GcodeBlock& block) {
  if (std::isnan(block.lead[0]) || std::isnan(block.lead[1])) return;
  state_.pole = Vec3(block.lead[0], block.lead[1], 0.0) * state_.unit;
  state_.pole_known = true;
}

// Where that is in the work, nobody knows: the axes that move are lost.
void Reader::to_the_machine(const GcodeBlock& block) {
  refuse_arc_words(block, false);
  const bool all = block.reference && !block.moves();
  if (block.machine && block.moves() && state_.motion != MotionMode::Rapid &&
      state_.motion != MotionMode::Feed)
    refuse_block(block, "machine coordinates are for G0 and G1.");
  close_section();
  for (int i = 0; i < 3; ++i) {
    if (all || !std::isnan(block.axis[i])) state_.known[i] = false;
    if (!std::isnan(block.angle[i])) state_.angles[static_cast<std::size_t>(i)] = block.angle[i];
  }
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
  const bool same = section_.offset == state_.offset && path.spindle.speed == spindle.speed &&
                    path.spindle.sense == spindle.sense &&
                    section_.tool_number == state_.tool_number;
  if (!same || path.moves.empty()) {
    close_section();
    section_.tool_number = state_.tool_number;
    section_.offset = state_.offset;
    path = ToolPath{tool_, spindle, {state_.at, Vec3::UnitZ()}, {}};
    if (options_.rotary) section_.angles.push_back(radians(state_.angles));
  }
  path.moves.push_back({{end, Vec3::UnitZ()}, turns, kNoDimple, kind});
  section_.lines.push_back(line);
  const bool has_feed = kind == MoveKind::Cut && state_.motion != MotionMode::Synchronised;
  section_.feeds.push_back(has_feed ? state_.feed : kUnknownTurns);
  section_.inverse.push_back(state_.mode == FeedMode::InverseTime);
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

template <class Line>
void each_line(std::string_view text, const Line& line) {
  long number = 0;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    line(text.substr(0, end), ++number);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  }
}

}  // namespace

void refuse_block(const GcodeBlock& block, const std::string& why) {
  refuse_gcode(block.number, std::string(block.text), why);
}

Program read_gcode(std::string_view text, const Tool& tool, const ReadOptions& options) {
  Reader reader(tool, options);
  each_line(text, [&](std::string_view line, long number) { reader.read(line, number); });
  return reader.take();
}

std::vector<ProgramLine> program_lines(std::string_view text, const Control& control) {
  std::vector<ProgramLine> lines;
  each_line(text, [&](std::string_view line, long number) {
    std::vector<GcodeWord> words = control.read(control, line, number);
    if (!words.empty()) lines.push_back({number, std::move(words)});
  });
  return lines;
}

}  // namespace patchmill::gcode

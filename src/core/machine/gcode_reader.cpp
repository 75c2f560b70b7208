// Reading G-code; see gcode_reader.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/machine/gcode_reader.h"

#include "core/geometry/error.h"
#include "core/machine/gcode_words.h"

#include <cmath>

#include <fmt/format.h>

namespace patchmill {
namespace {

enum class FeedMode { PerMinute, InverseTime };
enum class Motion { None, Rapid, Feed, Synchronised };

// The modal state of the controller, and what a line adds to it.
struct State {
  Motion motion = Motion::None;
  FeedMode mode = FeedMode::PerMinute;
  double unit = 1.0;                        // mm per programmed unit
  double feed = 0.0;                        // as programmed, times unit in G94
  double speed = 0.0, running_speed = 0.0;  // rev/s, rev/s of the spindle as it turns
  SpindleSense sense = SpindleSense::M3;
  int tool_number = 0;
  Vec3 at = Vec3::Zero();
  bool known[3] = {false, false, false};
  std::array<double, 3> angles{};  // A B C, degrees
  bool tcp = false;
  bool known_position() const { return known[0] && known[1] && known[2]; }
};

struct Line {
  std::string_view text;
  long number = 0;
  double axis[3] = {kUnknownTurns, kUnknownTurns, kUnknownTurns};
  double angle[3] = {kUnknownTurns, kUnknownTurns, kUnknownTurns};  // A B C, degrees
  double f = kUnknownTurns, p = kUnknownTurns;
  double lead[3] = {kUnknownTurns, kUnknownTurns, kUnknownTurns};  // I J K
  bool dwell = false;
  bool moves() const {
    bool any = false;
    for (int i = 0; i < 3; ++i) any = any || !std::isnan(axis[i]) || !std::isnan(angle[i]);
    return any;
  }
};

class Reader {
 public:
  Reader(const BallEndMill& tool, const ReadOptions& options) : tool_(tool), options_(options) {}
  void read(std::string_view text, long number);
  Program take() {
    close_section();
    return std::move(program_);
  }

 private:
  void word(const GcodeWord& w, Line& line);
  void g_code(int tenths, Line& line);
  void m_code(int code, const Line& line);
  void move(const Line& line);
  void dwell(const Line& line);
  double turns_of(const Line& line, const Vec3& way, double turned) const;
  double lead_of(const Line& line, const Vec3& way) const;
  void append(const Vec3& end, const std::array<double, 3>& angles, double turns, MoveKind kind,
              long line);
  void close_section();
  [[noreturn]] void refuse(const Line& line, const std::string& why) const {
    refuse_gcode(line.number, std::string(line.text), why);
  }

  BallEndMill tool_;
  ReadOptions options_;
  State state_;
  ProgramSection section_;
  Program program_;
};

void Reader::read(std::string_view text, long number) {
  Line line;
  line.text = text;
  line.number = number;
  const std::vector<GcodeWord> words = dialect_words(options_.dialect, text, number);
  for (const GcodeWord& w : words)  // S comes before M3 in a block's order of execution
    if (w.letter == 'S') word(w, line);
  for (const GcodeWord& w : words)
    if (w.letter != 'S') word(w, line);
  const bool is_lead = state_.motion == Motion::Synchronised && options_.dialect == Dialect::Fanuc;
  if (!std::isnan(line.f) && !is_lead)
    state_.feed = line.f * (state_.mode == FeedMode::PerMinute ? state_.unit : 1.0);
  if (line.dwell) dwell(line);
  if (line.moves()) move(line);
}

void Reader::word(const GcodeWord& w, Line& line) {
  switch (w.letter) {
    case 'G':
      return g_code(static_cast<int>(std::lround(w.value * 10.0)), line);
    case 'M':
      return m_code(static_cast<int>(std::lround(w.value)), line);
    case 'X':
    case 'Y':
    case 'Z':
      line.axis[w.letter - 'X'] = w.value;
      return;
    case 'A':
    case 'B':
    case 'C':
      if (options_.rotary)
        line.angle[w.letter - 'A'] = w.value;
      else if (w.value != 0.0)
        refuse(line, "a rotary axis moves: reading it needs a machine file.");
      return;
    case 'F':
      line.f = w.value;
      return;
    case 'I':
    case 'J':
    case 'K':
      line.lead[w.letter - 'I'] = w.value;
      return;
    case 'P':
      line.p = w.value;
      return;
    case 'S':
      state_.speed = w.value / 60.0;
      if (state_.running_speed > 0.0) state_.running_speed = state_.speed;
      return;
    case 'T':
      state_.tool_number = static_cast<int>(std::lround(w.value));
      return;
    case 'H':
    case 'D':
    case 'Q':
      return;  // offsets by number, tolerance of G64: no effect on the programmed path
    default:
      refuse(line, fmt::format("the word {} is not read here.", w.letter));
  }
}

void Reader::g_code(int tenths, Line& line) {
  switch (tenths) {
    case 0:
      state_.motion = Motion::Rapid;
      return;
    case 10:
      state_.motion = Motion::Feed;
      return;
    case 330:
      state_.motion = Motion::Synchronised;
      return;
    case 40:
      line.dwell = true;
      return;
    case 200:
      state_.unit = 25.4;
      return;
    case 210:
      state_.unit = 1.0;
      return;
    case 930:
    case 940:
      if ((tenths == 930) == (state_.mode == FeedMode::InverseTime)) return;
      state_.mode = tenths == 930 ? FeedMode::InverseTime : FeedMode::PerMinute;
      state_.feed = 0.0;  // F must be given again
      return;
    case 800:
      state_.motion = Motion::None;
      return;
    case 434:  // tool-centre-point control
      state_.tcp = true;
      return;
    case 490:
      state_.tcp = false;
      return;
    case 170:  // plane: matters to arcs only
    case 400:  // no radius compensation
    case 430:  // tool length compensation: the programmed point is the tip
    case 540:  // work offset: the program's own frame is read
    case 550:
    case 560:
    case 570:
    case 580:
    case 590:
    case 610:  // path mode: how corners are rounded is the motion model's affair
    case 640:
    case 900:  // absolute
      return;
    default:
      refuse(line, fmt::format("G{:g} is not read: arcs, cycles and relative moves are not part of "
                               "a texture program.",
                               tenths / 10.0));
  }
}

void Reader::m_code(int code, const Line& line) {
  switch (code) {
    case 3:
    case 4:
      state_.sense = code == 3 ? SpindleSense::M3 : SpindleSense::M4;
      state_.running_speed = state_.speed;
      return;
    case 5:
    case 6:  // a tool change stops the spindle
      state_.running_speed = 0.0;
      return;
    case 428:  // TCP, in LinuxCNC's table-rotary-tilting configurations
    case 429:
      state_.tcp = code == 428;
      return;
    case 0:
    case 1:
    case 2:
    case 7:
    case 8:
    case 9:
    case 30:
      return;
    default:
      refuse(line, fmt::format("M{} is not read here.", code));
  }
}

// G33's lead along the path. Where it is told along the axis that moves most, the path's is longer.
double Reader::lead_of(const Line& line, const Vec3& way) const {
  Eigen::Index most = 0;
  const double longest = way.cwiseAbs().maxCoeff(&most);
  double lead = line.lead[2];
  if (options_.dialect == Dialect::Fanuc) lead = line.f;
  if (options_.dialect == Dialect::Siemens) lead = line.lead[most];
  if (!(lead > 0.0))
    refuse(line,
           fmt::format("G33 needs a lead ({}) greater than zero.", lead_letters(options_.dialect)));
  return lead * state_.unit *
         (options_.dialect == Dialect::LinuxCnc || longest == 0.0 ? 1.0 : way.norm() / longest);
}

double Reader::turns_of(const Line& line, const Vec3& way, double turned) const {
  if (state_.motion == Motion::Rapid) return kUnknownTurns;
  const double length = way.norm();
  if (state_.motion == Motion::Synchronised) return length / lead_of(line, way);
  if (state_.mode == FeedMode::InverseTime && std::isnan(line.f))
    refuse(line, "G93 needs an F word on every G1.");
  if (!(state_.feed > 0.0)) refuse(line, "no feed has been given.");
  // F is of X Y Z if one of them moves, else degrees a minute
  const double minutes = state_.mode == FeedMode::InverseTime ? 1.0 / state_.feed
                         : length > 0.0                       ? length / state_.feed
                                                              : turned * state_.unit / state_.feed;
  return minutes * 60.0 * state_.running_speed;
}

void Reader::move(const Line& line) {
  if (state_.motion == Motion::None) refuse(line, "no G0, G1 or G33 is in force.");
  const bool was_known = state_.known_position();
  Vec3 end = state_.at;
  double turned = 0.0;
  std::array<double, 3> angles = state_.angles;
  for (int i = 0; i < 3; ++i) {
    if (!std::isnan(line.axis[i])) {
      end[i] = line.axis[i] * state_.unit;
      state_.known[i] = true;
    }
    if (!std::isnan(line.angle[i])) angles[i] = line.angle[i];
    turned = std::hypot(turned, angles[i] - state_.angles[i]);
  }
  const Vec3 way = end - state_.at;
  const double turns = turns_of(line, way, turned);
  if (way.norm() == 0.0 && turned == 0.0 && was_known) return;
  const bool timed = was_known && state_.running_speed > 0.0;
  append(end, angles, timed ? turns : kUnknownTurns,
         state_.motion == Motion::Rapid ? MoveKind::Rapid : MoveKind::Cut, line.number);
  if (!was_known) ++section_.unplaced;
}

void Reader::dwell(const Line& line) {
  if (std::isnan(line.p)) refuse(line, "G4 needs a P word.");
  const bool turning = state_.running_speed > 0.0;
  append(state_.at, state_.angles, turning ? line.p * state_.running_speed : kUnknownTurns,
         MoveKind::Link, line.number);
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

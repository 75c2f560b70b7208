// Reading G-code; see gcode_reader.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/machine/gcode_reader.h"

#include "core/geometry/error.h"
#include "core/machine/gcode_words.h"

#include <algorithm>
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
  bool known_position() const { return known[0] && known[1] && known[2]; }
};

struct Line {
  std::string_view text;
  long number = 0;
  double axis[3] = {kUnknownTurns, kUnknownTurns, kUnknownTurns};
  double f = kUnknownTurns, k = kUnknownTurns, p = kUnknownTurns;
  bool dwell = false;
  bool moves() const {
    return !std::isnan(axis[0]) || !std::isnan(axis[1]) || !std::isnan(axis[2]);
  }
};

class Reader {
 public:
  explicit Reader(const BallEndMill& tool) : tool_(tool) {}
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
  double turns_of(const Line& line, double length) const;
  void append(const Vec3& end, double turns, MoveKind kind, long line);
  void close_section();
  [[noreturn]] void refuse(const Line& line, const std::string& why) const {
    refuse_gcode(line.number, std::string(line.text), why);
  }

  BallEndMill tool_;
  State state_;
  ProgramSection section_;
  Program program_;
};

void Reader::read(std::string_view text, long number) {
  Line line;
  line.text = text;
  line.number = number;
  const std::vector<GcodeWord> words = gcode_words(text, number);
  for (const GcodeWord& w : words)  // S comes before M3 in a block's order of execution
    if (w.letter == 'S') word(w, line);
  for (const GcodeWord& w : words)
    if (w.letter != 'S') word(w, line);
  if (!std::isnan(line.f))
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
      if (w.value != 0.0) refuse(line, "a rotary axis moves: reading it needs a machine file.");
      return;
    case 'F':
      line.f = w.value;
      return;
    case 'K':
      line.k = w.value;
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
      state_.mode = tenths == 930 ? FeedMode::InverseTime : FeedMode::PerMinute;
      state_.feed = 0.0;  // F must be given again
      return;
    case 800:
      state_.motion = Motion::None;
      return;
    case 170:  // plane: matters to arcs only
    case 400:  // no radius compensation
    case 430:  // tool length compensation: the programmed point is the tip
    case 490:
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

double Reader::turns_of(const Line& line, double length) const {
  if (state_.motion == Motion::Rapid) return kUnknownTurns;
  if (state_.motion == Motion::Synchronised) {
    if (!(line.k > 0.0)) refuse(line, "G33 needs a K word greater than zero.");
    return length / (line.k * state_.unit);
  }
  if (state_.mode == FeedMode::InverseTime && std::isnan(line.f))
    refuse(line, "G93 needs an F word on every G1.");
  if (!(state_.feed > 0.0)) refuse(line, "no feed has been given.");
  const double minutes =
      state_.mode == FeedMode::InverseTime ? 1.0 / state_.feed : length / state_.feed;
  return minutes * 60.0 * state_.running_speed;
}

void Reader::move(const Line& line) {
  if (state_.motion == Motion::None) refuse(line, "no G0, G1 or G33 is in force.");
  const bool was_known = state_.known_position();
  Vec3 end = state_.at;
  for (int i = 0; i < 3; ++i)
    if (!std::isnan(line.axis[i])) {
      end[i] = line.axis[i] * state_.unit;
      state_.known[i] = true;
    }
  const double length = (end - state_.at).norm();
  const double turns = turns_of(line, length);
  if (length == 0.0 && was_known) return;
  const bool timed = was_known && state_.running_speed > 0.0;
  append(end, timed ? turns : kUnknownTurns,
         state_.motion == Motion::Rapid ? MoveKind::Rapid : MoveKind::Cut, line.number);
  if (!was_known) ++section_.unplaced;
}

void Reader::dwell(const Line& line) {
  if (std::isnan(line.p)) refuse(line, "G4 needs a P word.");
  const bool turning = state_.running_speed > 0.0;
  append(state_.at, turning ? line.p * state_.running_speed : kUnknownTurns, MoveKind::Link,
         line.number);
}

void Reader::append(const Vec3& end, double turns, MoveKind kind, long line) {
  const Spindle spindle{state_.running_speed, state_.sense};
  ToolPath& path = section_.path;
  const bool same = path.spindle.speed == spindle.speed && path.spindle.sense == spindle.sense &&
                    section_.tool_number == state_.tool_number;
  if (!same || path.moves.empty()) {
    close_section();
    section_.tool_number = state_.tool_number;
    path = ToolPath{tool_, spindle, {state_.at, Vec3::UnitZ()}, {}};
  }
  path.moves.push_back({{end, Vec3::UnitZ()}, turns, kNoDimple, kind});
  section_.lines.push_back(line);
  state_.at = end;
}

void Reader::close_section() {
  if (!section_.path.moves.empty()) program_.sections.push_back(std::move(section_));
  section_ = ProgramSection();
}

}  // namespace

Program read_gcode(std::string_view text, const BallEndMill& tool) {
  Reader reader(tool);
  long number = 0;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    reader.read(text.substr(0, end), ++number);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  }
  return reader.take();
}

PlanMatch match_plan(ToolPath& read, const ToolPath& plan, double tolerance) {
  PlanMatch match;
  match.complete = true;
  std::size_t r = 0;
  for (const Move& planned : plan.moves) {
    if (planned.kind == MoveKind::Rapid) continue;
    if (!match.complete) {
      ++match.lost_moves;
      continue;
    }
    // the next timed move of the text that ends where the planned one does
    std::int64_t passed = 0;
    for (; r < read.moves.size(); ++r) {
      const Move& move = read.moves[r];
      if (move.kind == MoveKind::Rapid) continue;
      if ((move.end.tip - planned.end.tip).norm() <= tolerance) break;
      ++passed;
    }
    match.extra_moves += passed;
    if (r == read.moves.size()) {
      match.complete = false;
      ++match.lost_moves;
      continue;
    }
    Move& move = read.moves[r++];
    move.kind = planned.kind;
    move.dimple = planned.dimple;
    match.largest_miss = std::max(match.largest_miss, (move.end.tip - planned.end.tip).norm());
    if (planned.dimple != kNoDimple) ++match.found;
  }
  for (; r < read.moves.size(); ++r)
    if (read.moves[r].kind != MoveKind::Rapid) ++match.extra_moves;
  return match;
}

}  // namespace patchmill

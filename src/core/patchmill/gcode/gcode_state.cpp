// Words of G-code blocks; see gcode_state.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/gcode_state.h"

#include <algorithm>

#include <fmt/format.h>

namespace patchmill::gcode {
namespace {

class BlockReader {
 public:
  BlockReader(const ReadOptions& options, GcodeState& state, GcodeBlock& block)
      : options_(options), state_(state), block_(block) {}
  void word(const GcodeWord& w);
  void finish();

 private:
  void g_code(int tenths);
  void state_code(int tenths);
  void m_code(int code);
  void coordinate(const GcodeWord& w);
  void speed(double rpm);
  void feed_mode(FeedMode mode);
  void offset(const std::string& name);
  const ReadOptions& options_;
  GcodeState& state_;
  GcodeBlock& block_;
  int offset_ = 0;  // G word in tenths whose P counts
};

void BlockReader::word(const GcodeWord& w) {
  if ((w.letter == 'F' || w.letter == 'S' || w.letter == 'T') && w.value < 0.0)
    refuse_block(block_, fmt::format("{} is less than zero.", w.letter));
  switch (w.letter) {
    case 'G':
      return g_code(static_cast<int>(std::lround(w.value * 10.0)));
    case 'M':
      return m_code(static_cast<int>(std::lround(w.value)));
    case 'F':
      block_.f = w.value;
      return;
    case 'P':
      block_.p = w.value;
      return;
    case 'Q':
      block_.q = w.value;
      return;
    case 'R':
      block_.r = w.value;
      return;
    case 'L':
      block_.l = w.value;
      return;
    case 'S':
      return speed(w.value);
    case 'T':
      if (w.value != std::round(w.value) || w.value > 1e6)
        refuse_block(block_, "T is no tool's number.");
      state_.selected_tool = static_cast<int>(w.value);
      return;
    case 'H':
    case 'E':
      return;  // an offset by its number, an output: no effect on the programmed path
    default:
      return coordinate(w);
  }
}

void BlockReader::coordinate(const GcodeWord& w) {
  switch (w.letter) {
    case 'X':
    case 'Y':
    case 'Z':
      block_.axis[w.letter - 'X'] = w.value;
      return;
    case 'A':
    case 'B':
    case 'C':
      if (options_.rotary)
        block_.angle[w.letter - 'A'] = w.value;
      else if (w.value != 0.0)
        refuse_block(block_, "a rotary axis moves: reading it needs a machine file.");
      return;
    case 'I':
    case 'J':
    case 'K':
      block_.lead[w.letter - 'I'] = w.value;
      return;
    default:
      refuse_block(block_, fmt::format("the word {} is not read here.", w.letter));
  }
}

void BlockReader::speed(double rpm) {
  state_.speed = rpm / 60.0;
  if (state_.running_speed > 0.0) state_.running_speed = state_.speed;
}

void BlockReader::feed_mode(FeedMode mode) {
  if (mode == state_.mode) return;
  state_.mode = mode;
  state_.feed = 0.0;  // F must be given again
}

void BlockReader::offset(const std::string& name) {
  block_.offset = block_.offset || name != state_.offset;
  state_.offset = name;
}

void BlockReader::g_code(int tenths) {
  switch (tenths) {
    case 0:
      state_.motion = MotionMode::Rapid;
      return;
    case 10:
      state_.motion = MotionMode::Feed;
      return;
    case 20:
      state_.motion = MotionMode::Clockwise;
      return;
    case 30:
      state_.motion = MotionMode::Counter;
      return;
    case 330:
      state_.motion = MotionMode::Synchronised;
      return;
    case 730:
    case 810:
    case 820:
    case 830:
    case 850:
    case 890:
      if (state_.motion != MotionMode::Cycle) {
        state_.cycle.initial = state_.at.z();
        state_.cycle_bottom = state_.cycle_retract = false;
        state_.cycle.seconds = state_.cycle.peck = 0.0;
      }
      state_.motion = MotionMode::Cycle;
      state_.cycle.code = tenths;
      return;
    case 800:
      state_.motion = MotionMode::None;
      return;
    case 40:
      block_.dwell = true;
      return;
    case 530:
      block_.machine = true;
      return;
    case 280:
    case 300:
      block_.reference = true;
      return;
    default:
      return state_code(tenths);
  }
}

void BlockReader::state_code(int tenths) {
  if (tenths >= 540 && tenths <= 593 && tenths != 541) return offset(code_text('G', tenths));
  switch (tenths) {
    case 541:  // of many, by P
    case 920:  // a shift of the work's zero
      offset_ = tenths;
      return;
    case 170:
    case 180:
    case 190:
      state_.plane = tenths == 170 ? ArcPlane::XY : tenths == 180 ? ArcPlane::ZX : ArcPlane::YZ;
      return;
    case 200:
    case 210:
      state_.unit = tenths == 200 ? 25.4 : 1.0;
      return;
    case 900:
    case 910:
      state_.relative = tenths == 910;
      return;
    case 901:
    case 911:
      state_.absolute_centre = tenths == 901;
      return;
    case 930:
      return feed_mode(FeedMode::InverseTime);
    case 940:
      return feed_mode(FeedMode::PerMinute);
    case 434:  // tool-centre-point control
      state_.tcp = true;
      return;
    case 490:
      state_.tcp = false;
      return;
    case 980:
    case 990:
      state_.cycle.to_initial = tenths == 980;
      return;
    case 51:   // look-ahead
    case 400:  // no radius compensation
    case 430:  // tool length compensation: the programmed point is the tip
    case 610:  // path mode: how corners are rounded is the motion model's affair
    case 611:
    case 640:
      return;
    default:
      refuse_block(block_, code_text('G', tenths) + " is not read.");
  }
}

void BlockReader::m_code(int code) {
  const std::string text = fmt::format("M{}", code);
  if (code == 428 || text == options_.tcp_on) state_.tcp = true;
  if (code == 429 || text == options_.tcp_off) state_.tcp = false;
  if (code == 3 || code == 4) {
    state_.sense = code == 3 ? SpindleSense::M3 : SpindleSense::M4;
    state_.running_speed = state_.speed;
  }
  if (code == 6) state_.tool_number = state_.selected_tool;
  if (code == 5 || code == 6 || code == 19)
    state_.running_speed =
        0.0;  // a tool change stops the spindle, and so does turning it to an angle
}

void BlockReader::finish() {
  if (offset_ == 541) {
    if (std::isnan(block_.p)) refuse_block(block_, "the number of the work offset is missing.");
    offset(fmt::format("G54.1 P{:g}", block_.p));
  }
  if (offset_ == 920) {
    offset(state_.offset + " shifted by line " + std::to_string(block_.number));
    block_.axis[0] = block_.axis[1] = block_.axis[2] = kUnknownTurns;
  }
  const bool lead = state_.motion == MotionMode::Synchronised;
  const bool lead_is_f = options_.control->can.lead == LeadRule::LongestAxis &&
                         options_.control->can.lead_letters == "F";
  if (std::isnan(block_.f) || (lead && lead_is_f)) return;
  if (lead && block_.moves()) refuse_block(block_, "a block of G33 has no F.");
  state_.feed = block_.f * (state_.mode == FeedMode::PerMinute ? state_.unit : 1.0);
}

// G33's lead along the path. Where it is told along the axis that moves most, the path's is longer.
double lead_of(const GcodeBlock& block, const GcodeState& state, const Control& control,
               const Vec3& way) {
  Eigen::Index most = 0;
  const double longest = way.cwiseAbs().maxCoeff(&most);
  const bool along_path = control.can.lead == LeadRule::AlongPath;
  const double lead = along_path                            ? block.lead[2]
                      : control.can.lead_letters.size() > 1 ? block.lead[most]
                                                            : block.f;
  if (std::count_if(block.lead, block.lead + 3, [](double one) { return !std::isnan(one); }) > 1)
    refuse_block(block, "G33 has more than one lead.");
  if (!(lead > 0.0))
    refuse_block(block,
                 fmt::format("G33 needs a lead ({}) greater than zero.", control.can.lead_letters));
  return lead * state.unit * (along_path || longest == 0.0 ? 1.0 : way.norm() / longest);
}

}  // namespace

double block_turns(const GcodeBlock& block, const GcodeState& state, const Control& control,
                   const Vec3& way, double length, double turned) {
  if (state.motion == MotionMode::Rapid) return kUnknownTurns;
  if (state.motion == MotionMode::Synchronised) return length / lead_of(block, state, control, way);
  if (state.mode == FeedMode::InverseTime && std::isnan(block.f))
    refuse_block(block, "G93 needs an F word on every G1.");
  if (!(state.feed > 0.0)) refuse_block(block, "no feed has been given.");
  // F is of X Y Z if one of them moves, else degrees a minute
  const double minutes = state.mode == FeedMode::InverseTime ? 1.0 / state.feed
                         : length > 0.0                      ? length / state.feed
                                                             : turned * state.unit / state.feed;
  return minutes * 60.0 * state.running_speed;
}

GcodeBlock read_block(std::string_view text, long number, const ReadOptions& options,
                      GcodeState& state) {
  GcodeBlock block;
  block.text = text;
  block.number = number;
  BlockReader reader(options, state, block);
  const std::vector<GcodeWord> words = options.control->read(*options.control, text, number);
  const auto early = [](const GcodeWord& w) {  // S and T come before M3 and M6, wherever they stand
    return w.letter == 'S' || w.letter == 'T';
  };
  for (const GcodeWord& w : words)
    if (early(w)) reader.word(w);
  for (const GcodeWord& w : words)
    if (!early(w)) reader.word(w);
  reader.finish();
  const bool codes = std::any_of(words.begin(), words.end(), [](const GcodeWord& w) {
    return w.letter == 'G' || w.letter == 'M';
  });
  if (!codes && state.motion != MotionMode::Cycle &&
      !(std::isnan(block.p) && std::isnan(block.q) && std::isnan(block.l)))
    refuse_block(block, "P, Q and L belong to no word of the block.");
  return block;
}

}  // namespace patchmill::gcode

// Words of G-code blocks; see gcode_state.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/machine/gcode_state.h"

#include <fmt/format.h>

namespace patchmill {
namespace {

class BlockReader {
 public:
  BlockReader(const ReadOptions& options, GcodeState& state, GcodeBlock& block)
      : options_(options), state_(state), block_(block) {}
  void word(const GcodeWord& w);

 private:
  void g_code(int tenths);
  void m_code(int code);
  const ReadOptions& options_;
  GcodeState& state_;
  GcodeBlock& block_;
};

void BlockReader::word(const GcodeWord& w) {
  switch (w.letter) {
    case 'G':
      return g_code(static_cast<int>(std::lround(w.value * 10.0)));
    case 'M':
      return m_code(static_cast<int>(std::lround(w.value)));
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
    case 'F':
      block_.f = w.value;
      return;
    case 'I':
    case 'J':
    case 'K':
      block_.lead[w.letter - 'I'] = w.value;
      return;
    case 'P':
      block_.p = w.value;
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
      refuse_block(block_, fmt::format("the word {} is not read here.", w.letter));
  }
}

void BlockReader::g_code(int tenths) {
  switch (tenths) {
    case 0:
      state_.motion = MotionMode::Rapid;
      return;
    case 10:
      state_.motion = MotionMode::Feed;
      return;
    case 330:
      state_.motion = MotionMode::Synchronised;
      return;
    case 40:
      block_.dwell = true;
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
      state_.motion = MotionMode::None;
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
      refuse_block(block_,
                   fmt::format("G{:g} is not read: arcs, cycles and relative moves are not part of "
                               "a texture program.",
                               tenths / 10.0));
  }
}

void BlockReader::m_code(int code) {
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
      refuse_block(block_, fmt::format("M{} is not read here.", code));
  }
}

// G33's lead along the path. Where it is told along the axis that moves most, the path's is longer.
double lead_of(const GcodeBlock& block, const GcodeState& state, Dialect dialect, const Vec3& way) {
  Eigen::Index most = 0;
  const double longest = way.cwiseAbs().maxCoeff(&most);
  double lead = block.lead[2];
  if (dialect == Dialect::Fanuc) lead = block.f;
  if (dialect == Dialect::Siemens) lead = block.lead[most];
  if (!(lead > 0.0))
    refuse_block(block,
                 fmt::format("G33 needs a lead ({}) greater than zero.", lead_letters(dialect)));
  return lead * state.unit *
         (dialect == Dialect::LinuxCnc || longest == 0.0 ? 1.0 : way.norm() / longest);
}

}  // namespace

double block_turns(const GcodeBlock& block, const GcodeState& state, Dialect dialect,
                   const Vec3& way, double turned) {
  if (state.motion == MotionMode::Rapid) return kUnknownTurns;
  const double length = way.norm();
  if (state.motion == MotionMode::Synchronised) return length / lead_of(block, state, dialect, way);
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
  const std::vector<GcodeWord> words = dialect_words(options.dialect, text, number);
  for (const GcodeWord& w : words)  // S comes before M3 in a block's order of execution
    if (w.letter == 'S') reader.word(w);
  for (const GcodeWord& w : words)
    if (w.letter != 'S') reader.word(w);
  const bool is_lead =
      state.motion == MotionMode::Synchronised && options.dialect == Dialect::Fanuc;
  if (!std::isnan(block.f) && !is_lead)
    state.feed = block.f * (state.mode == FeedMode::PerMinute ? state.unit : 1.0);
  return block;
}

void refuse_block(const GcodeBlock& block, const std::string& why) {
  refuse_gcode(block.number, std::string(block.text), why);
}

}  // namespace patchmill

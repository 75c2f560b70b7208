// ToolPath as a program in the RS-274 dialect of LinuxCNC, with the words that a timed path needs:
//     G33 X Y Z K    spindle-locked, K mm per turn
//     G1 X Y Z F     feed-paced, mm/min; or G93 G1 F with F = 1 / (duration in minutes)
//     G61 / G64 P Q0 exact stop / rounding within P, no merging of moves
// G61 and G64 between G33 moves keep the lock; any other motion ends it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/machine/corner_blend.h"
#include "patchmill/machine/kinematics.h"
#include "patchmill/path/rounding.h"

#include <string>

namespace patchmill::gcode {

enum class FeedWord : std::uint8_t {
  PerMinute,   ///< G94
  InverseTime  ///< G93
};

/// Angles to be written beside a path's points: joints[0] at its start, joints[i + 1] at the end of move
/// i. The path is one of programmed points (programmed_path.h). No letters: no rotary words.
struct RotaryWords {
  std::string letters;                  ///< of the rotary axes in chain order
  std::vector<machine::Joints> joints;  ///< [rad], on the decimals in degrees
  /// No path mode is written for moves that leave it to the machine: its own smoothing is in force.
  bool as_set = false;
};

/// The text of a path, and which of its lines are moves.
struct Rs274Text {
  std::string text;
  std::vector<long> lines;  ///< line (from 1) of each move; a move of no length has the one before
};

/// The program, from "G21" to "M2". Coordinates are rounded to `decimals` (a path that is on them
/// keeps its lengths); K, with 6 decimals, carries its rounding on from move to move. A feed-paced move
/// on which a rotary axis turns is written in inverse time. Errors: as locked_pitches; InputError naming
/// Turns if a feed-paced move has none, ToolAxis if only rotary axes move in a locked one.
Rs274Text rs274_text(const ToolPath& path, const machine::MotionModel& model,
                     const Decimals& decimals, FeedWord feed = FeedWord::PerMinute,
                     const RotaryWords& rotary = {});

/// A rapid to the start and the moves, with their G61, G64 and G33 words, as text for FreeCAD's
/// Path.Path(text), whose F is mm/s (in inverse time 1/s, for posts multiply every F by 60). Errors: as
/// rs274_text.
std::string freecad_paced_text(const ToolPath& path, const machine::MotionModel& model,
                               const Decimals& decimals, FeedWord feed = FeedWord::PerMinute,
                               const RotaryWords& rotary = {});

}  // namespace patchmill::gcode

// From posted G-code back to ToolPath, so that a claim about a program is a claim about the text
// that the machine gets. Reads whole programs of the controls of controls/control.h, as strictly as these do:
// straight moves, arcs and drilling cycles, relative and machine coordinates, work offsets, dwells.
//     G94: t = length / F        G93: t = 1 / F min        G33: turns = length / K
// and spindle turns = t S. A word that is not known is refused, never skipped.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/gcode/controls/control.h"
#include "patchmill/path/tool_path.h"

#include <array>
#include <string_view>

namespace patchmill::gcode {

/// A stretch of a program with one tool, spindle speed, sense and work offset, without a move in machine coordinates.
struct ProgramSection {
  int tool_number = 0;
  std::string offset;       ///< "G55", "G54.1 P3", "preset 2"; "" while the program has named none
  ToolPath path;            ///< tool: radius as given, axis +Z; dimple numbers are unset
  std::vector<long> lines;  ///< line of the text (from 1) that made each move
  /// F in force in each move: mm/min, or 1/min where `inverse`; NaN for rapids, dwells and G33, which have none.
  std::vector<double> feeds;
  std::vector<bool> inverse;  ///< whether G93 was in force in each move
  std::int64_t unplaced = 0;  ///< moves at the beginning that start nobody knows where
  /// A, B and C at the start and at the end of each move [rad]; empty if rotary words are refused.
  std::vector<std::array<double, 3>> angles;
  std::vector<bool> tcp;  ///< whether TCP was on in each move; empty if rotary words are refused
};

/// How a program is read.
struct ReadOptions {
  const Control* control = &linuxcnc();
  /// Rotary words are read: the path's points are then the programmed ones, and its axes are not set
  /// (see programmed_path.h for what they mean in the work).
  bool rotary = false;
  std::string tcp_on = {},
              tcp_off = {};  ///< M words of the machine for TCP beside the control's own
};

/// What was read of a program.
struct Program {
  std::vector<ProgramSection> sections;  ///< those with moves
};

/// Reads `text` as options say. G1 moves are MoveKind::Cut (the text does not tell links apart, see match_plan),
/// G0 moves Rapid with unknown turns; so are timed moves while the spindle stands, and moves whose
/// feed was never given are refused. Arcs are lines that leave them by 1 um at most, cycles the moves that they
/// mean. Blocks that move nothing and take no time are no moves. The position counts as known once X, Y and Z were
/// all given, and no more after a move in machine coordinates or to the reference, or with another work offset;
/// moves before that have unknown turns. Errors: InputError "G-code line n" for anything not understood: rotary
/// words other than 0 unless they are to be read, variables, words that the control does not have or that may not
/// stand together.
Program read_gcode(std::string_view text, const Tool& tool, const ReadOptions& options = {});

/// A line of a program that has words.
struct ProgramLine {
  long number = 0;               ///< of the line, from 1
  std::vector<GcodeWord> words;  ///< in the common tongue of controls/control.h
};

/// The words of every line, each as strictly read as by read_gcode, but without what they mean together. Errors:
/// InputError "G-code line n".
std::vector<ProgramLine> program_lines(std::string_view text, const Control& control);

/// How a program that was read compares with its plan.
struct PlanMatch {
  bool complete = false;         ///< every timed move of the plan was found, in order
  std::int64_t found = 0;        ///< dimples found before the first move that was not
  double largest_miss = 0.0;     ///< distance of a found move's end from the planned one [mm]
  std::int64_t extra_moves = 0;  ///< timed moves of the text that the plan does not have
  std::int64_t lost_moves = 0;   ///< timed moves of the plan from the first one that the text lacks
};

/// Gives the moves of `read` the kinds and dimple numbers of `plan`, by going through both in order
/// and pairing moves whose ends are within `tolerance` [mm]. Errors: InputError naming Tolerance (0 .. 1e6).
PlanMatch match_plan(ToolPath& read, const ToolPath& plan, double tolerance);

}  // namespace patchmill::gcode

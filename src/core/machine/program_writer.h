// Programs in the dialects of dialect.h, from the text of FreeCAD's paths (Path.toGCode(), F in mm/s and
// 1/s under G93). One writer for all; what differs is a table of words and how a move is put down. The
// post-processors patchmill_*_post.py are what FreeCAD sees of it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "core/machine/dialect.h"

namespace patchmill {

struct ProgramStyle {
  Dialect dialect = Dialect::LinuxCnc;
  int precision = 3;          ///< decimals of X Y Z A B C, 0 .. 6
  bool line_numbers = false;  ///< N words; Heidenhain's blocks are always numbered
  bool comments = true;
  bool modal = false;  ///< a G word that is in force is not repeated (Fanuc, Siemens, LinuxCNC)
  bool axis_modal = false;               ///< nor are words of axes that stay where they are
  bool tool_length = true;               ///< G43 H after a tool change, where the control wants it
  std::string name = "PATCHMILL";        ///< of the program: Heidenhain, Siemens
  int number = 1;                        ///< O word of Fanuc
  std::vector<std::string> header = {};  ///< comments at the top
  std::string preamble, postamble;       ///< lines; empty: the dialect's own
  std::string smoothing_on, smoothing_off;  ///< after TCP is on, before it goes off
};

/// The program of the operations' internal texts, in order. Errors: InputError naming
/// PostProcessorArgs (precision), Strategy (a spindle-locked move where the dialect has none, or one
/// on which a rotary axis turns where it cannot), Path (a command that the dialect cannot say).
std::string write_program(const std::vector<std::string>& texts, const ProgramStyle& style);

}  // namespace patchmill

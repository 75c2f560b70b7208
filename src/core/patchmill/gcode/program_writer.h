// Programs for the controls of controls/control.h, from the text of FreeCAD's paths (Path.toGCode(), F in mm/s and
// 1/s under G93). One writer for all; what differs is in the control. No word of a path is dropped: it is in the
// program, or the path is refused. The post-processors patchmill_*_post.py are what FreeCAD sees of it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/gcode/controls/control.h"
#include "patchmill/geometry/vec.h"

#include <optional>
#include <utility>

namespace patchmill::gcode {

/// How a program is written.
struct ProgramStyle {
  const Control* control = &linuxcnc();
  int precision = 3;          ///< decimals of X Y Z A B C, 0 .. 6
  bool line_numbers = false;  ///< N words; Heidenhain's blocks are always numbered
  bool comments = true;
  bool modal = false;  ///< a G word that is in force is not repeated (where blocks are of words)
  bool axis_modal = false;               ///< nor are words of axes that stay where they are
  bool tool_length = true;               ///< G43 H after a tool change, where the control wants it
  std::string name = "PATCHMILL";        ///< of the program: Heidenhain, Fanuc
  int number = 1;                        ///< O word of Fanuc, 1 .. 9999
  std::vector<std::string> header = {};  ///< comments at the top
  std::string preamble, postamble;       ///< lines; empty: the control's own
  std::string smoothing_on, smoothing_off;  ///< after TCP is on, before it goes off
  std::string tcp_on, tcp_off;  ///< the machine's words for TCP; empty: the control's own
  /// Axes and machine coordinates [mm] that the tool goes to before a tool change, before rotary axes turn alone and at
  /// the end, in order.
  std::vector<std::pair<char, double>> retract = {};
  /// For each text whether it is an operation of ours, after which the path mode is again as before; empty: all.
  std::vector<bool> own = {};
  std::optional<std::pair<Vec3, Vec3>> stock = {};  ///< lowest and highest corner [mm]: BLK FORM
};

/// The program of the operations' internal texts, in order. Between operations relative coordinates, inverse time and
/// TCP end, the path mode becomes that of the preamble, and rotary axes that the next one does not move go back to
/// zero. Errors: InputError naming PostProcessorArgs (precision, number), Strategy (a spindle-locked move where the
/// control has none, or one on which a rotary axis turns where it cannot), ProgramForm (TCP where there is none),
/// Machine (rotary axes are to go back to zero, and no retract is given), Path (a word that the control does not
/// have).
std::string write_program(const std::vector<std::string>& texts, const ProgramStyle& style);

}  // namespace patchmill::gcode

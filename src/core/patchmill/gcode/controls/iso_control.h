// What the controls have in common whose programs lie between two % signs and begin with an O number, as Fanuc's do
// and those of makers that follow it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/gcode/controls/control.h"
#include "patchmill/gcode/gcode_words.h"

#include <string_view>
#include <vector>

namespace patchmill::gcode {

/// A control with their texts, TCP ended by G49, lengths that need a decimal point, and their plain characters of
/// comments; without a name, words, a reader and the texts of TCP's beginning.
Control iso_control();

/// Their words for units, the reference point, tool length, path mode and absolute arcs, and that of a rigid spindle.
std::vector<CodeWord> iso_words();

/// Words of a block; of a line that begins with the program's number those after it. Errors: InputError of
/// refuse_gcode for an O without a number, and those of read_words.
std::vector<GcodeWord> read_iso_words(const Control& control, std::string_view line, long number);

}  // namespace patchmill::gcode

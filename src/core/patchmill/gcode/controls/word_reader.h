// Reading blocks of G, M and other letters as strictly as the controls do: a word that the control does not have,
// a letter or modal group that comes twice, a letter that belongs to no word of its block and a number that is
// none are refused.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/gcode/controls/control.h"

namespace patchmill::gcode {

/// The block's words in the common tongue: a WordReader. Letters without a G or M word belong to the motion in
/// force. Errors: InputError "G-code line n".
std::vector<GcodeWord> read_words(const Control& control, std::string_view line, long number);

/// Checks words that are already split and gives them the common tongue's numbers.
std::vector<GcodeWord> in_common_tongue(const Control& control, std::string_view line, long number,
                                        std::vector<GcodeWord> words);

/// `text` without blanks at both ends.
std::string_view trimmed(std::string_view text);

/// The plain decimal number that is all of `text`, with a sign at most. Errors: InputError "G-code line n".
double whole_number_text(std::string_view text, std::string_view line, long number);

/// A code's number in tenths: 43.4 -> 434. Errors: InputError "G-code line n" for anything finer or beyond 9999.
int code_tenths(const GcodeWord& word, std::string_view line, long number);

}  // namespace patchmill::gcode

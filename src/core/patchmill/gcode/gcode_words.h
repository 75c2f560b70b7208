// One line of G-code split into words. RS-274: a letter and a number, blanks allowed anywhere
// between them; comments in parentheses or after a semicolon.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace patchmill::gcode {

/// A letter and its number.
struct GcodeWord {
  char letter = 0;  ///< upper case
  double value = 0.0;
  bool point = false;  ///< written with a decimal point
};

/// The words of a line without its line number (N), comments, blanks and a '%' that is all of it.
/// Errors: InputError "G-code line <number>" on anything else: expressions, variables, block
/// delete, O-words, an unclosed comment, a number that is none or beyond 1e12.
std::vector<GcodeWord> gcode_words(std::string_view line, long number);

/// The error that readers throw about a line of a program.
[[noreturn]] void refuse_gcode(long line, const std::string& text, const std::string& remedy);

}  // namespace patchmill::gcode

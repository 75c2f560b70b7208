// The words that all RS-274 controls share, for the tables of the controls' files.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/gcode/controls/control.h"

namespace patchmill::gcode {

constexpr std::string_view kMoveLetters = "XYZABCF";
constexpr std::string_view kArcLetters = "XYZIJKRF";
constexpr std::string_view kCentreLetters = "XYZIJKF";  ///< of controls whose R is something else
/// Letters of a drilling cycle, G word in tenths: a peck has Q, a dwell P.
constexpr std::string_view cycle_letters(int tenths) {
  const bool pecks = tenths == 730 || tenths == 830, waits = tenths == 820 || tenths == 890;
  return pecks ? "XYZRQLF" : waits ? "XYZRPLF" : "XYZRLF";
}

/// `own` and `more` in one table.
inline std::vector<CodeWord> with(std::vector<CodeWord> own, const std::vector<CodeWord>& more) {
  own.insert(own.end(), more.begin(), more.end());
  return own;
}

/// A word whose number means the same in the common tongue; `tenths` of it.
inline CodeWord same(char letter, int tenths, WordGroup group, std::string_view takes = "") {
  return {letter, tenths, tenths, group, takes};
}

/// G0 to G4, planes, G40, G53, G90 to G94, and the M words of every control: stops, spindle, coolant.
std::vector<CodeWord> shared_words(std::string_view move_letters = kMoveLetters,
                                   std::string_view arc_letters = kArcLetters);

/// G54 to G59.
std::vector<CodeWord> work_offsets();

/// G73, G81 to G83, G85, G89 with G98, G99, and G80.
std::vector<CodeWord> drilling_cycles();

/// A control's table; blocks of numbers alone may have the letters that its motions and cycles take, and F, S, T.
void give_words(Control& control, std::vector<CodeWord> codes);

/// Why a word that a control may have is not posted for it, and what to do instead.
std::string_view why_not_posted(char letter, int tenths);

}  // namespace patchmill::gcode

// Sets of word letters A to Z, a bit each.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <string_view>

namespace patchmill::gcode {

using LetterSet = std::uint32_t;

/// The set of one letter, A to Z.
constexpr LetterSet letter_set(char letter) {
  return LetterSet{1} << (letter - 'A');
}

/// The set of the letters of a text.
constexpr LetterSet letter_set(std::string_view letters) {
  LetterSet set = 0;
  for (const char letter : letters) set |= letter_set(letter);
  return set;
}

/// The first letter of a set that is not empty.
constexpr char first_letter(LetterSet set) {
  char letter = 'A';
  while ((set & letter_set(letter)) == 0) ++letter;
  return letter;
}

}  // namespace patchmill::gcode

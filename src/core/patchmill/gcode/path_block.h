// One block of the text of FreeCAD's paths (Path.toGCode(): mm, degrees, F in mm/s or 1/s), split into its
// words: what program_writer.cpp puts down in a control's own.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/gcode/controls/letter_set.h"

#include <array>
#include <cstddef>
#include <string>

namespace patchmill::gcode {

/// A G or M word of a block; its number in tenths: G43.4 is 434.
struct BlockCode {
  char letter = 'G';
  int tenths = 0;
};

/// The words of one line of a path.
struct PathBlock {
  static constexpr std::size_t kMostCodes = 8;
  std::string_view text;  ///< as it stands, for messages; belongs to whoever gave it
  std::array<BlockCode, kMostCodes + 1> codes{};  ///< its G and M words in their order
  std::size_t count = 0;                          ///< how many there are
  std::array<double, 26> value{};
  LetterSet letters = 0;  ///< those that have a value
  /// Whether a letter, A to Z, has a value.
  bool gives(char letter) const { return (letters & letter_set(letter)) != 0; }
  /// Its value; 0 if it has none.
  double get(char letter) const { return value[static_cast<std::size_t>(letter - 'A')]; }
  /// Whether a G or M word is among its codes.
  bool code(char letter, int tenths) const {
    for (std::size_t i = 0; i < count; ++i)
      if (codes[i].letter == letter && codes[i].tenths == tenths) return true;
    return false;
  }
};

/// The words of line `number` of a path's text. Errors: as gcode_words; InputError naming Path if a letter stands
/// twice, or there are more than kMostCodes G and M words.
PathBlock path_block(std::string_view text, long number);

/// Throws InputError naming Path and the block; `remedy` is a whole sentence.
[[noreturn]] void refuse_block(const PathBlock& block, const std::string& remedy);

}  // namespace patchmill::gcode

// One block of the text of FreeCAD's paths (Path.toGCode(): mm, degrees, F in mm/s or 1/s), split into its
// words: what program_writer.cpp puts down in a control's dialect.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace patchmill {

struct PathBlock {
  std::string_view text;  ///< as it stands, for messages; belongs to whoever gave it
  int g = -1;             ///< the last G word in tenths (G43.4 is 434); -1: none
  int m = -1;             ///< the last M word; -1: none
  std::array<double, 26> value{};
  std::array<bool, 26> has{};
  bool gives(char letter) const { return has[static_cast<std::size_t>(letter - 'A')]; }
  double get(char letter) const { return value[static_cast<std::size_t>(letter - 'A')]; }
};

/// The words of line `number` of a path's text. Errors: as gcode_words.
PathBlock path_block(std::string_view text, long number);

/// Throws InputError naming Path and the block; `remedy` is a whole sentence.
[[noreturn]] void refuse_block(const PathBlock& block, const std::string& remedy);

}  // namespace patchmill

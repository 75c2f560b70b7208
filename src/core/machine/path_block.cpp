// Blocks of FreeCAD's paths; see path_block.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/machine/path_block.h"

#include "core/geometry/error.h"
#include "core/machine/gcode_words.h"

namespace patchmill {

PathBlock path_block(std::string_view text, long number) {
  PathBlock block;
  block.text = text;
  for (const GcodeWord& w : gcode_words(text, number)) {
    if (w.letter == 'G')
      block.g = static_cast<int>(w.value * 10.0 + 0.5);
    else if (w.letter == 'M')
      block.m = static_cast<int>(w.value + 0.5);
    block.value[static_cast<std::size_t>(w.letter - 'A')] = w.value;
    block.has[static_cast<std::size_t>(w.letter - 'A')] = true;
  }
  return block;
}

void refuse_block(const PathBlock& block, const std::string& remedy) {
  throw InputError("Path", "'" + std::string(block.text) + "'", remedy);
}

}  // namespace patchmill

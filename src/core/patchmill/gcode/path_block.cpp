// Blocks of FreeCAD's paths; see path_block.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/path_block.h"

#include "patchmill/gcode/controls/word_reader.h"
#include "patchmill/geometry/error.h"

#include <fmt/format.h>

namespace patchmill::gcode {

PathBlock path_block(std::string_view text, long number) {
  PathBlock block;
  block.text = text;
  for (const GcodeWord& w : gcode_words(text, number)) {
    if (w.letter == 'G' || w.letter == 'M') {
      if (block.count == PathBlock::kMostCodes)
        refuse_block(block, "there are too many words in the block: divide it.");
      block.codes[block.count++] = {w.letter, code_tenths(w, text, number)};
      continue;
    }
    if (block.gives(w.letter)) refuse_block(block, fmt::format("{} stands twice.", w.letter));
    block.value[static_cast<std::size_t>(w.letter - 'A')] = w.value;
    block.letters |= letter_set(w.letter);
  }
  return block;
}

void refuse_block(const PathBlock& block, const std::string& remedy) {
  throw InputError("Path", "'" + std::string(block.text) + "'", remedy);
}

}  // namespace patchmill::gcode

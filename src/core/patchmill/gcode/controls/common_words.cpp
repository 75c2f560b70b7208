// Shared words; see common_words.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/controls/common_words.h"

namespace patchmill::gcode {

std::vector<CodeWord> shared_words(std::string_view move_letters) {
  using G = WordGroup;
  return {same('G', 0, G::Motion, move_letters),
          same('G', 10, G::Motion, move_letters),
          same('G', 20, G::Motion, kArcLetters),
          same('G', 30, G::Motion, kArcLetters),
          same('G', 40, G::Once, "P"),
          same('G', 170, G::Plane),
          same('G', 180, G::Plane),
          same('G', 190, G::Plane),
          same('G', 400, G::Radius),
          same('G', 530, G::None),
          same('G', 900, G::Distance),
          same('G', 910, G::Distance),
          same('G', 930, G::FeedMode),
          same('G', 940, G::FeedMode),
          same('M', 0, G::Stop),
          same('M', 10, G::Stop),
          same('M', 20, G::Stop),
          same('M', 300, G::Stop),
          same('M', 30, G::Spindle),
          same('M', 40, G::Spindle),
          same('M', 50, G::Spindle),
          same('M', 60, G::ToolChange),
          same('M', 70, G::Coolant),
          same('M', 80, G::Coolant),
          same('M', 90, G::Coolant)};
}

std::vector<CodeWord> work_offsets() {
  std::vector<CodeWord> words;
  for (int tenths = 540; tenths <= 590; tenths += 10)
    words.push_back(same('G', tenths, WordGroup::Offset));
  return words;
}

std::vector<CodeWord> drilling_cycles() {
  std::vector<CodeWord> words;
  for (const int tenths : {730, 810, 820, 830, 850, 890})
    words.push_back(same('G', tenths, WordGroup::Motion, cycle_letters(tenths)));
  words.push_back(same('G', 800, WordGroup::Motion));
  words.push_back(same('G', 980, WordGroup::Return));
  words.push_back(same('G', 990, WordGroup::Return));
  return words;
}

}  // namespace patchmill::gcode

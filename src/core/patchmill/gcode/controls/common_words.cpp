// Shared words; see common_words.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/controls/common_words.h"

#include <utility>

namespace patchmill::gcode {

std::vector<CodeWord> shared_words(std::string_view move_letters, std::string_view arc_letters) {
  using G = WordGroup;
  return {same('G', 0, G::Motion, move_letters),
          same('G', 10, G::Motion, move_letters),
          same('G', 20, G::Motion, arc_letters),
          same('G', 30, G::Motion, arc_letters),
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

void give_words(Control& control, std::vector<CodeWord> codes) {
  control.modal_letters = letter_set("FST");
  for (const CodeWord& word : codes)
    if (word.group == WordGroup::Motion) control.modal_letters |= letter_set(word.takes);
  control.codes = std::move(codes);
}

std::string_view why_not_posted(char letter, int tenths) {
  if (letter == 'M')
    return tenths == 170 || tenths == 970 || tenths == 980 || tenths == 990
               ? "programs here are of one piece: write the subprogram's lines into the operation."
               : "take it out.";
  switch (tenths / 10) {
    case 10:
    case 52:
    case 92:
      return "it shifts the work's zero: take it out, and choose a work offset in the job's setup.";
    case 15:
    case 16:
    case 50:
    case 51:
    case 68:
    case 69:
      return "it turns or scales what comes after it: take it out, and move the job's model.";
    case 31:
    case 38:
      return "it probes: take it out, and probe with a program of its own.";
    case 41:
    case 42:
      return "the operations allow for the tool's radius themselves: take it out.";
    case 65:
      return "programs here are of one piece: write the subprogram's lines into the operation.";
    case 95:
    case 96:
      return "feeds are in mm/min and speeds in turns a minute: take it out.";
    default:
      return "take it out.";
  }
}

}  // namespace patchmill::gcode

// Haas mills (next generation control), by public summaries of their G-codes, not by their manual: O number between
// two % signs, G234 H and G49 for TCP, G61 and G64 for corners, G154 P1 to P99 for further work offsets. P of a dwell
// is in seconds with a decimal point and in milliseconds without one; a length without a point is one of units of the
// last decimal. No G33: the spindle is followed in tapping only. M7 is another coolant than elsewhere (a shower), and
// is refused. G21 must be Setting 9 of the control. Tried on no control.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/controls/common_words.h"
#include "patchmill/gcode/controls/iso_control.h"
#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cmath>

namespace patchmill::gcode {
namespace {

std::vector<CodeWord> haas_words() {
  using G = WordGroup;
  std::vector<CodeWord> shared = shared_words();
  shared.erase(
      std::remove_if(shared.begin(), shared.end(),
                     [](const CodeWord& word) { return word.letter == 'M' && word.means == 70; }),
      shared.end());
  const std::vector<CodeWord> words = {{'G', 2340, 434, G::Length, "H"},
                                       {'G', 1540, 541, G::Offset, "P"},
                                       same('M', 880, G::User),
                                       same('M', 890, G::User),
                                       {'M', 960, 960, G::None, "", false, true},
                                       {'M', 970, 970, G::None, "", false, true}};
  return with(with(with(with(words, iso_words()), shared), work_offsets()), drilling_cycles());
}

bool waits(const GcodeWord& w) {
  return w.letter == 'G' && (w.value == 4.0 || w.value == 82.0 || w.value == 89.0);
}

std::vector<GcodeWord> read(const Control& control, std::string_view line, long number) {
  std::vector<GcodeWord> words = read_iso_words(control, line, number);
  if (std::none_of(words.begin(), words.end(), waits)) return words;
  for (GcodeWord& w : words)
    if (w.letter == 'P' && !w.point) w.value /= 1000.0;
  return words;
}

Control make() {
  Control c = iso_control();
  c.name = "haas";
  c.title = "Haas";
  c.comments.max_length = 80;
  c.texts.tcp_on = "G234 H{tool}";
  give_words(c, haas_words());
  c.read = &read;
  return c;
}

}  // namespace

const Control& haas();
const Control& haas() {
  static const Control control = make();
  return control;
}

}  // namespace patchmill::gcode

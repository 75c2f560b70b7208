// Haas mills (next generation control), by public summaries of their G-codes, not by their manual: O number between
// two % signs, G234 H and G49 for TCP, G61 and G64 for corners, G154 P1 to P99 for further work offsets. P of a dwell
// is in seconds with a decimal point and in milliseconds without one; a length without a point is one of units of the
// last decimal. No G33: the spindle is followed in tapping only. M7 is another coolant than elsewhere (a shower), and
// is refused. G21 must be Setting 9 of the control. Tried on no control.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/controls/common_words.h"
#include "patchmill/gcode/controls/word_reader.h"
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
  const std::vector<CodeWord> words = {same('G', 200, G::Units),
                                       same('G', 210, G::Units),
                                       same('G', 280, G::Once, "XYZABC"),
                                       same('G', 430, G::Length, "H"),
                                       {'G', 2340, 434, G::Length, "H"},
                                       same('G', 490, G::Length),
                                       {'G', 1540, 541, G::Offset, "P"},
                                       same('G', 610, G::PathMode),
                                       same('G', 640, G::PathMode),
                                       {'G', -1, 911, G::ArcDistance, "", true},
                                       same('M', 190, G::Spindle),
                                       same('M', 880, G::User),
                                       same('M', 890, G::User),
                                       {'M', 960, 960, G::None, "", false, true},
                                       {'M', 970, 970, G::None, "", false, true},
                                       {'M', 980, 980, G::None, "", false, true},
                                       {'M', 990, 990, G::None, "", false, true}};
  return with(with(with(words, shared), work_offsets()), drilling_cycles());
}

bool waits(const GcodeWord& w) {
  return w.letter == 'G' && (w.value == 4.0 || w.value == 82.0 || w.value == 89.0);
}

std::vector<GcodeWord> read(const Control& control, std::string_view line, long number) {
  const std::string_view body = trimmed(line);
  if (!body.empty() && body[0] == 'O') {  // the program's number and perhaps its name
    const std::size_t digits = body.find_first_not_of("0123456789", 1);
    if (digits == 1) refuse_gcode(number, std::string(line), "the program's number is missing.");
    return digits == std::string_view::npos ? std::vector<GcodeWord>()
                                            : gcode_words(body.substr(digits), number);
  }
  std::vector<GcodeWord> words = read_words(control, line, number);
  if (std::none_of(words.begin(), words.end(), waits)) return words;
  for (GcodeWord& w : words)
    if (w.letter == 'P' && !w.point) w.value /= 1000.0;
  return words;
}

Control make() {
  Control c;
  c.name = "haas";
  c.title = "Haas";
  c.can.tcp_off_ends_length = true;
  c.can.numbers_need_point = true;
  c.comments.max_length = 80;
  c.comments.plain = ".,:+-*/=<>'";
  c.texts.begin = "%\nO{number}\n({name})";
  c.texts.end = "%";
  c.texts.preamble = "G21\nG17 G40 G49 G80 G90 G94";
  c.texts.postamble = "M5\nG49\nM30";
  c.texts.plain_postamble = "M5\nM30";
  c.texts.tcp_on = "G234 H{tool}";
  c.texts.tcp_off = "G49";
  c.texts.rounding = "G64";
  c.texts.spindle = "S{speed} M{sense}";
  c.texts.speed = "S{speed}";
  c.texts.tool_change = "M5\nT{tool} M6";
  c.texts.preselect = "T{tool}";
  c.texts.machine_move = "G90 G53 G0 {axis}{value}";
  c.codes = haas_words();
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

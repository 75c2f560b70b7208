// Texts and words of controls with O numbers; see iso_control.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/controls/iso_control.h"

#include "patchmill/gcode/controls/common_words.h"
#include "patchmill/gcode/controls/word_reader.h"

#include <string>

namespace patchmill::gcode {

Control iso_control() {
  Control c;
  c.can.tcp_off_ends_length = true;
  c.can.numbers_need_point = true;
  c.comments.plain = ".,:+-*/=<>'";
  c.texts.begin = "%\nO{number}\n({name})";
  c.texts.end = "%";
  c.texts.preamble = "G21\nG17 G40 G49 G80 G90 G94";
  c.texts.postamble = "M5\nG49\nM30";
  c.texts.plain_postamble = "M5\nM30";
  c.texts.tcp_off = "G49";
  c.texts.rounding = "G64";
  c.texts.spindle = "S{speed} M{sense}";
  c.texts.speed = "S{speed}";
  c.texts.tool_change = "M5\nT{tool} M6";
  c.texts.preselect = "T{tool}";
  c.texts.machine_move = "G90 G53 G0 {axis}{value}";
  return c;
}

std::vector<CodeWord> iso_words() {
  using G = WordGroup;
  return {same('G', 200, G::Units),
          same('G', 210, G::Units),
          same('G', 280, G::Once, "XYZABC"),
          same('G', 430, G::Length, "H"),
          same('G', 490, G::Length),
          same('G', 610, G::PathMode),
          same('G', 640, G::PathMode),
          {'G', -1, 911, G::ArcDistance, "", true},
          same('M', 190, G::Spindle),
          {'M', 980, 980, G::None, "", false, true},
          {'M', 990, 990, G::None, "", false, true}};
}

std::vector<GcodeWord> read_iso_words(const Control& control, std::string_view line, long number) {
  const std::string_view body = trimmed(line);
  if (body.empty() || body[0] != 'O') return read_words(control, line, number);
  const std::size_t digits = body.find_first_not_of("0123456789", 1);
  if (digits == 1) refuse_gcode(number, std::string(line), "the program's number is missing.");
  return digits == std::string_view::npos ? std::vector<GcodeWord>()
                                          : gcode_words(body.substr(digits), number);
}

}  // namespace patchmill::gcode

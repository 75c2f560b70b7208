// grblHAL, from the list of supported words in its core's README and its wiki ("Additional G- and M-codes"): NIST
// RS-274 on a microcontroller. No TCP, no path mode but G61, and no G33 here, for whether it follows the spindle
// depends on the driver; G43 H with a tool table. Lines have 256 characters at most; comments that begin with
// msg, debug or print are commands. Tried on no control.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/controls/common_words.h"
#include "patchmill/gcode/controls/word_reader.h"

namespace patchmill::gcode {
namespace {

std::vector<CodeWord> grblhal_words() {
  using G = WordGroup;
  std::vector<CodeWord> words = {
      same('G', 200, G::Units),          same('G', 210, G::Units),
      same('G', 280, G::Once, "XYZABC"), same('G', 300, G::Once, "XYZABC"),
      same('G', 430, G::Length, "H"),    same('G', 490, G::Length),
      same('G', 591, G::Offset),         same('G', 592, G::Offset),
      same('G', 593, G::Offset),         same('G', 610, G::PathMode),
      same('G', 911, G::ArcDistance),    same('M', 480, G::Override),
      same('M', 490, G::Override),       same('M', 500, G::Override, "P"),
      same('M', 510, G::Override, "P"),  same('M', 530, G::Override, "P"),
      same('M', 600, G::Stop),           same('M', 610, G::ToolChange, "Q"),
      same('M', 660, G::None, "PELQ"),   same('M', 670, G::None, "EQ"),
      same('M', 680, G::None, "EQ")};
  for (const int m : {620, 630, 640, 650}) words.push_back(same('M', m, G::None, "P"));
  return with(with(with(words, shared_words()), work_offsets()), drilling_cycles());
}

Control make() {
  Control c;
  c.name = "grblhal";
  c.title = "grblHAL";
  c.can.tcp = false;
  c.can.max_line = 256;
  c.comments.active = {"msg,", "debug,", "print,"};
  c.texts.preamble = "G21\nG17 G54 G40 G49 G80 G90 G94";
  c.texts.postamble = "M5\nG49\nM30";
  c.texts.spindle = "M{sense} S{speed}";
  c.texts.speed = "S{speed}";
  c.texts.tool_change = "M5\nT{tool} M6";
  c.texts.preselect = "T{tool}";
  c.texts.machine_move = "G53 G0 {axis}{value}";
  c.texts.path_mode = "G61";
  give_words(c, grblhal_words());
  c.read = &read_words;
  return c;
}

}  // namespace

const Control& grblhal();
const Control& grblhal() {
  static const Control control = make();
  return control;
}

}  // namespace patchmill::gcode

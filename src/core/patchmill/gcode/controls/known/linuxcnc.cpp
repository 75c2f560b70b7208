// LinuxCNC 2.9, from its documentation (G codes, M codes, remap, "Comments"): RS-274/NGC with G33 K along the
// path, G64 P Q, TCP by words of the machine's configuration (M428, M429 in its table-rotary-tilting ones).
// A block has 255 characters at most; comments that begin with msg, debug, print, log, probe, abort or py are
// commands. Programs are tried on it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/controls/common_words.h"
#include "patchmill/gcode/controls/word_reader.h"

namespace patchmill::gcode {
namespace {

constexpr std::string_view kMoves = "XYZABCUVWF";

std::vector<CodeWord> linuxcnc_words() {
  using G = WordGroup;
  std::vector<CodeWord> words = {same('G', 330, G::Motion, "XYZABCUVWK"),
                                 same('G', 200, G::Units),
                                 same('G', 210, G::Units),
                                 same('G', 280, G::Once, "XYZABCUVW"),
                                 same('G', 300, G::Once, "XYZABCUVW"),
                                 same('G', 430, G::Length, "H"),
                                 same('G', 434, G::Length, "H"),
                                 same('G', 490, G::Length),
                                 same('G', 591, G::Offset),
                                 same('G', 592, G::Offset),
                                 same('G', 593, G::Offset),
                                 same('G', 610, G::PathMode),
                                 same('G', 611, G::PathMode),
                                 same('G', 640, G::PathMode, "PQ"),
                                 same('G', 911, G::ArcDistance),
                                 same('M', 190, G::Spindle, "RQP"),
                                 same('M', 480, G::Override),
                                 same('M', 490, G::Override),
                                 same('M', 500, G::Override, "P"),
                                 same('M', 510, G::Override, "P"),
                                 same('M', 520, G::Override, "P"),
                                 same('M', 530, G::Override, "P"),
                                 same('M', 600, G::Stop),
                                 same('M', 610, G::ToolChange, "Q"),
                                 same('M', 660, G::None, "PELQ"),
                                 same('M', 670, G::None, "EQ"),
                                 same('M', 680, G::None, "EQ"),
                                 same('M', 4280, G::User),
                                 same('M', 4290, G::User)};
  for (const int m : {620, 630, 640, 650}) words.push_back(same('M', m, G::None, "P"));
  for (int m = 100; m < 200; ++m) words.push_back(same('M', 10 * m, G::User, "PQ"));
  return with(with(with(words, shared_words(kMoves)), work_offsets()), drilling_cycles());
}

Control make() {
  Control c;
  c.name = "linuxcnc";
  c.title = "LinuxCNC";
  c.file_ending = "ngc";
  c.can.lead = LeadRule::AlongPath;
  c.can.lead_letters = "K";
  c.can.lock_while_turning = true;
  c.can.tcp_brings_length = false;
  c.can.across_then_down = false;
  c.can.axes = "XYZABCUVW";
  c.comments.active = {"msg,",       "debug,", "print,", "log", "probeopen",
                       "probeclose", "abort,", "py,",    "py;", "outputfile"};
  c.texts.preamble = "G17 G54 G40 G49 G80 G90 G94\nG21";
  c.texts.postamble = "M5\nG61\nG17 G54 G90 G80 G40\nM2";
  c.texts.tcp_on = "M428";
  c.texts.tcp_off = "M429";
  c.texts.rounding = "G64 P{value}{merging}";
  c.texts.spindle = "M{sense} S{speed}";
  c.texts.speed = "S{speed}";
  c.texts.tool_change = "M5\nT{tool} M6";
  c.texts.preselect = "T{tool}";
  c.texts.machine_move = "G53 G0 {axis}{value}";
  give_words(c, linuxcnc_words());
  c.read = &read_words;
  return c;
}

}  // namespace

const Control& linuxcnc() {
  static const Control control = make();
  return control;
}

}  // namespace patchmill::gcode

// Fanuc 30i / 31i and kin, from their operator's and programming manuals: O number between two % signs, G43.4 H
// and G49 for TCP, G05.1 Q1 / Q0 for look-ahead, G33 F with the lead along the axis that moves most, G4 P in
// whole milliseconds, further work offsets by G54.1 P1 to P300. A length without a decimal point is one of units
// of the last decimal. Comments are of capitals; a % would end the file. Tried on no control.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/controls/common_words.h"
#include "patchmill/gcode/controls/iso_control.h"
#include "patchmill/geometry/error.h"

#include <cmath>

namespace patchmill::gcode {
namespace {

std::vector<CodeWord> fanuc_words() {
  using G = WordGroup;
  const std::vector<CodeWord> words = {
      same('G', 330, G::Motion, "XYZF"),  same('G', 51, G::None, "QR"),
      same('G', 300, G::Once, "XYZABCP"), same('G', 434, G::Length, "H"),
      same('G', 541, G::Offset, "P"),     {'M', 1980, 1980, G::None, "", false, true}};
  return with(with(with(with(words, iso_words()), shared_words()), work_offsets()),
              drilling_cycles());
}

bool is_cycle_with_dwell(const GcodeWord& w) {
  return w.letter == 'G' && (w.value == 82.0 || w.value == 89.0 || w.value == 73.0 ||
                             w.value == 81.0 || w.value == 83.0 || w.value == 85.0);
}

std::vector<GcodeWord> read(const Control& control, std::string_view line, long number) {
  std::vector<GcodeWord> words = read_iso_words(control, line, number);
  bool cycle = false;
  for (const GcodeWord& w : words) cycle = cycle || is_cycle_with_dwell(w);
  for (GcodeWord& w : words)
    if (cycle && w.letter == 'P') {
      if (w.point) refuse_gcode(number, std::string(line), "P of a cycle is in milliseconds.");
      w.value /= control.texts.dwell_units;
    }
  return words;
}

Control make() {
  Control c = iso_control();
  c.name = "fanuc";
  c.title = "Fanuc";
  c.can.lead = LeadRule::LongestAxis;
  c.can.lead_letters = "F";
  c.can.builder_words = true;
  c.comments.capitals = true;
  c.comments.max_length = 100;
  c.texts.tcp_on = "G43.4 H{tool}";
  c.texts.dwell_units = 1000.0;
  c.texts.dwell_decimals = 0;
  give_words(c, fanuc_words());
  c.read = &read;
  return c;
}

}  // namespace

const Control& fanuc();
const Control& fanuc() {
  static const Control control = make();
  return control;
}

}  // namespace patchmill::gcode

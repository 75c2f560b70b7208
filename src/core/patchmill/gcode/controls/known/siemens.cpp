// Siemens 840D sl, from its fundamentals, job planning and NC programming manuals: TRAORI and TRAFOOF, ORIMKS
// ORIAXES, CYCLE832, G60 and G641 ADIS= for corners, G33 with I, J or K along the axis that moves most, G4 F in
// seconds, G710; work offsets G54 to G57, then G505, G506 (FreeCAD's G58 and G59). Drilling cycles, whose words
// are calls with lists of values here, are written as moves. Tried on no control.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/controls/common_words.h"
#include "patchmill/gcode/controls/word_reader.h"

#include <algorithm>

namespace patchmill::gcode {
namespace {

std::vector<CodeWord> siemens_words() {
  using G = WordGroup;
  const std::vector<CodeWord> words = {same('G', 330, G::Motion, "XYZIJK"),
                                       {'G', 700, 200, G::Units},
                                       {'G', 7000, 200, G::Units},
                                       {'G', 7100, 210, G::Units},
                                       {'G', 710, 210, G::Units},
                                       same('G', 540, G::Offset),
                                       same('G', 550, G::Offset),
                                       same('G', 560, G::Offset),
                                       same('G', 570, G::Offset),
                                       {'G', 5050, 580, G::Offset},
                                       {'G', 5060, 590, G::Offset},
                                       {'G', 600, 610, G::PathMode},
                                       {'G', 640, 640, G::PathMode},
                                       {'G', -1, 800, G::Motion, "", true},
                                       {'G', -1, 980, G::Return, "", true},
                                       {'G', -1, 990, G::Return, "", true},
                                       {'G', -1, 911, G::ArcDistance, "", true},
                                       same('M', 190, G::Spindle),
                                       {'M', 170, 170, G::None, "", false, true}};
  return with(words, shared_words(kMoveLetters, kCentreLetters));
}

bool starts(std::string_view text, std::string_view with) {
  return text.substr(0, with.size()) == with;
}

// Without the block's number: "N10 G1" -> "G1".
std::string_view without_number(std::string_view text) {
  if (text.empty() || text[0] != 'N') return text;
  const std::size_t end = text.find_first_not_of("0123456789", 1);
  return end == std::string_view::npos ? std::string_view()
         : end == 1                    ? text
                                       : trimmed(text.substr(end));
}

// T1 D1, or D1 alone: the tool's cutting edge, by which its length comes into force.
std::vector<GcodeWord> without_edge(const Control& control, std::string_view code, long number) {
  std::vector<GcodeWord> words = gcode_words(code, number);
  const auto edge =
      std::find_if(words.begin(), words.end(), [](const GcodeWord& w) { return w.letter == 'D'; });
  if (edge == words.end()) return read_words(control, code, number);
  if (edge->value != 1.0) refuse_gcode(number, std::string(code), "the cutting edge is D1.");
  words.erase(edge);
  if (words.size() > 1 || (words.size() == 1 && words[0].letter != 'T'))
    refuse_gcode(number, std::string(code), "D1 is read alone or with T.");
  return words;
}

std::vector<GcodeWord> read(const Control& control, std::string_view line, long number) {
  const std::string_view body = without_number(trimmed(line));
  const std::string_view code = trimmed(body.substr(0, body.find(';')));
  if (code.empty() || (starts(code, "MSG(") && code.back() == ')') || code == "CYCLE832()" ||
      (starts(code, "CYCLE832(") && code.find(')') == code.size() - 1))
    return {};
  if (code == "TRAORI") return {{'G', 43.4}};
  if (code == "TRAFOOF") return {{'G', 49.0}};
  if (code == "ORIMKS ORIAXES" || code == "ORIMKS" || code == "ORIAXES")
    return {};  // how the orientation is interpolated: axis by axis
  constexpr std::string_view kRounding = "G641 ADIS=";
  if (starts(code, kRounding))
    return {{'G', 64.0}, {'P', whole_number_text(code.substr(kRounding.size()), line, number)}};
  if (starts(code, "SUPA ")) {  // without the tool's length: D0 in the block
    constexpr std::string_view kNoLength = " D0";
    const bool bare = code.size() > 8 && code.substr(code.size() - 3) == kNoLength;
    std::vector<GcodeWord> words =
        read_words(control, code.substr(5, code.size() - (bare ? 8 : 5)), number);
    words.insert(words.begin(), {'G', 53.0});
    return words;
  }
  return without_edge(control, code, number);
}

Control make() {
  Control c;
  c.name = "siemens";
  c.title = "Siemens 840D";
  c.file_ending = "mpf";
  c.can.lead = LeadRule::LongestAxis;
  c.can.lead_letters = "IJK";
  c.can.length_word = false;
  c.can.cycles = false;
  c.can.builder_words = true;
  c.can.max_line = 512;
  c.comments.round = false;
  c.texts.preamble = "G17 G40 G54 G90 G94 G710";
  c.texts.postamble = "M5\nG64\nM30";
  c.texts.plain_postamble = "M5\nM30";
  c.texts.tcp_on = "TRAORI\nORIMKS ORIAXES";
  c.texts.tcp_off = "TRAFOOF";
  c.texts.rounding = "G641 ADIS={value}";
  c.texts.spindle = "S{speed} M{sense}";
  c.texts.speed = "S{speed}";
  c.texts.tool_change = "M5\nT{tool} D1\nM6";
  c.texts.preselect = "T{tool}";
  c.texts.machine_move = "SUPA G0 {axis}{value} D0\nD1";
  c.texts.dwell_letter = 'F';
  give_words(c, siemens_words());
  c.read = &read;
  return c;
}

}  // namespace

const Control& siemens();
const Control& siemens() {
  static const Control control = make();
  return control;
}

}  // namespace patchmill::gcode

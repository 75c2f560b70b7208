// Heidenhain TNC 640 / iTNC 530 in plain text, from their user's manuals for conversational programming: L, CC and
// C blocks, TOOL CALL with the speed, M128 / M129, dwell by cycle 9, presets by cycle 247, M91 for machine
// coordinates, BLK FORM. It has no inverse time (F or FT instead), no block that follows the spindle, and no word
// for the work offset that a program of FreeCAD names: the preset is the operator's. Tried on no control.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/controls/common_words.h"
#include "patchmill/gcode/controls/word_reader.h"

#include <algorithm>

#include <fmt/format.h>

namespace patchmill::gcode {
namespace {

using Words = std::vector<GcodeWord>;

std::vector<CodeWord> heidenhain_words() {
  using G = WordGroup;
  std::vector<CodeWord> words = {same('G', 0, G::Motion, kMoveLetters),
                                 same('G', 10, G::Motion, kMoveLetters),
                                 same('G', 20, G::Motion, kArcLetters),
                                 same('G', 30, G::Motion, kArcLetters),
                                 same('G', 40, G::Once, "P"),
                                 same('G', 930, G::FeedMode),
                                 same('G', 940, G::FeedMode),
                                 same('G', 610, G::PathMode),
                                 same('G', 640, G::PathMode),
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
                                 same('M', 90, G::Coolant),
                                 same('M', 1280, G::User),
                                 same('M', 1290, G::User)};
  for (const int state : {170, 210, 400, 540, 800, 900, 911, 980, 990})
    words.push_back({'G', -1, state, G::None, "", true});
  for (int m = 89; m < 200; ++m)  // the control's own: they change what a block means
    if (m != 128 && m != 129) words.push_back({'M', 10 * m, 10 * m, G::None, "", false, true});
  return words;
}

bool starts(std::string_view text, std::string_view with) {
  return text.substr(0, with.size()) == with;
}

// Splits at blanks.
std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> parts;
  while (!(text = trimmed(text)).empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return parts;
}

class Block {
 public:
  Block(const Control& control, std::string_view line, long number)
      : control_(control), line_(line), number_(number) {}

  // L X+1.000 Y-2.000 A+10.000 R0 FMAX M3
  Words straight(const std::vector<std::string_view>& parts) {
    rest(parts);
    if (circle_) refuse("DR belongs to a circle.");
    if (seconds_ > 0.0) return with({{'G', 93.0}, {'G', 1.0}, {'F', 60.0 / seconds_}});
    return with({{'G', 94.0}, {'G', rapid_ ? 0.0 : 1.0}});
  }
  // C X+1.000 Y-2.000 DR+ F100: about the centre of the last CC
  Words arc(const std::vector<std::string_view>& parts) {
    rest(parts);
    if (!circle_ || rapid_ || seconds_ > 0.0) refuse("a circle needs DR and a feed.");
    return with({{'G', 94.0}, {'G', circle_ > 0 ? 3.0 : 2.0}});
  }
  // TOOL CALL 3 Z S1000
  Words tool_call(const std::vector<std::string_view>& parts) {
    Words words;
    for (std::size_t i = 2; i < parts.size(); ++i) {
      const std::string_view part = parts[i];
      if (part[0] == 'S')
        words.push_back({'S', number_of(part.substr(1))});
      else if (i == 2) {
        words.push_back({'T', number_of(part)});
        words.push_back({'M', 6.0});
      } else if (part != "Z")
        refuse(fmt::format("{} is not read: the tool's axis is Z.", part));
    }
    if (words.empty()) refuse("a tool or a speed is missing.");
    return words;
  }
  double number_of(std::string_view text) const { return whole_number_text(text, line_, number_); }
  [[noreturn]] void refuse(const std::string& why) const {
    refuse_gcode(number_, std::string(line_), why);
  }

 private:
  void rest(const std::vector<std::string_view>& parts) {
    std::string words;
    for (std::size_t i = 1; i < parts.size(); ++i) {
      const std::string_view part = parts[i];
      if (part == "R0") continue;
      if (part == "FMAX")
        rapid_ = true;
      else if (starts(part, "FT"))
        seconds_ = number_of(part.substr(2));
      else if (part == "DR+" || part == "DR-")
        circle_ = part == "DR+" ? 1 : -1;
      else if (part == "M91")
        machine_ = true;
      else
        words += std::string(part) + " ";
    }
    plain_ = gcode_words(words, number_);
    for (const GcodeWord& w : plain_)
      if (std::string_view("XYZABCFM").find(w.letter) == std::string_view::npos)
        refuse(fmt::format("{} is not read here.", w.letter));
    const auto feed = [](const GcodeWord& w) { return w.letter == 'F'; };
    if ((rapid_ || seconds_ > 0.0) && std::any_of(plain_.begin(), plain_.end(), feed))
      refuse("it has two feeds.");
  }
  Words with(Words words) const {
    if (machine_) words.push_back({'G', 53.0});
    words.insert(words.end(), plain_.begin(), plain_.end());
    Words checked = words;
    checked.erase(std::remove_if(checked.begin(), checked.end(),
                                 [](const GcodeWord& w) { return w.letter == 'G'; }),
                  checked.end());
    checked.push_back({'G', 1.0});
    in_common_tongue(control_, line_, number_, checked);  // what stands twice
    return words;
  }

  const Control& control_;
  std::string_view line_;
  long number_;
  Words plain_;
  bool rapid_ = false, machine_ = false;
  int circle_ = 0;
  double seconds_ = 0.0;
};

// CYCL DEF 9.1 DWELL 0.5, or V.ZEIT 0.5 as it stands on a German control
double dwell_of(const Block& block, const std::vector<std::string_view>& parts) {
  std::string_view value = parts.back();
  for (const std::string_view name : {std::string_view("V.ZEIT"), std::string_view("DWELL")})
    if (starts(value, name)) value = value.substr(name.size());
  if (parts.size() < 4 || parts.size() > 5 || value.empty())
    block.refuse("the time of the dwell is missing.");
  return block.number_of(value);
}

Words cycle(Block& block, const std::vector<std::string_view>& parts) {
  const std::string_view name = parts.size() > 2 ? parts[2] : std::string_view();
  if (name == "9.0" || name == "7.0" || starts(name, "32.") || name == "247") {
    if (name != "247") return {};
    for (const std::string_view part : parts)
      if (starts(part, "Q339=")) return {{'G', 54.1}, {'P', block.number_of(part.substr(5))}};
    return {};
  }
  if (name == "9.1") return {{'G', 4.0}, {'P', dwell_of(block, parts)}};
  if (starts(name, "7.") && parts.size() == 4 && parts[3].size() > 1) {
    const char axis = parts[3][0];
    if (axis == '#') return {{'G', 92.0}, {'P', block.number_of(parts[3].substr(1))}};
    if (axis >= 'X' && axis <= 'Z')
      return {{'G', 92.0}, {axis, block.number_of(parts[3].substr(1))}};
  }
  block.refuse("this cycle is not read.");
}

// BLK FORM 0.1 Z Y-5.000 Z-4.000, or 0.2 and no axis of the tool: a corner of the stock
void require_corner(const Block& block, const std::vector<std::string_view>& parts) {
  const std::size_t first = parts.size() > 2 && parts[2] == "0.1" ? 4 : 3;
  if (parts.size() != first + 3) block.refuse("a corner of the stock is X Y Z.");
  for (std::size_t i = 0; i < 3; ++i) {
    std::string_view part = parts[first + i];
    if (part[0] == 'I') part.remove_prefix(1);  // from the first corner on
    if (part.empty() || part[0] != "XYZ"[i]) block.refuse("a corner of the stock is X Y Z.");
    block.number_of(part.substr(1));
  }
}

// Without the block's number: "12 L X+1" -> "L X+1".
std::string_view without_number(std::string_view text) {
  const std::size_t end = text.find_first_not_of("0123456789");
  return end == 0 || end == std::string_view::npos ? text : trimmed(text.substr(end));
}

Words read(const Control& control, std::string_view line, long number) {
  const std::string_view body = without_number(trimmed(line));
  std::string_view code = trimmed(body.substr(0, body.find(';')));
  if (!code.empty() && code.back() == '~') code = trimmed(code.substr(0, code.size() - 1));
  if (code.empty() || starts(code, "END PGM ")) return {};
  if (starts(code, "BEGIN PGM "))
    return {{'G', code.substr(code.size() - 4) == "INCH" ? 20.0 : 21.0}};
  if (starts(code, "FUNCTION TCPM ") || code == "M128") return {{'G', 43.4}};
  if (code == "FUNCTION RESET TCPM" || code == "M129") return {{'G', 49.0}};
  Block block(control, line, number);
  const std::vector<std::string_view> parts = split(code);
  if (starts(code, "BLK FORM ")) {
    if (starts(parts[2], "0.")) require_corner(block, parts);
    return {};
  }
  if (parts[0] == "L") return block.straight(parts);
  if (parts[0] == "C") return block.arc(parts);
  if (parts[0] == "CC" && parts.size() == 3 && parts[1][0] == 'X' && parts[2][0] == 'Y')
    return {{'G', 90.1},
            {'I', block.number_of(parts[1].substr(1))},
            {'J', block.number_of(parts[2].substr(1))}};
  if (starts(code, "TOOL CALL ")) return block.tool_call(parts);
  if (starts(code, "TOOL DEF ") && parts.size() == 3) return {{'T', block.number_of(parts[2])}};
  if (starts(code, "CYCL DEF ")) return cycle(block, parts);
  if (starts(code, "Q339=") && parts.size() == 1)  // of cycle 247, the preset
    return {{'G', 54.1}, {'P', block.number_of(code.substr(5))}};
  if (parts[0][0] == 'M') {
    Words words = gcode_words(code, number);
    if (std::all_of(words.begin(), words.end(), [](auto& w) { return w.letter == 'M'; }))
      return in_common_tongue(control, line, number, words);
  }
  block.refuse("this block is not read.");
}

Control make() {
  Control c;
  c.name = "heidenhain";
  c.title = "Heidenhain TNC";
  c.file_ending = "h";
  c.can.inverse_time = false;
  c.can.length_word = false;
  c.can.cycles = false;
  c.can.arcs_in_all_planes = false;
  c.can.builder_words = true;
  c.can.form = BlockForm::PlainText;
  c.comments.round = false;
  c.comments.max_length = 120;
  c.texts.begin = "BEGIN PGM {name} MM";
  c.texts.end = "END PGM {name} MM";
  c.texts.postamble = "M5\nM30";
  c.texts.tcp_on = "M128";
  c.texts.tcp_off = "M129";
  c.texts.spindle = "M{sense}";
  c.texts.tool_change = "TOOL CALL {tool} Z{speed}";
  c.texts.speed = "TOOL CALL S{speed}";
  c.texts.preselect = "TOOL DEF {tool}";
  c.texts.machine_move = "L {axis}{value} R0 FMAX M91";
  c.texts.path_mode = "";
  c.texts.dwell = "CYCL DEF 9.0 DWELL TIME\nCYCL DEF 9.1 DWELL {value}";
  give_words(c, heidenhain_words());
  c.read = &read;
  return c;
}

}  // namespace

const Control& heidenhain();
const Control& heidenhain() {
  static const Control control = make();
  return control;
}

}  // namespace patchmill::gcode

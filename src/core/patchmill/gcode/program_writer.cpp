// The writer for all controls; see program_writer.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/program_writer.h"

#include "patchmill/gcode/writer.h"
#include "patchmill/geometry/error.h"

#include <algorithm>

#include <fmt/format.h>

namespace patchmill::gcode {
namespace {

// When a word of a block counts, as RS-274 has it: feed mode, tool, spindle, coolant, dwell, states, motion, stop.
int rank(const BlockCode& code) {
  const int t = code.tenths;
  if (code.letter == 'G') {
    if (t == 930 || t == 940) return 0;
    if (t == 40) return 4;
    const bool motion = t == 0 || t == 10 || t == 20 || t == 30 || t == 330 || t == 280 ||
                        t == 300 || (t >= 730 && t < 900 && t != 800);
    return motion ? 7 : t == 530 ? 6 : 5;
  }
  if (t == 60 || t == 610) return 1;
  if (t == 0 || t == 10 || t == 20 || t == 300 || t == 600) return 8;
  return t == 30 || t == 40 || t == 50 ? 2 : 3;
}

bool changes_tool(const std::vector<std::string>& texts) {
  for (const std::string& text : texts)
    for (const std::string_view word : {std::string_view("M6"), std::string_view("M06")})
      for (std::size_t at = text.find(word); at != std::string::npos;
           at = text.find(word, at + 1)) {
        const char next = at + word.size() < text.size() ? text[at + word.size()] : '\n';
        if (next < '0' || next > '9') return true;
      }
  return false;
}

// Whether an operation moves, and its first move says nothing of rotary axes.
bool moves_upright(const std::string& text) {
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    const std::string_view line = std::string_view(text).substr(from, end - from);
    from = end + 1;
    if (line.empty() || line[0] != 'G') continue;
    const bool places = line.find_first_of("XYZ") != std::string_view::npos;
    const bool turns = line.find_first_of("ABC") != std::string_view::npos;
    if (places || turns) return !turns;
  }
  return false;
}

// The path mode that the program begins with.
std::string first_path_mode(const ProgramStyle& style) {
  std::string mode = style.control->texts.path_mode;
  for (const std::string_view word : {std::string_view("G61"), std::string_view("G60")})
    if (style.preamble.find(word) != std::string::npos) mode = word;
  return mode;
}

void require_style(const std::vector<std::string>& texts, const ProgramStyle& style) {
  const int most = style.control->can.max_decimals;
  if (style.precision < 0 || style.precision > most)
    throw InputError("PostProcessorArgs", fmt::format("--precision={}", style.precision),
                     fmt::format("give 0 to {} decimals.", most));
  if (style.number < 1 || style.number > 9999)
    throw InputError("PostProcessorArgs", fmt::format("--program-number={}", style.number),
                     "give 1 to 9999.");
  if (!style.own.empty() && style.own.size() != texts.size())
    throw InputError("own", fmt::format("{} flags", style.own.size()), "give one for each text.");
}

}  // namespace

Writer::Writer(const ProgramStyle& style)
    : style_(style), control_(*style.control), out_(style), first_mode_(first_path_mode(style)) {}

std::string Writer::write(const std::vector<std::string>& texts) {
  // before the first tool a program has no length to go by: FreeCAD's rapid to the clearance is left to the
  // operator, who retracts
  called_ = !changes_tool(texts);
  out_.begin();
  if (style_.stock && control_.can.form == BlockForm::PlainText) {
    const auto corner = [&](const char* head, const Vec3& p) {
      std::string text = head;
      for (int i = 0; i < 3; ++i) {
        text += fmt::format(" {}", "XYZ"[i]);
        append_fixed(text, p[i], style_.precision, true);
      }
      out_.line(text);
    };
    corner("BLK FORM 0.1 Z", style_.stock->first);
    corner("BLK FORM 0.2", style_.stock->second);
  }
  for (const std::string& line : style_.header) out_.comment(line);
  out_.lines(style_.preamble.empty() ? control_.texts.preamble : style_.preamble);
  long number = 0;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    begin_operation(texts[i], style_.own.empty() || style_.own.at(i));
    std::string_view rest = texts[i];
    while (!rest.empty()) {
      const std::size_t end = rest.find('\n');
      one_line(rest.substr(0, end), ++number);
      rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    }
  }
  finish();
  return out_.end();
}

/// What the operation before has left is undone: it must not be of any moment for the next one.
void Writer::begin_operation(const std::string& text, bool own) {
  if (!was_own_) wanted_mode_ = path_mode_;  // what others set stays
  was_own_ = own;
  other_operation_ = true;
  in_cycle_ = mode_said_ = false;
  if (relative_) distance(false);
  if (inverse_) feed_mode(false);
  if (plane_ != ArcPlane::XY) preparatory({}, 170);
  if (other_length_) pending_length_ = style_.tool_length;
  other_length_ = false;
  tcp(false);
  if (moves_upright(text)) upright({});
}

void Writer::one_line(std::string_view text, long number) {
  if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
  if (text.empty()) return;
  if (text[0] == '(') {
    if (style_.comments) out_.comment(text.substr(1, text.size() - (text.back() == ')' ? 2 : 1)));
    return;
  }
  PathBlock block = path_block(text, number);
  const bool rapid = block.count == 1 && block.code('G', 0);
  if (held_ && !rapid) {
    fresh_ = false;
    down(*held_);
  }
  one_block(block);
}

void Writer::one_block(PathBlock& block) {
  if (machine_next_) block.codes.at(block.count++) = {'G', 530};  // a command of its own in FreeCAD
  if (block.code('G', 530) && (machine_next_ || block.count > 1) && !block.code('G', 0) &&
      !block.code('G', 10))
    refuse_block(block, "G53 needs G0 or G1 in its block.");
  machine_next_ = false;
  require_words(block);
  if (block.count == 0) return lone_words(block);
  std::stable_sort(block.codes.begin(), block.codes.begin() + static_cast<long>(block.count),
                   [](const BlockCode& a, const BlockCode& b) { return rank(a) < rank(b); });
  if (block.gives('F') && block.get('F') > 0.0) feed_ = 60.0 * block.get('F');
  for (std::size_t i = 0; i < block.count; ++i) one_code(block, block.codes[i]);
}

void Writer::one_code(const PathBlock& block, const BlockCode& code) {
  if (code.letter == 'M') return machine_word(block, code.tenths);
  switch (code.tenths) {
    case 0:
    case 10:
    case 330:
      return move(block, code.tenths);
    case 20:
    case 30:
      return arc(block, code.tenths == 20);
    case 280:
    case 300:
      return reference(block, code.tenths);
    case 530:
      machine_next_ = block.count == 1;
      return;
    default:
      if (code.tenths >= 730 && code.tenths < 900 && code.tenths != 800)
        return cycle(block, code.tenths);
      return preparatory(block, code.tenths);
  }
}

void Writer::finish() {
  if (held_) down(*held_);
  tcp(false);
  if (inverse_) feed_mode(false);
  const bool tilted =
      (known_[3] && at_[3] != 0.0) || (known_[4] && at_[4] != 0.0) || (known_[5] && at_[5] != 0.0);
  if (tilted && !style_.retract.empty())
    upright({});
  else if (called_)
    retract();
  const FixedTexts& texts = control_.texts;
  // TCP's own word has cancelled the length, or nothing has changed the path mode
  const bool plain = control_.can.tcp_off_ends_length ? tcp_used_ : path_mode_.empty();
  const std::string own =
      plain && !texts.plain_postamble.empty() ? texts.plain_postamble : texts.postamble;
  out_.lines(style_.postamble.empty() ? own : style_.postamble);
}

std::string write_program(const std::vector<std::string>& texts, const ProgramStyle& style) {
  require_style(texts, style);
  return Writer(style).write(texts);
}

}  // namespace patchmill::gcode

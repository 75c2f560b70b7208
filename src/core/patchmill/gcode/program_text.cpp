// Blocks of a program; see program_text.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/program_text.h"

#include "patchmill/geometry/stop.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace patchmill::gcode {
namespace {

constexpr int kLeadDecimals = 6;

bool plain_text(const Control& control) {
  return control.can.form == BlockForm::PlainText;
}

}  // namespace

void append_fixed(std::string& text, double value, int decimals, bool plus) {
  static constexpr std::int64_t kPower[] = {1, 10, 100, 1000, 10000, 100000, 1000000};
  const std::int64_t scale = kPower[decimals];
  const std::int64_t units = std::llround(value * static_cast<double>(scale));
  if (units < 0)
    text += '-';
  else if (plus)
    text += '+';
  const auto size = static_cast<std::uint64_t>(units < 0 ? -units : units);
  char digits[32];
  std::size_t n = 0;
  std::uint64_t rest = size;
  do {
    if (decimals > 0 && n == static_cast<std::size_t>(decimals)) digits[n++] = '.';
    digits[n++] = static_cast<char>('0' + rest % 10);
    rest /= 10;
  } while (rest > 0 || n <= static_cast<std::size_t>(decimals) + (decimals > 0 ? 1u : 0u));
  while (n > 0) text += digits[--n];
}

std::string short_number(double value) {
  std::string text;
  append_fixed(text, value, 6, false);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

ProgramText::ProgramText(const ProgramStyle& style)
    : style_(style), control_(*style.control), feed_decimals_(std::max(3, style.precision)) {}

void ProgramText::number() {
  if (plain_text(control_)) {
    text_ += std::to_string(count_++);
    text_ += ' ';
  } else if (style_.line_numbers) {
    text_ += 'N';
    text_ += std::to_string(10 * ++count_);
    text_ += ' ';
  }
}

void ProgramText::line(const std::string& text) {
  number();
  text_ += text;
  text_ += '\n';
}

void ProgramText::lines(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    stop_point();
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (end > at) line(text.substr(at, end - at));
    at = end + 1;
  }
}

void ProgramText::begin() {
  if (control_.texts.begin.empty()) return;
  std::string text = filled(control_.texts.begin, "number", fmt::format("{:04d}", style_.number));
  text = filled(text, "name", style_.name);
  if (plain_text(control_)) return line(text);
  text_ += text + '\n';
}

std::string ProgramText::end() {
  const std::string text = filled(control_.texts.end, "name", style_.name);
  if (plain_text(control_))
    line(text);
  else if (!text.empty())
    text_ += text + '\n';
  return std::move(text_);
}

void ProgramText::comment(std::string_view text) {
  const std::string safe = safe_comment(control_.comments, text);
  if (control_.comments.round)
    text_ += safe + '\n';
  else
    line(safe);
}

void ProgramText::forget() {
  forget_word();
  known_.fill(false);
  feed_ = -1.0;
}
void ProgramText::forget_word() {
  motion_ = -1;
}

void ProgramText::word(char letter, double value, int decimals) {
  text_ += ' ';
  text_ += letter;
  append_fixed(text_, value, decimals, plain_text(control_));
  if (decimals == 0 && control_.can.numbers_need_point) text_ += '.';
}

void ProgramText::axes(const MoveBlock& block, bool plus) {
  const bool sparse = (style_.axis_modal || plus) && !block.relative && !block.machine;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    if (!block.given[i]) continue;
    if (sparse && known_[i] && block.value[i] == at_[i]) continue;
    known_[i] = !block.relative && !block.machine;
    at_[i] = block.value[i];
    word(kWrittenAxes[i], block.value[i], style_.precision);
  }
}

// L X+1.000 Y+2.000 R0 FMAX; R0 where a rapid begins a stretch.
void ProgramText::straight_line(const MoveBlock& block) {
  number();
  text_ += 'L';
  const std::size_t bare = text_.size();
  axes(block, true);
  if (text_.size() == bare) {  // nothing moves: no block
    text_.resize(text_.rfind('\n') + 1);
    --count_;
    return;
  }
  if (block.motion == Motion::Rapid) {
    text_ += motion_ == 0 ? " FMAX\n" : " R0 FMAX\n";
    motion_ = 0;
    feed_ = -1.0;
    return;
  }
  motion_ = 1;
  if (block.seconds > 0.0) {
    text_ += " FT";
    append_fixed(text_, block.seconds, 3, false);
    feed_ = -1.0;
  } else {
    feed_word(block.feed, false);
  }
  text_ += '\n';
}

double ProgramText::feed_units(double feed) const {
  return std::round(feed * std::pow(10.0, feed_decimals_));
}

void ProgramText::feed_word(double feed, bool inverse) {
  if (!inverse && (style_.modal || plain_text(control_)) && feed_units(feed) == feed_) return;
  text_ += " F";
  append_fixed(text_, feed, feed_decimals_, false);
  feed_ = inverse ? -1.0 : feed_units(feed);
}

void ProgramText::move(const MoveBlock& block) {
  if (plain_text(control_)) return straight_line(block);
  const std::size_t whole = text_.size();
  const long count = count_;
  number();
  const int motion = static_cast<int>(block.motion);
  const std::size_t begin = text_.size();
  if (block.machine) text_ += "G53 ";
  if (!style_.modal || motion != motion_ || block.machine) {
    static constexpr const char* kWords[] = {"G0", "G1", "G33"};
    text_ += kWords[motion];
    motion_ = motion;
  }
  if (block.length > 0) text_ += " G43";
  const std::size_t bare = text_.size();
  axes(block, false);
  if (text_.size() == bare) {  // nothing moves: no block, and no word of it
    text_.resize(whole);
    count_ = count;
    return forget_word();
  }
  if (block.length > 0) text_ += fmt::format(" H{}", block.length);
  if (block.motion == Motion::Locked) {
    text_ += ' ';
    text_ += block.lead.letter;
    append_fixed(text_, block.lead.value, kLeadDecimals, false);
    feed_ = -1.0;
  }
  if (block.motion == Motion::Feed) feed_word(block.feed, block.inverse);
  if (text_.size() > begin && text_[begin] == ' ') text_.erase(begin, 1);  // no G word came first
  text_ += '\n';
}

void ProgramText::remember(const Arc& arc) {
  for (Eigen::Index i = 0; i < 3; ++i) {
    known_[static_cast<std::size_t>(i)] = true;
    at_[static_cast<std::size_t>(i)] = arc.to[i];
  }
  forget_word();
}

void ProgramText::arc(const Arc& arc, double feed, bool inverse) {
  const int across = arc.plane == ArcPlane::XY ? 2 : arc.plane == ArcPlane::ZX ? 1 : 0;
  number();
  if (plain_text(control_)) {
    text_ += "CC";
    for (int i = 0; i < 2; ++i) word("XY"[i], arc.centre[i], style_.precision);
    text_ += '\n';
    number();
    text_ += 'C';
    for (int i = 0; i < 2; ++i) word("XY"[i], arc.to[i], style_.precision);
    text_ += arc.clockwise ? " DR-" : " DR+";
  } else {
    text_ += arc.clockwise ? "G2" : "G3";
    for (int i = 0; i < 3; ++i)
      if (i != across || arc.to[i] != arc.from[i]) word("XYZ"[i], arc.to[i], style_.precision);
    for (int i = 0; i < 3; ++i)
      if (i != across) word("IJK"[i], arc.centre[i] - arc.from[i], style_.precision);
  }
  feed_word(feed, inverse);
  text_ += '\n';
  remember(arc);
}

void ProgramText::cycle(const DrillingCycle& cycle, double x, double y, double feed) {
  const int d = style_.precision;
  number();
  text_ += code_text('G', cycle.code);
  word('X', x, d);
  word('Y', y, d);
  word('Z', cycle.bottom, d);
  word('R', cycle.retract, d);
  if (cycle.peck > 0.0) word('Q', cycle.peck, d);
  if (cycle.seconds > 0.0) {
    text_ += " P";
    append_fixed(text_, cycle.seconds * control_.texts.dwell_units, control_.texts.dwell_decimals,
                 false);
  }
  feed_word(feed, false);
  text_ += '\n';
  known_[0] = known_[1] = known_[2] = false;
  forget_word();
}

}  // namespace patchmill::gcode

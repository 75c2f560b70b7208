// Blocks of a program; see program_text.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/machine/program_text.h"

#include "core/geometry/error.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

namespace patchmill {
namespace {

constexpr std::string_view kAxes = "XYZABC";
constexpr int kLeadDecimals = 6;

bool bare_numbers(Dialect dialect) {
  return dialect == Dialect::Heidenhain;
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

ProgramText::ProgramText(const ProgramStyle& style)
    : style_(style), feed_decimals_(std::max(3, style.precision)) {}

void ProgramText::number() {
  if (bare_numbers(style_.dialect)) {
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
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (end > at) line(text.substr(at, end - at));
    at = end + 1;
  }
}

void ProgramText::begin() {
  if (style_.dialect == Dialect::Fanuc) {
    text_ += fmt::format("%\nO{:04d}\n", style_.number);
    comment(style_.name);
  }
  if (style_.dialect == Dialect::Heidenhain) line("BEGIN PGM " + style_.name + " MM");
}

std::string ProgramText::end() {
  if (style_.dialect == Dialect::Fanuc) text_ += "%\n";
  if (style_.dialect == Dialect::Heidenhain) line("END PGM " + style_.name + " MM");
  return std::move(text_);
}

void ProgramText::comment(std::string_view text) {
  std::string plain;
  for (const char c : text)
    if (c != '(' && c != ')' && c != ';' && c != '\n')
      plain += style_.dialect == Dialect::Fanuc
                   ? static_cast<char>(std::toupper(static_cast<unsigned char>(c)))
                   : c;
  const bool round = style_.dialect == Dialect::LinuxCnc || style_.dialect == Dialect::Fanuc;
  if (round) {
    text_ += "(" + plain + ")\n";
  } else {
    line("; " + plain);
  }
}

void ProgramText::forget() {
  forget_word();
  known_.fill(false);
  feed_ = -1.0;
}
void ProgramText::forget_word() {
  motion_ = -1;
}

void ProgramText::axes(const MoveBlock& block, bool plus) {
  const bool sparse = style_.axis_modal || bare_numbers(style_.dialect);
  for (std::size_t i = 0; i < kAxes.size(); ++i) {
    if (!block.given[i]) continue;
    if (sparse && known_[i] && block.value[i] == at_[i]) continue;
    known_[i] = true;
    at_[i] = block.value[i];
    text_ += ' ';
    text_ += kAxes[i];
    append_fixed(text_, block.value[i], style_.precision, plus);
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
  } else if (feed_units(block.feed) != feed_) {
    text_ += " F";
    append_fixed(text_, block.feed, feed_decimals_, false);
    feed_ = feed_units(block.feed);
  }
  text_ += '\n';
}

double ProgramText::feed_units(double feed) const {
  return std::round(feed * std::pow(10.0, feed_decimals_));
}

void ProgramText::move(const MoveBlock& block) {
  if (bare_numbers(style_.dialect)) return straight_line(block);
  const std::size_t whole = text_.size();
  const long count = count_;
  number();
  const int motion = static_cast<int>(block.motion);
  const std::size_t begin = text_.size();
  if (!style_.modal || motion != motion_) {
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
  if (block.motion == Motion::Feed &&
      (block.inverse || !style_.modal || feed_units(block.feed) != feed_)) {
    text_ += " F";
    append_fixed(text_, block.feed, feed_decimals_, false);
    feed_ = block.inverse ? -1.0 : feed_units(block.feed);
  }
  if (text_.size() > begin && text_[begin] == ' ') text_.erase(begin, 1);  // no G word came first
  text_ += '\n';
}

void ProgramText::plain(int tenths, const std::function<bool(char, double&)>& get) {
  number();
  text_ += fmt::format("G{:g}", tenths / 10.0);
  for (const char letter : std::string_view("XYZABCIJKRPQFSTHDL")) {
    double value = 0.0;
    if (!get(letter, value)) continue;
    text_ += ' ';
    text_ += letter;
    const bool whole = std::string_view("STHDL").find(letter) != std::string_view::npos;
    append_fixed(text_, value,
                 whole           ? 0
                 : letter == 'F' ? feed_decimals_
                                 : style_.precision,
                 false);
  }
  text_ += '\n';
  forget_word();
}

}  // namespace patchmill

// Strict reading of blocks; see word_reader.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/controls/word_reader.h"

#include "patchmill/gcode/controls/letter_set.h"

#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace patchmill::gcode {
namespace {

constexpr LetterSet kAlways = letter_set("FST");
constexpr LetterSet kLengths =
    letter_set("XYZABCIJKR");  // which Fanuc reads in units without a point

class BlockCheck {
 public:
  BlockCheck(const Control& control, std::string_view line, long number)
      : control_(control), line_(line), number_(number) {}

  void code(GcodeWord& word) {
    const int own = code_tenths(word, line_, number_);
    const CodeWord* known = control_.word(word.letter, own);
    if (known && known->forbidden)
      refuse(fmt::format("{} is not read: programs here are of one piece.",
                         code_text(word.letter, own)));
    if (!known) {
      if (word.letter == 'M' && own % 10 == 0 && control_.can.builder_words) return;
      refuse(fmt::format("of {} no {} is read here.", control_.title, code_text(word.letter, own)));
    }
    if (known->group != WordGroup::None) once(*known);
    if (known->group == WordGroup::Motion || known->group == WordGroup::Once) own_letters_ = true;
    takes_ |= letter_set(known->takes);
    word.value = known->means / 10.0;
    if (word.letter == 'G' && known->means == 40) dwell_ = true;
  }

  void letter(const GcodeWord& word) {
    const LetterSet one = letter_set(word.letter);
    if (seen_ & one) refuse(fmt::format("{} stands twice in the block.", word.letter));
    seen_ |= one;
    if (control_.can.numbers_need_point && (kLengths & one) && !word.point)
      refuse(
          fmt::format("{} needs a decimal point: without one it counts units of the last decimal.",
                      word.letter));
    if (!((takes_ | (own_letters_ ? kAlways : control_.modal_letters)) & one))
      refuse(fmt::format("{} belongs to no word of the block.", word.letter));
  }

  /// G4's time in seconds, under P. The letter is the control's.
  void dwell(std::vector<GcodeWord>& words) {
    if (!dwell_) return;
    const FixedTexts& texts = control_.texts;
    for (GcodeWord& word : words) {
      if (word.letter == 'G' || word.letter == 'M') continue;
      if (word.letter != texts.dwell_letter)
        refuse(fmt::format("G4 needs {}, not {}.", texts.dwell_letter, word.letter));
      if (texts.dwell_decimals == 0 && word.point)
        refuse(fmt::format("{} of G4 is a whole number.", texts.dwell_letter));
      if (word.value < 0.0) refuse("nobody can wait less than no time.");
      word = {'P', word.value / texts.dwell_units, word.point};
    }
  }

  [[noreturn]] void refuse(const std::string& why) const {
    refuse_gcode(number_, std::string(line_), why);
  }

 private:
  void once(const CodeWord& known) {
    const std::size_t k = 32 * (known.letter == 'M') + static_cast<std::size_t>(known.group);
    if (groups_[k])
      refuse(fmt::format("{} and another word of its group stand in one block.",
                         code_text(known.letter, known.own)));
    groups_[k] = true;
  }

  const Control& control_;
  std::string_view line_;
  long number_;
  std::array<bool, 64> groups_{};
  LetterSet seen_ = 0, takes_ = 0;
  bool own_letters_ = false, dwell_ = false;
};

}  // namespace

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r";
  const std::size_t a = text.find_first_not_of(kBlank);
  if (a == std::string_view::npos) return {};
  return text.substr(a, text.find_last_not_of(kBlank) - a + 1);
}

double whole_number_text(std::string_view text, std::string_view line, long number) {
  std::string_view rest = text;
  if (!rest.empty() && rest.front() == '+') rest.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] =
      std::from_chars(rest.data(), rest.data() + rest.size(), value, std::chars_format::fixed);
  if (error != std::errc() || end != rest.data() + rest.size() || !std::isfinite(value))
    refuse_gcode(number, std::string(line), "a plain number is missing.");
  return value;
}

int code_tenths(const GcodeWord& word, std::string_view line, long number) {
  const double tenths = std::round(word.value * 10.0);
  if (!(word.value >= 0.0 && word.value <= 9999.0) || std::abs(word.value * 10.0 - tenths) > 1e-6)
    refuse_gcode(number, std::string(line),
                 fmt::format("{}{} is no word.", word.letter, word.value));
  return static_cast<int>(tenths);
}

std::vector<GcodeWord> in_common_tongue(const Control& control, std::string_view line, long number,
                                        std::vector<GcodeWord> words) {
  BlockCheck check(control, line, number);
  for (GcodeWord& word : words)
    if (word.letter == 'G' || word.letter == 'M') check.code(word);
  for (const GcodeWord& word : words)
    if (word.letter != 'G' && word.letter != 'M') check.letter(word);
  check.dwell(words);
  return words;
}

std::vector<GcodeWord> read_words(const Control& control, std::string_view line, long number) {
  if (line.size() > control.can.max_line)
    refuse_gcode(number, std::string(line.substr(0, 40)) + "...",
                 fmt::format("{} takes lines of {} characters at most.", control.title,
                             control.can.max_line));
  return in_common_tongue(control, line, number, gcode_words(line, number));
}

}  // namespace patchmill::gcode

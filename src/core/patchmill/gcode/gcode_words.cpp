// Splitting G-code lines; see gcode_words.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/gcode_words.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace patchmill::gcode {
namespace {

bool blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

constexpr double kGreatest = 1e12;

// The number at `i`, which moves behind it. Locale-free, and no slower than the machine's own.
void number_at(std::string_view text, std::size_t& i, long line, GcodeWord& word) {
  while (i < text.size() && blank(text[i])) ++i;
  std::size_t begin = i;
  if (begin < text.size() && text[begin] == '+') ++begin;
  const std::size_t digits = begin + (begin == i && begin < text.size() && text[begin] == '-');
  const bool plain =
      digits < text.size() && (text[digits] == '.' || (text[digits] >= '0' && text[digits] <= '9'));
  const auto [end, error] = std::from_chars(text.data() + begin, text.data() + text.size(),
                                            word.value, std::chars_format::fixed);
  if (!plain || error != std::errc() || !(std::abs(word.value) <= kGreatest))
    refuse_gcode(line, std::string(text),
                 "a word has no plain number: expressions and variables "
                 "are not read.");
  i = static_cast<std::size_t>(end - text.data());
  word.point = text.substr(digits, i - digits).find('.') != std::string_view::npos;
}

}  // namespace

void refuse_gcode(long line, const std::string& text, const std::string& remedy) {
  throw InputError(fmt::format("G-code line {}", line), "'" + text + "'", remedy);
}

std::vector<GcodeWord> gcode_words(std::string_view text, long line) {
  stop_point();
  std::vector<GcodeWord> words;
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first != std::string_view::npos && text[first] == '%' &&
      text.find_first_not_of(" \t\r", first + 1) == std::string_view::npos)
    return words;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (blank(c)) {
      ++i;
    } else if (c == ';') {
      break;
    } else if (c == '(') {
      const std::size_t close = text.find(')', i);
      if (close == std::string_view::npos)
        refuse_gcode(line, std::string(text), "a comment is not closed.");
      i = close + 1;
    } else if ((c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z')) {
      GcodeWord word{c >= 'a' ? static_cast<char>(c - 'a' + 'A') : c};
      ++i;
      if (word.letter == 'O') refuse_gcode(line, std::string(text), "O-words are not read.");
      number_at(text, i, line, word);
      if (word.letter != 'N') words.push_back(word);
    } else {
      refuse_gcode(line, std::string(text), fmt::format("'{}' is not read.", c));
    }
  }
  return words;
}

}  // namespace patchmill::gcode

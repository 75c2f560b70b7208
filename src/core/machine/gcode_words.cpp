// Splitting G-code lines; see gcode_words.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/machine/gcode_words.h"

#include "core/geometry/error.h"

#include <cctype>
#include <charconv>

#include <fmt/format.h>

namespace patchmill {
namespace {

bool blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

// The number at `i`, which moves behind it. Locale-free, and no slower than the machine's own.
double number_at(std::string_view text, std::size_t& i, long line) {
  while (i < text.size() && blank(text[i])) ++i;
  std::size_t begin = i;
  if (begin < text.size() && text[begin] == '+') ++begin;
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data() + begin, text.data() + text.size(), value,
                                            std::chars_format::fixed);
  if (error != std::errc())
    refuse_gcode(line, std::string(text),
                 "a word has no plain number: expressions and variables "
                 "are not read.");
  i = static_cast<std::size_t>(end - text.data());
  return value;
}

}  // namespace

void refuse_gcode(long line, const std::string& text, const std::string& remedy) {
  throw InputError(fmt::format("G-code line {}", line), "'" + text + "'", remedy);
}

std::vector<GcodeWord> gcode_words(std::string_view text, long line) {
  std::vector<GcodeWord> words;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (blank(c) || c == '%') {
      ++i;
    } else if (c == ';') {
      break;
    } else if (c == '(') {
      const std::size_t close = text.find(')', i);
      if (close == std::string_view::npos)
        refuse_gcode(line, std::string(text), "a comment is not closed.");
      i = close + 1;
    } else if (std::isalpha(static_cast<unsigned char>(c))) {
      const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
      ++i;
      if (letter == 'O') refuse_gcode(line, std::string(text), "O-words are not read.");
      const double value = number_at(text, i, line);
      if (letter != 'N') words.push_back({letter, value});
    } else {
      refuse_gcode(line, std::string(text), fmt::format("'{}' is not read.", c));
    }
  }
  return words;
}

}  // namespace patchmill

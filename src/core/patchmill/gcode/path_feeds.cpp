// F words of a path's text; see path_feeds.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/path_feeds.h"

#include "patchmill/geometry/error.h"

#include <charconv>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace patchmill::gcode {
namespace {

constexpr double kHalfUnit = 0.5e-6;
constexpr double kRounding = 1e-12;

// Calls word(begin of the number, its end, value) for every F word.
template <class Word>
void each_feed(std::string_view text, const Word& word) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(') {
      const std::size_t close = text.find_first_of(")\n", i);
      if (close == std::string_view::npos) return;
      i = close;
    } else if (text[i] == 'F') {
      double value = 0.0;
      const char* begin = text.data() + i + 1;
      const auto [end, error] =
          std::from_chars(begin, text.data() + text.size(), value, std::chars_format::fixed);
      if (error != std::errc()) continue;
      const auto last = static_cast<std::size_t>(end - text.data());
      word(i + 1, last, value);
      i = last - 1;
    }
  }
}

}  // namespace

std::vector<double> feeds_of(std::string_view text) {
  std::vector<double> feeds;
  each_feed(text, [&](std::size_t, std::size_t, double value) { feeds.push_back(value); });
  return feeds;
}

std::string with_feeds(const std::string& text, const std::vector<double>& feeds) {
  for (const double feed : feeds) require_in_range("feeds", feed, 0.0, 1e9, "mm/s");
  std::string out;
  out.reserve(text.size() + 8 * feeds.size());
  std::size_t n = 0, from = 0;
  bool same = true;
  each_feed(text, [&](std::size_t begin, std::size_t end, double value) {
    same = same && n < feeds.size() &&
           std::abs(feeds[n] - value) <= kHalfUnit + kRounding * std::abs(value);
    if (!same) return;
    out.append(text, from, begin - from);
    fmt::format_to(std::back_inserter(out), "{:.12f}", feeds[n++]);
    from = end;
  });
  if (!same || n != feeds.size()) return text;
  return out.append(text, from, std::string::npos);
}

}  // namespace patchmill::gcode

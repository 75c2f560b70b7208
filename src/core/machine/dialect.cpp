// Lines of the dialects as RS-274 words; see dialect.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/machine/dialect.h"

#include "core/geometry/error.h"

#include <charconv>
#include <cstdlib>

namespace patchmill {
namespace {

bool starts(std::string_view text, std::string_view with) {
  return text.substr(0, with.size()) == with;
}
std::string_view trimmed(std::string_view text) {
  const std::size_t a = text.find_first_not_of(" \t\r");
  if (a == std::string_view::npos) return {};
  return text.substr(a, text.find_last_not_of(" \t\r") - a + 1);
}
// Without a block number: "N10 G1" -> "G1", "12 L X+1" -> "L X+1".
std::string_view without_number(std::string_view text, bool bare) {
  std::size_t i = 0;
  if (!bare && !text.empty() && (text[0] == 'N' || text[0] == 'n')) i = 1;
  if (!bare && i == 0) return text;
  const std::size_t digits = i;
  while (i < text.size() && text[i] >= '0' && text[i] <= '9') ++i;
  return i > digits ? trimmed(text.substr(i)) : text;
}

double number_after(std::string_view text, std::string_view mark, long line) {
  const std::size_t at = text.find(mark);
  std::string_view rest = text.substr(at + mark.size());
  if (starts(rest, "+")) rest.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  if (error != std::errc()) refuse_gcode(line, std::string(text), "a number is missing.");
  (void)end;
  return value;
}

using Words = std::vector<GcodeWord>;

Words fanuc(std::string_view text, long line) {
  const std::string_view body = trimmed(text);
  if (starts(body, "O")) return {};  // the program's number and name
  Words words = gcode_words(body, line);
  for (const GcodeWord& w : words)
    if (w.letter == 'G' && w.value == 5.1) return {};  // look-ahead smoothing
  return words;
}

Words siemens(std::string_view text, long line) {
  const std::string_view body = without_number(trimmed(text), false);
  const std::string_view code = trimmed(body.substr(0, body.find(';')));
  if (code.empty() || starts(code, "MSG(") || starts(code, "CYCLE832")) return {};
  if (starts(code, "TRAORI")) return {{'G', 43.4}};
  if (starts(code, "TRAFOOF")) return {{'G', 49.0}};
  if (starts(code, "ORI")) return {};  // how the orientation is interpolated: axis by axis
  if (starts(code, "G641 ADIS=")) return {{'G', 64.0}, {'P', number_after(code, "ADIS=", line)}};
  Words words = gcode_words(code, line);
  for (GcodeWord& w : words) {
    if (w.letter != 'G') continue;
    if (w.value == 710.0 || w.value == 71.0) w.value = 21.0;
    if (w.value == 700.0 || w.value == 70.0) w.value = 20.0;
    if (w.value == 60.0) w.value = 61.0;
    if (w.value == 500.0) w.value = 54.0;
  }
  return words;
}

// L X+1.000 Y-2.000 A+10.000 R0 FMAX M3
Words straight_line(std::string_view code, long line) {
  Words words;
  std::string plain;
  bool rapid = false;
  double seconds = 0.0;
  for (std::size_t i = 1; i < code.size();) {
    const std::size_t end = std::min(code.find(' ', i), code.size());
    const std::string_view word = code.substr(i, end - i);
    i = end + 1;
    if (word.empty() || word == "R0") continue;
    if (word == "FMAX")
      rapid = true;
    else if (starts(word, "FT"))
      seconds = number_after(word, "FT", line);
    else
      plain += std::string(word) + " ";
  }
  if (seconds > 0.0) {
    words = {{'G', 93.0}, {'G', 1.0}, {'F', 60.0 / seconds}};
  } else {
    words = {{'G', 94.0}, {'G', rapid ? 0.0 : 1.0}};
  }
  for (const GcodeWord& w : gcode_words(plain, line)) words.push_back(w);
  return words;
}

Words heidenhain(std::string_view text, long line) {
  const std::string_view body = without_number(trimmed(text), true);
  const std::string_view code = trimmed(body.substr(0, body.find(';')));
  if (code.empty() || starts(code, "END PGM") || starts(code, "BLK FORM") ||
      starts(code, "CYCL DEF 32"))
    return {};
  if (starts(code, "BEGIN PGM"))
    return {{'G', code.find(" INCH") == std::string_view::npos ? 21.0 : 20.0}};
  if (starts(code, "FUNCTION TCPM") || starts(code, "M128")) return {{'G', 43.4}};
  if (starts(code, "FUNCTION RESET TCPM") || starts(code, "M129")) return {{'G', 49.0}};
  if (starts(code, "TOOL CALL ")) {
    Words words;
    if (!starts(code, "TOOL CALL S"))
      words = {{'T', number_after(code, "TOOL CALL ", line)}, {'M', 6.0}};
    if (code.find(" S") != std::string_view::npos)
      words.push_back({'S', number_after(code, " S", line)});
    return words;
  }
  if (starts(code, "CYCL DEF 9.0")) return {};
  if (starts(code, "CYCL DEF 9.1"))
    return {{'G', 4.0}, {'P', number_after(code, "9.1 DWELL ", line)}};
  if (starts(code, "L ")) return straight_line(code, line);
  if (starts(code, "M")) return gcode_words(code, line);
  refuse_gcode(line, std::string(text), "this block is not read.");
}

}  // namespace

Dialect dialect_of(const std::string& name) {
  if (name == "linuxcnc") return Dialect::LinuxCnc;
  if (name == "fanuc") return Dialect::Fanuc;
  if (name == "siemens") return Dialect::Siemens;
  if (name == "heidenhain") return Dialect::Heidenhain;
  throw InputError("Dialect", "'" + name + "'", "give linuxcnc, fanuc, siemens or heidenhain.");
}

const char* name(Dialect dialect) {
  constexpr const char* kNames[] = {"linuxcnc", "fanuc", "siemens", "heidenhain"};
  return kNames[static_cast<int>(dialect)];
}

std::vector<GcodeWord> dialect_words(Dialect dialect, std::string_view line, long number) {
  switch (dialect) {
    case Dialect::Fanuc:
      return fanuc(line, number);
    case Dialect::Siemens:
      return siemens(line, number);
    case Dialect::Heidenhain:
      return heidenhain(line, number);
    case Dialect::LinuxCnc:
      break;
  }
  return gcode_words(line, number);
}

const char* lead_letters(Dialect dialect) {
  return dialect == Dialect::Fanuc ? "F" : dialect == Dialect::Siemens ? "IJK" : "K";
}

}  // namespace patchmill

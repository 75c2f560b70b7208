// What all controls share; see control.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/controls/control.h"

#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

namespace patchmill::gcode {
namespace {

bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}
char small(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
char capital(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

// A sign of a comment as the control may have it; 0: it is left out.
char comment_sign(const CommentRules& rules, char c) {
  if (c == '(' || c == ')' || c == ';') return 0;
  if (c < ' ' || c > '~') return '?';
  const bool plain = is_letter(c) || (c >= '0' && c <= '9') || c == ' ';
  if (!plain && !rules.plain.empty() && rules.plain.find(c) == std::string_view::npos) return ' ';
  return rules.capitals ? capital(c) : c;
}

// Whether the control would act on a comment that begins so; blanks and underscores do not hide it.
bool is_active(const CommentRules& rules, std::string_view text) {
  std::string bare;
  for (const char c : text)
    if (c != ' ' && c != '_') bare += small(c);
  return std::any_of(rules.active.begin(), rules.active.end(), [&](std::string_view begin) {
    return bare.compare(0, begin.size(), begin) == 0;
  });
}

const CodeWord* found(const std::vector<CodeWord>& codes, char letter, int number,
                      int CodeWord::*field) {
  for (const CodeWord& code : codes)
    if (code.letter == letter && code.*field == number && number >= 0) return &code;
  return nullptr;
}

}  // namespace

const CodeWord* Control::meaning(char letter, int means) const {
  return found(codes, letter, means, &CodeWord::means);
}
const CodeWord* Control::word(char letter, int own) const {
  return found(codes, letter, own, &CodeWord::own);
}

const Control& control_of(std::string_view name) {
  std::string names;
  for (const Control* control : controls()) {
    if (control->name == name) return *control;
    names += (names.empty() ? "" : ", ") + std::string(control->name);
  }
  throw InputError("Dialect", "'" + std::string(name) + "'", "give one of: " + names + ".");
}

std::string code_text(char letter, int tenths) {
  return tenths % 10 == 0 ? fmt::format("{}{}", letter, tenths / 10)
                          : fmt::format("{}{}.{}", letter, tenths / 10, tenths % 10);
}

std::string safe_comment(const CommentRules& rules, std::string_view text) {
  std::string plain;
  for (const char c : text)
    if (const char sign = comment_sign(rules, c)) plain += sign;
  if (is_active(rules, plain)) plain.insert(0, "- ");
  if (plain.size() > rules.max_length) plain.resize(rules.max_length);
  return rules.round ? "(" + plain + ")" : "; " + plain;
}

std::string filled(std::string text, std::string_view mark, std::string_view value) {
  const std::string place = "{" + std::string(mark) + "}";
  for (std::size_t at = text.find(place); at != std::string::npos;
       at = text.find(place, at + value.size()))
    text.replace(at, place.size(), value);
  return text;
}

}  // namespace patchmill::gcode

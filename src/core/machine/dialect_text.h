// What the dialects of dialect.h say in words of their own: the fixed lines of a program, and the few blocks
// that each puts differently. The moves, which all have, are program_text.h's affair.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "core/geometry/vec.h"
#include "core/machine/dialect.h"

#include <string>

namespace patchmill {

/// The fixed words of a dialect. "{tool}" in a text is the tool's number.
struct DialectWords {
  std::string preamble, postamble;  ///< lines
  std::string tcp_on, tcp_off, inverse, per_minute, exact_stop;
  std::string
      rounding;  ///< path mode that rounds corners, where it has no tolerance word of its own
};
DialectWords words_of(Dialect dialect);

/// `text` with the tool's number in the place of "{tool}".
std::string with_number(std::string text, int tool);

/// Path mode that rounds corners by up to `within` [mm]; "" where the dialect has none.
std::string rounding_text(Dialect dialect, double within);

/// Lines that wait for so many seconds.
std::string dwell_text(Dialect dialect, double seconds);

/// G33's lead: the letter that carries it, and mm per turn along the axis that the letter means.
struct LeadWord {
  char letter = 'K';
  double value = 0.0;
};

/// `pitch`: mm per turn along the path; `way`: the move's X Y Z [mm]; `turned`: whether a rotary axis turns in
/// the block. Errors: InputError naming Strategy where the dialect cannot follow the spindle so.
LeadWord lead_word(Dialect dialect, double pitch, const Vec3& way, bool turned);

}  // namespace patchmill

// Words and blocks of the dialects; see dialect_text.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/machine/dialect_text.h"

#include "core/geometry/error.h"

#include <fmt/format.h>

namespace patchmill {

DialectWords words_of(Dialect dialect) {
  switch (dialect) {
    case Dialect::Fanuc:
      return {"G21\nG17 G40 G49 G80 G90 G94",
              "M5\nG49\nM30",
              "G43.4 H{tool}",
              "G49",
              "G93",
              "G94",
              "G61",
              "G64"};
    case Dialect::Siemens:
      return {"G17 G40 G54 G90 G94 G710",
              "M5\nG64\nM30",
              "TRAORI\nORIMKS ORIAXES",
              "TRAFOOF",
              "G93",
              "G94",
              "G60",
              "G64"};
    case Dialect::Heidenhain:
      return {"", "M5\nM30", "M128", "M129", "", "", "", ""};
    case Dialect::LinuxCnc:
      break;
  }
  return {"G17 G54 G40 G49 G80 G90 G94\nG21",
          "M5\nG61\nG17 G54 G90 G80 G40\nM2",
          "M428",
          "M429",
          "G93",
          "G94",
          "G61",
          "G64"};
}

std::string with_number(std::string text, int tool) {
  const std::size_t at = text.find("{tool}");
  if (at != std::string::npos) text.replace(at, 6, std::to_string(tool));
  return text;
}

std::string rounding_text(Dialect dialect, double within) {
  if (dialect == Dialect::LinuxCnc) return fmt::format("G64 P{:.6f} Q0", within);
  if (dialect == Dialect::Siemens) return fmt::format("G641 ADIS={:.6f}", within);
  return words_of(dialect).rounding;
}

std::string dwell_text(Dialect dialect, double seconds) {
  switch (dialect) {
    case Dialect::Heidenhain:
      return fmt::format("CYCL DEF 9.0 DWELL TIME\nCYCL DEF 9.1 DWELL {:.3f}", seconds);
    case Dialect::Fanuc:  // P is in milliseconds
      return fmt::format("G4 P{:.0f}", 1e3 * seconds);
    case Dialect::Siemens:
      return fmt::format("G4 F{:.3f}", seconds);
    case Dialect::LinuxCnc:
      break;
  }
  return fmt::format("G4 P{:.3f}", seconds);
}

LeadWord lead_word(Dialect dialect, double pitch, const Vec3& way, bool turned) {
  if (dialect == Dialect::LinuxCnc) return {'K', pitch};
  if (dialect == Dialect::Heidenhain)
    throw InputError("Strategy", "Spindle-locked",
                     "Heidenhain's plain text has no block that follows the spindle: use feed per "
                     "move or constant feed.");
  if (turned)
    throw InputError(
        "Strategy", "Spindle-locked",
        fmt::format("a rotary axis turns in a G33 block, which {} cannot: keep one tool axis for "
                    "the whole texture, or use feed per move.",
                    name(dialect)));
  Eigen::Index most = 0;
  const double longest = way.cwiseAbs().maxCoeff(&most), length = way.norm();
  const double along = length > 0.0 ? pitch * longest / length : pitch;
  return {dialect == Dialect::Fanuc ? 'F' : "IJK"[most], along};
}

}  // namespace patchmill

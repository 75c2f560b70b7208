// The dialects of G-code that PatchMill writes itself, each read back by the project's own reader:
//     LinuxCNC     RS-274; G33 K; G64 P; TCP by M428 / M429 (words of the machine's configuration)
//     Fanuc        G43.4 H / G49; G05.1 Q1; G33 F with the lead along the axis that moves most
//     Siemens      840D: TRAORI / TRAFOOF; G60 / G641 ADIS=; G33 with I, J or K by that axis
//     Heidenhain   plain text: L X+1.000 ... FMAX; M128 / M129; no inverse time, F or FT instead
// From the controls' public documentation; programs for LinuxCNC are tried on it, the others on no control.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "core/machine/gcode_words.h"

#include <cstdint>

namespace patchmill {

enum class Dialect : std::uint8_t { LinuxCnc, Fanuc, Siemens, Heidenhain };

/// "linuxcnc", "fanuc", "siemens", "heidenhain". Errors: InputError naming Dialect.
Dialect dialect_of(const std::string& name);
const char* name(Dialect dialect);

/// The words of one line of a program in `dialect`, as RS-274 would have them: TCP on and off are G43.4
/// and G49; a rapid of Heidenhain is G0, its FT comes as G93 with F in 1/min; Siemens' G641 ADIS= is G64 P.
/// G33's lead stays what it is (see lead_letters). Errors: InputError "G-code line n" for words that are
/// not known.
std::vector<GcodeWord> dialect_words(Dialect dialect, std::string_view line, long number);

/// The letters that carry G33's lead: "K" along the path (LinuxCNC); "F" or "IJK" along the axis that
/// moves most.
const char* lead_letters(Dialect dialect);

}  // namespace patchmill

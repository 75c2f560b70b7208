// The phase rule: how far the spindle turns from one dimple to the next (Xu & Sasahara 2016, Eq. 2
// and section 3.3):
//     Lambda_k = ((s (alpha_{k+1} - alpha_k)) mod M) + extra + step
// s = -1 for M3, +1 for M4; M = 2 pi / N if any flute may cut, 2 pi if always the same one.
// The paper's numbers: extra = 1800 degrees; step = 1 degree on the calibration patch, else 0.
// Deviation: the paper does not say whether lambda is taken modulo one flute or one turn; its "5 to
// 6 turns per dimple" is the same flute. Both are offered.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/angle.h"
#include "patchmill/patch/dimple.h"
#include "patchmill/path/tool_path.h"

#include <vector>

namespace patchmill::sync {

enum class FluteChoice : std::uint8_t {
  Any,  ///< M = 2 pi / N: fewest turns; runout shows as two kinds of dimples
  Same  ///< M = 2 pi: one flute makes all dimples; runout cannot show
};

/// M. Errors: InputError naming Flutes if `flutes` is not in 1..32.
Angle phase_period(int flutes, FluteChoice choice);

/// Which phase is wanted at each dimple.
struct PhaseRule {
  FluteChoice flutes = FluteChoice::Any;
  double extra_turns = 0.0;  ///< whole multiple of the period, >= 0 [turns]
  Angle step;                ///< added per dimple; >= 0
  /// Contact azimuth of each dimple by its number, as postures give it (postures.h); empty: a fixed
  /// vertical tool.
  std::vector<Angle> azimuths = {};
};

/// Errors: InputError naming ExtraTurns or PhaseStep.
void require_valid(const PhaseRule& rule, int flutes);

/// Contact azimuth of dimple k, which is Cut. Errors: InputError naming ToolAxis if the rule's
/// azimuths are of other dimples.
Angle contact_azimuth(const patch::Dimples& dimples, std::size_t k, const PhaseRule& rule);

/// Lambda from contact azimuth `from` to `to`; >= 0. A difference that is a whole period but for
/// rounding (1e-9 rad) counts as none.
Angle spindle_advance(Angle from, Angle to, const PhaseRule& rule, const Tool& tool,
                      const Spindle& spindle);

/// The spindle angle, modulo the phase period, that each dimple wants, indexed by dimple number:
/// its contact azimuth plus s * step for each Cut dimple before it. NaN radians where a dimple is
/// left out.
std::vector<Angle> wanted_phases(const patch::Dimples& dimples, const PhaseRule& rule,
                                 const Spindle& spindle);

}  // namespace patchmill::sync

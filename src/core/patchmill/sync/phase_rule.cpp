// The phase rule; see phase_rule.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/phase_rule.h"

#include "patchmill/geometry/error.h"
#include "patchmill/sync/contact_azimuth.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace patchmill::sync {

Angle phase_period(int flutes, FluteChoice choice) {
  require_in_range("Flutes", flutes, 1, 32, "flutes");
  return Angle::turns(choice == FluteChoice::Any ? 1.0 / flutes : 1.0);
}

void require_valid(const PhaseRule& rule, int flutes) {
  require_in_range("ExtraTurns", rule.extra_turns, 0.0, 1e6, "turns");
  const double periods = rule.extra_turns / phase_period(flutes, rule.flutes).turns();
  if (std::abs(periods - std::round(periods)) > 1e-9)
    throw InputError("ExtraTurns", fmt::format("{}", rule.extra_turns),
                     fmt::format("give a whole multiple of {} turn, so that a flute is at the "
                                 "contact point again.",
                                 phase_period(flutes, rule.flutes).turns()));
  require_in_range("PhaseStep", rule.step.degrees(), 0.0, 360.0, "degrees");
}

Angle contact_azimuth(const patch::Dimples& dimples, std::size_t k, const PhaseRule& rule) {
  if (rule.azimuths.empty()) return contact_azimuth(dimples[k].surface.normal);
  if (rule.azimuths.size() != dimples.size() || std::isnan(rule.azimuths[k].radians()))
    throw InputError("ToolAxis", fmt::format("no posture for dimple {}", k),
                     "plan the postures of these dimples.");
  return rule.azimuths[k];
}

Angle spindle_advance(Angle from, Angle to, const PhaseRule& rule, const Tool& tool,
                      const Spindle& spindle) {
  const Angle period = phase_period(tool.flutes, rule.flutes);
  Angle lambda = (spindle.sign() * (to - from)).wrapped(period);
  if (period - lambda < Angle::radians(1e-9)) lambda = Angle();
  return lambda + Angle::turns(rule.extra_turns) + rule.step;
}

std::vector<Angle> wanted_phases(const patch::Dimples& dimples, const PhaseRule& rule,
                                 const Spindle& spindle) {
  std::vector<Angle> wanted(dimples.size(),
                            Angle::radians(std::numeric_limits<double>::quiet_NaN()));
  Angle shift;
  for (std::size_t k = 0; k < dimples.size(); ++k) {
    if (dimples[k].state != patch::DimpleState::Cut) continue;
    wanted[k] = contact_azimuth(dimples, k, rule) + shift;
    shift += spindle.sign() * rule.step;
  }
  return wanted;
}

}  // namespace patchmill::sync

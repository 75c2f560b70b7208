// Kienzle's law; see cutting_load.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/load/cutting_load.h"

#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cmath>

namespace patchmill::load {
namespace {

constexpr double kWatt = 1000.0;  // N mm/s

void require_limit(const char* property, double value, const char* unit) {
  if (!(value > 0.0)) require_positive(property, value, unit);  // infinite: no limit
}

}  // namespace

void require_valid(const Resistance& resistance) {
  require_positive("SpecificForce", resistance.specific, "N/mm2");
  require_in_range("SpecificForce", resistance.specific, 0.0, 1e5, "N/mm2");
  require_in_range("ForceExponent", resistance.exponent, 0.0, 0.9, "");
  require_in_range("NormalForce", resistance.normal, 0.0, 5.0, "");
}

void require_valid(const LoadLimits& limits) {
  require_limit("ChipLimit", limits.chip, "mm");
  require_limit("ForceLimit", limits.force, "N");
  require_limit("PowerLimit", limits.power, "W");
}

Load load_at(const Engagement& engagement, const Resistance& resistance, double feed,
             double teeth) {
  const double fz = feed / teeth, m = resistance.exponent;
  Load load;
  load.removal = engagement.section * feed;
  load.chip = engagement.chip * fz;
  load.force = resistance.specific * std::pow(fz, 1.0 - m) * engagement.force;
  load.power = resistance.specific * std::pow(fz, -m) * engagement.power * feed / kWatt;
  return load;
}

double largest_feed(const Engagement& engagement, const Resistance& resistance,
                    const LoadLimits& limits, double teeth) {
  // force and power go with f_z^(1 - m_c), the chip with f_z
  const double power = 1.0 / (1.0 - resistance.exponent);
  double fz = std::numeric_limits<double>::infinity();
  const auto keep = [&](double limit, double at_one, double exponent) {
    if (at_one > 0.0) fz = std::min(fz, std::pow(limit / at_one, exponent));
  };
  keep(limits.chip, engagement.chip, 1.0);
  keep(limits.force, resistance.specific * engagement.force, power);
  keep(limits.power, resistance.specific * engagement.power * teeth / kWatt, power);
  return fz * teeth;
}

}  // namespace patchmill::load

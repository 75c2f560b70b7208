// What the planners of paths for a fixed vertical tool start from: the dimples that are milled, as places of
// the tool tip on the program's decimals with the azimuth that a flute must have there; and what every such
// planner asks of tool, spindle and heights.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/path/rounding.h"
#include "patchmill/sync/phase_rule.h"

#include <vector>

namespace patchmill::sync {

/// A dimple that is cut, with what pacing needs of it.
struct PlannedDimple {
  Vec3 tip;       ///< p + (R - depth) n - R e_z, on the decimals [mm]
  Vec3 normal;    ///< unit, out of the material
  Angle azimuth;  ///< of the contact point (Xu & Sasahara 2016, section 3.1)
  std::int32_t number, patch;
};

/// The Cut dimples in their order; `radius` of the ball [mm]. Errors: InputError naming ToolAxis (see
/// contact_azimuth).
std::vector<PlannedDimple> planned_dimples(const patch::Dimples& dimples, double radius,
                                           const PhaseRule& rule, const Decimals& decimals);

/// Errors: InputError naming SpindleSpeed or ToolDiameter unless both are greater than zero.
void require_turning_tool(const Tool& tool, const Spindle& spindle);

/// Z of the tip where it travels over the texture, and before and after it [mm]. Errors: InputError naming
/// ClearanceHeight if that is the lower one, or the one that is not finite.
void require_heights(double safe_height, double clearance_height);

/// Errors: InputError naming SafeHeight if that is less than `lift` over a dimple's tip [mm].
void require_below(double safe_height, const std::vector<PlannedDimple>& planned, double lift);

}  // namespace patchmill::sync

// What the planners of paths for a fixed vertical tool start from: the dimples that are milled, as places of
// the tool tip on the program's decimals with the azimuth that a flute must have there; and what every such
// planner asks of tool, spindle and heights.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/path/rounding.h"
#include "patchmill/sync/fit_length.h"
#include "patchmill/sync/phase_rule.h"

#include <cstddef>
#include <functional>
#include <optional>
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

/// Some of the Cut dimples, in their order, and the turns that each asks for from the one before it (spindle_advance);
/// of the first of all nobody asks.
struct PlannedBatch {
  std::vector<PlannedDimple> planned;
  std::vector<double> turns;
  std::optional<PlannedDimple> before;  ///< the first one
  std::vector<CornerAhead> corners;     ///< for who prepares the batch
};

/// Plans all Cut dimples batch after batch on as many threads as there are, has each batch prepared there, and hands
/// the batches to `take` in their order, one at a time; so memory is that of a few batches. Errors: as planned_dimples,
/// and what `take` throws; `prepare` must not throw.
void in_batches(const patch::Dimples& dimples, const Tool& tool, const Spindle& spindle,
                const PhaseRule& rule, const Decimals& decimals,
                const std::function<void(PlannedBatch&)>& prepare,
                const std::function<void(const PlannedBatch&)>& take);

/// What a path over all Cut dimples will be like.
struct PlannedExtent {
  std::size_t dimples = 0;  ///< Cut
  std::size_t gaps = 0;     ///< before a dimple that does not follow the one before it in its patch
  std::int32_t too_high = -1;  ///< number of the first whose tip is above the safe height, or -1
  double z = 0.0;              ///< of that tip [mm]
};
PlannedExtent planned_extent(const patch::Dimples& dimples, double radius, const Decimals& decimals,
                             double safe_height);

/// Errors: InputError naming SpindleSpeed or ToolDiameter unless both are greater than zero.
void require_turning_tool(const Tool& tool, const Spindle& spindle);

/// Z of the tip where it travels over the texture, and before and after it [mm]. Errors: InputError naming
/// ClearanceHeight if that is the lower one, or the one that is not finite.
void require_heights(double safe_height, double clearance_height);

/// Errors: InputError naming SafeHeight if that is less than `lift` over a dimple's tip [mm].
void require_below(double safe_height, const std::vector<PlannedDimple>& planned, double lift);
void require_below(double safe_height, const PlannedExtent& extent);

}  // namespace patchmill::sync

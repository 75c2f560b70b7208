// Dimples as places of the tool tip; see planned_dimples.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/planned_dimples.h"

#include "patchmill/geometry/require.h"

#include <fmt/format.h>

namespace patchmill::sync {

std::vector<PlannedDimple> planned_dimples(const patch::Dimples& dimples, double radius,
                                           const PhaseRule& rule, const Decimals& decimals) {
  std::vector<PlannedDimple> planned;
  planned.reserve(dimples.size());
  for (std::size_t k = 0; k < dimples.size(); ++k) {
    const patch::Dimple& dimple = dimples[k];
    if (dimple.state != patch::DimpleState::Cut) continue;
    const Vec3& n = dimple.surface.normal;
    const Vec3 centre = dimple.surface.position + (radius - dimple.depth) * n;
    const Vec3 tip = centre - radius * Vec3::UnitZ();
    planned.push_back({decimals.round(tip), n, contact_azimuth(dimples, k, rule),
                       static_cast<std::int32_t>(k), dimple.patch});
  }
  return planned;
}

constexpr double kMaxRadius = 1e5;  // mm: of larger ones a surface has no curvature left

void require_turning_tool(const Tool& tool, const Spindle& spindle) {
  require_positive("SpindleSpeed", spindle.speed * 60.0, "rpm");
  require_valid(tool);
  require_ball(tool, "textures are milled");
  require_in_range("BallRadius", tool.radius, 0.0, kMaxRadius, "mm");
}

void require_heights(double safe_height, double clearance_height) {
  require_finite("SafeHeight", safe_height, "mm");
  require_finite("ClearanceHeight", clearance_height, "mm");
  if (!(clearance_height >= safe_height))
    throw InputError("ClearanceHeight", fmt::format("{} mm", clearance_height),
                     fmt::format("give at least the safe height, {} mm.", safe_height));
}

void require_below(double safe_height, const std::vector<PlannedDimple>& planned, double lift) {
  for (const PlannedDimple& p : planned)
    if (p.tip.z() + lift > safe_height)
      throw InputError(
          "SafeHeight", fmt::format("{} mm", safe_height),
          fmt::format("the tool tip is at Z {:.3f} mm on dimple {}: give a greater safe height.",
                      p.tip.z(), p.number));
}

}  // namespace patchmill::sync

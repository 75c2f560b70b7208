// Contact azimuth and tilt; see contact_azimuth.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/contact_azimuth.h"

#include "patchmill/geometry/require.h"
#include "patchmill/geometry/stop.h"

#include <cmath>

#include <tbb/blocked_range.h>

namespace patchmill::sync {

Angle tilt(const Vec3& normal, const Vec3& axis) {
  return Angle::between(normal, axis);
}

Angle contact_azimuth(const Vec3& n) {
  return Angle::radians(std::atan2(-n.y(), -n.x()));
}

patch::DimpleState state_of_tilt(Angle tilt, Angle least_tilt) {
  if (tilt < least_tilt) return patch::DimpleState::ToolTip;
  return tilt.degrees() < 90.0 ? patch::DimpleState::Cut : patch::DimpleState::Undercut;
}

void mark_tool_tip(patch::Dimples& dimples, const Vec3& axis, Angle least_tilt) {
  require_in_range("MinimumTilt", least_tilt.degrees(), 1e-6, 89.0, "degrees");
  const Vec3 t_axis = unit_along("ToolAxis", axis);
  constexpr std::size_t kLeast = 4096;
  patchmill::parallel_for(tbb::blocked_range<std::size_t>(0, dimples.size(), kLeast),
                          [&](const tbb::blocked_range<std::size_t>& range) {
                            for (std::size_t k = range.begin(); k < range.end(); ++k) {
                              patch::Dimple& dimple = dimples[k];
                              if (dimple.state == patch::DimpleState::Cut)
                                dimple.state =
                                    state_of_tilt(tilt(dimple.surface.normal, t_axis), least_tilt);
                            }
                          });
}

}  // namespace patchmill::sync

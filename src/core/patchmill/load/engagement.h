// Engagement of a tool with the stock that is left, from the samples of the voxels that it takes (air_cuts.h). While
// the tool goes a way ds in the direction d, an element dA of its surface with the normal n takes the volume
//     dV = (n . d) dA ds
// if there is material before it. So a sample that is taken stands for the element that took it, and every integral
// over the surface at work is a sum over samples: of any shape of tool, stock and engagement, and the volumes are those
// that are taken. An edge at the angle phi has F_c(phi) = integral of k_c h over its length,
// (n . d) dA / (r dphi) each.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/load/cutting_load.h"

#include <array>
#include <vector>

namespace patchmill::load {

constexpr int kAngles = 72;  ///< in which a turn of the tool is divided: 5 degrees each

/// Force of an edge on the tool.
struct EdgeForce {
  double cutting = 0.0;  ///< against the way of the edge
  double inward = 0.0;   ///< towards the axis
  double upward = 0.0;   ///< along the axis
};

/// Sums over the samples of one or more steps of a tool.
struct EngagedSums {
  double length = 0.0;  ///< of the way [mm]
  double volume = 0.0;  ///< taken [mm^3]
  double area = 0.0;    ///< sum of dV / (n . d) [mm^3]
  double power = 0.0;   ///< sum of dV (n . d)^-m_c [mm^3]
  std::array<EdgeForce, kAngles>
      edge{};  ///< at each angle about the axis, times the way [mm^2], k_c1.1 f_z^(1-m_c) = 1

  /// Adds those of another step.
  void add(const EngagedSums& other);
};

/// The sums of a straight step of the tool's centre (tool.h) in which `samples` [mm] of `sample_volume` [mm^3] each
/// were taken; its axis may turn. A step without length has none.
EngagedSums sums_of(const ToolPose& from, const ToolPose& to, const Tool& tool,
                    const Resistance& resistance, const std::vector<Vec3>& samples,
                    double sample_volume);

/// The engagement of a tool with `flutes` >= 1 straight edges, evenly spaced, that turns as the spindle does.
Engagement engagement_of(const EngagedSums& sums, int flutes, SpindleSense sense);

}  // namespace patchmill::load

// Collision-aware posture: the axis yields before shank or holder come nearer to the part than a stated
// distance. Kobayashi & Shirase 2014, section 4.2, left collisions out.
//
// Each section of the tool is a frustum, and the part's tree is searched for the least distance from it
// (frustum_search.h). A point of the part that was in the way of one axis is tried first with the next. The ball
// itself touches the part and is not looked at.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/collision/frustum.h"
#include "patchmill/mesh/triangle_bvh.h"
#include "patchmill/path/tool_path.h"

#include <vector>

namespace patchmill::collision {

/// A section of shank or holder; heights above the tool's centre (tool.h) [mm], 0 < from.
using HolderSection = Frustum;

/// What clear_axis keeps to.
struct ClearOptions {
  double clearance = 1.0;             ///< that is kept between holder and part [mm], > 0, <= 1e4
  double resolution = 0.05;           ///< to which distances are found [mm], 1e-6 .. 1e4
  Angle most = Angle::degrees(90);    ///< that the axis may yield, in (0, 180] degrees
  Angle lowest = Angle::degrees(90);  ///< greatest angle of the axis to +z, in (0, 180] degrees
};

/// Smallest distance [mm] of the sections from the part, to the resolution; 0 if they reach into it; no
/// more than `enough`, beyond which nothing is looked for. Options and sections are not checked.
double holder_distance(const mesh::TriangleBvh& part, const std::vector<HolderSection>& holder,
                       const Vec3& centre, const Vec3& axis, double resolution, double enough);

/// An axis that was found.
struct ClearAxis {
  Vec3 axis = Vec3::UnitZ();
  bool clear =
      false;  ///< false: no axis within `most` of the wanted one is; then `axis` is the wanted
};

/// The axis nearest to `wanted` with which the holder is no nearer to the part than the clearance, the ball at
/// `centre`; one that clears it by less than the resolution may be left out. Errors: InputError naming an option
/// or a section out of range.
ClearAxis clear_axis(const mesh::TriangleBvh& part, const std::vector<HolderSection>& holder,
                     const Vec3& centre, const Vec3& wanted, const ClearOptions& options = {});

/// Where a path comes too near: every timed move is looked at in steps of at most `step` [mm, 1e-3 .. 1e6] of
/// the tip and 1 degree of the axis. Errors: InputError naming the step, an option or a section out of range.
struct PathClearance {
  double least = 0.0;         ///< smallest distance found [mm], no more than twice the clearance
  std::int64_t move = -1;     ///< the move where it is
  std::int64_t too_near = 0;  ///< moves that come nearer than the clearance less the resolution
};
PathClearance path_clearance(const mesh::TriangleBvh& part,
                             const std::vector<HolderSection>& holder, const ToolPath& path,
                             const ClearOptions& options, double step = 0.5);

}  // namespace patchmill::collision

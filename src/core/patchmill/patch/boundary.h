// Which dimples are left out at the borders of a texture: too steep, too near an edge, or in a
// patch of which too little is on the faces. Each changes states from Cut to the reason; the order
// and number of dimples stay.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/angle.h"
#include "patchmill/patch/dimple.h"

namespace patchmill::patch {

/// Cut dimples whose normal is further than `limit` from -direction become TooSteep, or Undercut if
/// it looks away altogether. `direction` is unit, into the material.
/// Errors: InputError naming SteepnessLimit if it is not in (0°, 90°].
void limit_steepness(Dimples& dimples, const Vec3& direction, Angle limit);

/// A straight piece of an edge, as edges are discretised [mm].
struct Segment3 {
  Vec3 a, b;
};

/// Cut dimples nearer than `margin` to any of the segments (straight distance in space) become
/// NearEdge. Time grows with the dimples and with the edges' length over the margin.
/// Errors: InputError naming Margin if it is negative or not finite. 0 leaves all as they are.
void keep_off_edges(Dimples& dimples, const std::vector<Segment3>& edges, double margin);

/// Cut dimples of patches that have fewer than `least` of them become Sliver.
/// Errors: InputError naming MinimumDimples if it is negative.
void drop_slivers(Dimples& dimples, int least);

}  // namespace patchmill::patch

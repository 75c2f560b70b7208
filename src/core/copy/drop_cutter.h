// The virtual probe of copy milling: a ball lowered along z until it touches the model. Kobayashi &
// Shirase 2014, section 2 (Fig. 2): a probe copies the surface of the CAD model and leads the tool.
//
// The height is the largest over all triangles of the height at which the ball touches the triangle's face, an
// edge, or a corner. A tree of upper bounds (core/mesh/drop_tree.h) is searched from the highest bound down,
// and what cannot lift the ball above the best contact so far is left out: branch and bound (Land & Doig 1960).
// A search that begins with the triangle which held the ball at a place nearby has a good contact at once, and
// opens little more than one node a level.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "core/mesh/triangle_bvh.h"

#include <limits>
#include <vector>

namespace patchmill {

constexpr double kNoContact = -std::numeric_limits<double>::infinity();

/// Height z of the centre of a ball of `radius` [mm, > 0] that rests on the mesh with its centre
/// over (x, y); kNoContact where no triangle is within its reach. Exact to rounding.
double drop_ball(const TriangleBvh& bvh, double x, double y, double radius);

/// Where a search may begin: the triangle on which the ball rested last, for points that come one after the
/// other. What is found does not depend on it, to the last bit.
struct DropHint {
  std::int32_t triangle = -1;  ///< index into TriangleBvh::triangles() of the same tree; -1: none
};
double drop_ball(const TriangleBvh& bvh, double x, double y, double radius, DropHint& hint);

/// The same for one triangle.
double drop_ball_on(const Triangle& triangle, double x, double y, double radius);

/// Heights for many points, in parallel: `xy` holds the points.
std::vector<double> drop_balls(const TriangleBvh& bvh, const std::vector<Vec2>& xy, double radius);

}  // namespace patchmill

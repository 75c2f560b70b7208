// The virtual probe of copy milling: a ball lowered along z until it touches the model. Kobayashi &
// Shirase 2014, section 2 (Fig. 2): a probe copies the surface of the CAD model and leads the tool.
//
// The height is the largest over all triangles of the height at which the ball touches the
// triangle's face, an edge, or a corner. The tree of boxes (core/voxel/triangle_bvh.h) is searched
// from the highest possible contact down. What a node can lift the ball to is bounded by its box,
// and by the inclined plane that lies over its triangles: over a smooth surface that bound is off
// by the square of the node's size only, so that nearly all triangles under the ball are never
// looked at, and the time for a point grows only with the depth of the tree.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "core/voxel/triangle_bvh.h"

#include <limits>
#include <vector>

namespace patchmill {

constexpr double kNoContact = -std::numeric_limits<double>::infinity();

/// Height z of the centre of a ball of `radius` [mm, > 0] that rests on the mesh with its centre
/// over (x, y); kNoContact where no triangle is within its reach. Exact to 1e-11 mm.
double drop_ball(const TriangleBvh& bvh, double x, double y, double radius);

/// The same for one triangle.
double drop_ball_on(const Triangle& triangle, double x, double y, double radius);

/// Heights for many points, in parallel: `xy` holds the points.
std::vector<double> drop_balls(const TriangleBvh& bvh, const std::vector<Vec2>& xy, double radius);

}  // namespace patchmill

// The virtual probe of copy milling: a ball lowered along z until it touches the model. Kobayashi &
// Shirase 2014, section 2 (Fig. 2): a probe copies the surface of the CAD model and leads the tool.
//
// The height is the largest over all triangles of the height at which the ball touches the triangle's face, an
// edge, or a corner. drop_ball looks for it from the root of a tree (patchmill/copy/drop_search.h); a probe that goes
// from place to place has less to look at (patchmill/copy/drop_probe.h).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/mesh/triangle_bvh.h"

#include <limits>
#include <vector>

namespace patchmill::copy {

constexpr double kNoContact = -std::numeric_limits<double>::infinity();

/// Height z of the centre of a ball of `radius` [mm, > 0] that rests on the mesh with its centre
/// over (x, y); kNoContact where no triangle is within its reach. Exact to rounding.
double drop_ball(const mesh::TriangleBvh& bvh, double x, double y, double radius);

/// The same for one triangle [mm].
double drop_ball_on(const mesh::Triangle& triangle, double x, double y, double radius);

/// Heights for many points [mm], in parallel; the quicker, the nearer each is to the one before.
std::vector<double> drop_balls(const mesh::TriangleBvh& bvh, const std::vector<Vec2>& xy,
                               double radius);

}  // namespace patchmill::copy

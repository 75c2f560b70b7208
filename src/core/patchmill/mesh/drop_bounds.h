// How high triangles can lift a ball that is lowered on them along z: bounds for eight children of a tree
// (patchmill/mesh/drop_tree.h) at a time.
//
// With the ball's axis at c in the plan, radius R, d the distance in the plan from c to the child's box:
//  - on its box the ball rests no higher than       z_top + sqrt(R^2 - d^2)            (none for d >= R);
//  - under its upper bounding plane, of slope g = tan(a), no higher than  g . c + h + R / cos(a) - fall.
// The ball touches that plane at q = c + R sin(a) g / |g|. To touch a place that lies e away from q in the plan it
// must come down by fall >= e^2 / 2R, for sqrt(R^2 - r^2) curves down by 1 / R or more. And if that place lies E
// away from q on the plane: a ball lowered by t reaches (2 R t cos(a))^1/2 around its foot on the plane, which has
// moved by t sin(a), so that E <= (2 R t cos(a))^1/2 + t and
//     fall >= k E^2 / (1 + k E)^2,  k = 1 / (2 R cos(a)).
// Over a smooth surface the upper bounding plane is off by the square of the child's size only. Of a single triangle
// E is the distance to its sides: the bound is the height itself where q is inside.
// Everything is rounded so that a bound is never too low.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/mesh/drop_tree.h"

namespace patchmill::mesh {

/// A ball whose place is known to a box of the plan, as the bounds want it: from the middle of the tree, and a
/// little too large.
struct DropBall {
  float low_x, high_x, low_y, high_y;  ///< its place
  float ahead;                         ///< R, for the place of the contact
  float radius, radius2, half_curve;   ///< R and R^2 rounded up; 1 / 2R rounded down
  float slack;                         ///< what rounding may move a place by
};
/// Over (x, y) [mm], of `radius` [mm, > 0].
DropBall drop_ball_over(const DropTree& tree, double x, double y, double radius);

/// A height [mm] as the bounds want it: from the middle of the tree, and a little too low.
float drop_floor(const DropTree& tree, double z);

/// How high the children of a node, or the triangles of a leaf, can lift the centre of a ball over a place, from
/// the middle of the tree [mm]. Bit i of what is returned: child i can lift it above `best`; only then is its
/// bound set. Never too low, never a bit too few.
unsigned drop_bounds(const DropNode& node, const DropBall& ball, float best, DropNode::Row& bound);
unsigned drop_bounds(const DropLeaf& leaf, const DropBall& ball, float best, DropNode::Row& bound);

/// A floor under the ball's centre while its place is anywhere in a box of the plan: the plane
/// height + slope . (p - middle of the box), a little too low; of the ball's place, the box.
struct DropFloor {
  DropBall ball;
  float middle_x, middle_y, half_x, half_y;  ///< of the box
  float slope_x, slope_y, height;
};
DropFloor drop_floor_over(const DropTree& tree, const Vec2& lo, const Vec2& hi, const Vec2& slope,
                          double height, double radius);

/// Which children can lift the ball's centre above the floor somewhere in the box: bit i for child i. Never
/// one too few.
unsigned drop_above(const DropNode& node, const DropFloor& floor);
unsigned drop_above(const DropLeaf& leaf, const DropFloor& floor);

}  // namespace patchmill::mesh

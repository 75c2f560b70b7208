// How high material stays between the dimples of a ball of radius R whose lowest points form a
// lattice: a point at distance ρ from the nearest of them is left at R - √(R² - ρ²) above them (the
// cusp formula of ball-end milling; ρ²/2R for small ρ). The sweep of the edge along the feed is
// left out: it is the form for feeds slow against the edge.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"

namespace patchmill::patch {

/// Greatest distance of any point of the plane from the nearest point of the lattice with basis a,
/// b: the circumradius of its acute triangle. Errors: InputError naming Lattice if a and b are
/// parallel.
double covering_radius(const Vec2& a, const Vec2& b);

/// Height above the dimples' bottoms at distance `rho` from the nearest one [mm].
/// Errors: InputError naming BallRadius if R is not positive, or naming Spacing if rho > R: the
/// ball does not reach, and material stays as it was.
double cusp_height(double ball_radius, double rho);

/// The distance at which cusp_height() is `height` [mm]. Errors: InputError naming BallRadius, or
/// RidgeHeight if it is not in (0, R].
double cusp_distance(double ball_radius, double height);

/// Highest point left by marks at f_z along passes c apart, each pass offset by `phase` feeds from
/// the one before [mm]: phase 0 is the square array, 1/2 the staggered one.
double peak_height(double ball_radius, double feed_per_tooth, double cross_feed, double phase);

}  // namespace patchmill::patch

// Cusp heights on a lattice of dimples; see ridge.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/ridge.h"

#include "patchmill/geometry/error.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace patchmill::patch {

double covering_radius(const Vec2& first, const Vec2& second) {
  Vec2 a = first, b = second;
  const double area = std::abs(a.x() * b.y() - a.y() * b.x());
  if (!(area > 1e-14 * a.norm() * b.norm()))
    throw InputError("Lattice", fmt::format("({}, {}) and ({}, {})", a.x(), a.y(), b.x(), b.y()),
                     "give two vectors that are not parallel.");
  // Lagrange's reduction to the two shortest vectors, then the sign that makes the triangle acute
  for (bool reduced = false; !reduced;) {
    if (a.squaredNorm() > b.squaredNorm()) std::swap(a, b);
    const double k = std::round(a.dot(b) / a.squaredNorm());
    b -= k * a;
    reduced = k == 0.0 || b.squaredNorm() >= a.squaredNorm();
  }
  if (a.dot(b) < 0.0) b = -b;
  return a.norm() * b.norm() * (a - b).norm() / (2.0 * area);
}

double cusp_height(double ball_radius, double rho) {
  require_positive("BallRadius", ball_radius, "mm");
  if (!(rho <= ball_radius))
    throw InputError("Spacing", fmt::format("{} mm from the nearest dimple", rho),
                     fmt::format("a ball of radius {} mm leaves untouched material between the "
                                 "dimples: choose a smaller spacing or a larger ball.",
                                 ball_radius));
  // the difference in the form that keeps its digits when rho is small
  return rho * rho / (ball_radius + std::sqrt(ball_radius * ball_radius - rho * rho));
}

double cusp_distance(double ball_radius, double height) {
  require_positive("BallRadius", ball_radius, "mm");
  if (!(height > 0.0 && height <= ball_radius))
    throw InputError(
        "RidgeHeight", fmt::format("{} mm", height),
        fmt::format("give a height above 0 and up to the ball's radius, {} mm.", ball_radius));
  return std::sqrt(height * (2.0 * ball_radius - height));
}

double peak_height(double ball_radius, double feed_per_tooth, double cross_feed, double phase) {
  require_positive("FeedPerTooth", feed_per_tooth, "mm");
  require_positive("CrossFeed", cross_feed, "mm");
  const Vec2 along(feed_per_tooth, 0.0), across(phase * feed_per_tooth, cross_feed);
  return cusp_height(ball_radius, covering_radius(along, across));
}

}  // namespace patchmill::patch

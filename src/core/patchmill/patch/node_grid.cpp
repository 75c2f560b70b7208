// Interpolation on grids with missing nodes; see node_grid.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/node_grid.h"

#include <cmath>
#include <limits>

namespace patchmill::patch {
namespace {

const Vec2 kMissing = Vec2::Constant(std::numeric_limits<double>::quiet_NaN());

// Cubic through b at 0 and c at 1 with the slopes that a at -1 and d at 2 suggest; where a or d is
// missing, the parabola through the other three; where both are, the straight line.
Vec2 between(Vec2 a, const Vec2& b, const Vec2& c, Vec2 d, double t) {
  if (t == 0.0) return b;
  if (t == 1.0) return c;
  const bool no_a = !a.allFinite(), no_d = !d.allFinite();
  if (no_a && no_d) return b + t * (c - b);
  if (no_a) a = 3.0 * b - 3.0 * c + d;
  if (no_d) d = 3.0 * c - 3.0 * b + a;
  const Vec2 left = 0.5 * (c - a), right = 0.5 * (d - b);
  const double t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * b + (t3 - 2 * t2 + t) * left + (3 * t2 - 2 * t3) * c +
         (t3 - t2) * right;
}

}  // namespace

NodeGrid::NodeGrid(const LatticePoint& first, const LatticePoint& last)
    : first_(first),
      last_(last),
      columns_(static_cast<std::size_t>(last[0] - first[0] + 1)),
      places_(columns_ * static_cast<std::size_t>(last[1] - first[1] + 1), kMissing) {}

Vec2 NodeGrid::node(const LatticePoint& p) const {
  return holds(p) ? places_[index(p)] : kMissing;
}

Vec2 NodeGrid::along_row(double t, int i, int j) const {
  if (t == 0.0) return node({i, j});
  return between(node({i - 1, j}), node({i, j}), node({i + 1, j}), node({i + 2, j}), t);
}

Vec2 NodeGrid::at(const Vec2& coordinates) const {
  if (!(coordinates.cwiseAbs().maxCoeff() < 1e9)) return kMissing;
  // nodes themselves, but for rounding, need none of their neighbours
  auto snapped = [](double x) { return std::abs(x - std::round(x)) < 1e-9 ? std::round(x) : x; };
  const Vec2 c(snapped(coordinates.x()), snapped(coordinates.y()));
  const int i = static_cast<int>(std::floor(c.x())), j = static_cast<int>(std::floor(c.y()));
  const double u = c.x() - i, v = c.y() - j;
  if (v == 0.0) return along_row(u, i, j);
  return between(along_row(u, i, j - 1), along_row(u, i, j), along_row(u, i, j + 1),
                 along_row(u, i, j + 2), v);
}

}  // namespace patchmill::patch

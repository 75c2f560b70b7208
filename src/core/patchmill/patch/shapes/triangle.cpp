// Triangular patches of m (m + 1) / 2 dimples, upright and inverted ones in turn, on the triangular lattice.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/shapes/shape_traits.h"
#include "patchmill/patch/shapes/walk.h"

namespace patchmill::patch {
namespace {

std::int64_t point_count(PatchSize m) {
  return std::int64_t(m.side) * (m.side + 1) / 2;
}

// Each loop has three points less per side than the one around it and starts one step beyond the end of that one,
// straight on along the first side's direction.
std::vector<LatticePoint> helix(PatchSize size) {
  LatticePoint at{0, 0};
  std::vector<LatticePoint> path{at};
  path.reserve(static_cast<std::size_t>(point_count(size)));
  for (int m = size.side; m > 1; m -= 3) {
    walk(path, at, m - 1, 1, 0);
    walk(path, at, m - 1, -1, 1);
    walk(path, at, m - 2, 0, -1);
    if (m > 3) walk(path, at, 1, 1, 0);
  }
  return path;
}

// All patch corners are at (-1/2, -1/2) plus whole cells, so that they are shared; sides are m+1 and m steps,
// equilateral but for one part in m.
Polygon outline(PatchSize size, bool inverted) {
  const double m = size.side;
  if (inverted) return {{m + 0.5, -0.5}, {m + 0.5, m - 0.5}, {-0.5, m - 0.5}};
  return {{-0.5, -0.5}, {m + 0.5, -0.5}, {-0.5, m - 0.5}};
}

}  // namespace

extern const ShapeTraits kTriangleShape;
const ShapeTraits kTriangleShape{
    "Triangle",
    LatticeKind::Triangular,
    3,
    false,
    true,
    false,
    {1},
    {10000},
    "dimples",
    point_count,
    [](PatchSize m) {
      return std::array{LatticePoint{m.side + 1, 0}, LatticePoint{0, m.side}};
    },
    helix,
    [](PatchSize m, const LatticePoint& p) {
      return LatticePoint{m.side - 1 - p[0] - p[1], p[0]};
    },
    [](PatchSize m, const LatticePoint& p) {
      return LatticePoint{m.side - p[0], m.side - 1 - p[1]};
    },
    outline,
    // rows lean to the right by m/2 of the m+1 steps of a cell
    [](PatchSize s, int x, int y) {
      const int m = s.side;
      return std::pair(LatticePoint{x / 2 - (y * m + m + 1) / (2 * (m + 1)), y}, x % 2 == 1);
    },
    [](PatchSize, const Vec2&) {
      return Vec2(-lattice_place(LatticeKind::Triangular, 1.0, Vec2(-0.5, -0.5)));
    },
};

}  // namespace patchmill::patch

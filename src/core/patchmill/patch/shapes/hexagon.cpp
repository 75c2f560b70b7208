// Hexagonal patches of radius r, 3r² + 3r + 1 dimples, on the triangular lattice.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/shapes/shape_traits.h"
#include "patchmill/patch/shapes/walk.h"

namespace patchmill::patch {
namespace {

std::int64_t point_count(PatchSize r) {
  return 3 * std::int64_t(r.side) * (r.side + 1) + 1;
}

// The last side of ring k stops one short of its start; from there the next step along the first side's direction
// is the start (k-1, 0) of the ring inside.
std::vector<LatticePoint> helix(PatchSize r) {
  LatticePoint at{r.side, 0};
  std::vector<LatticePoint> path{at};
  path.reserve(static_cast<std::size_t>(point_count(r)));
  const int side[6][2] = {{-1, 1}, {-1, 0}, {0, -1}, {1, -1}, {1, 0}, {0, 1}};
  for (int k = r.side; k > 0; --k) {
    for (int s = 0; s < 6; ++s) walk(path, at, s < 5 ? k : k - 1, side[s][0], side[s][1]);
    walk(path, at, 1, side[0][0], side[0][1]);
  }
  return path;
}

// The places nearer to this patch's centre than to any other's; its corners are the centres of the triangles of
// neighbouring patch centres, v and v turned by 60°: (i, j) -> (-j, i + j).
Polygon outline(PatchSize r, bool) {
  Polygon corner;
  Vec2 v(2.0 * r.side + 1.0, -(r.side + 1.0));  // tiling vector, the first clockwise of (r+1, r)
  for (int k = 0; k < 6; ++k) {
    const Vec2 next(-v.y(), v.x() + v.y());
    corner.push_back((v + next) / 3.0);
    v = next;
  }
  return corner;
}

}  // namespace

extern const ShapeTraits kHexagonShape;
const ShapeTraits kHexagonShape{
    "Hexagon",
    LatticeKind::Triangular,
    6,
    false,
    false,
    true,
    {0},
    {5000},
    "steps from the centre to a corner",
    point_count,
    [](PatchSize r) {
      return std::array{LatticePoint{r.side + 1, r.side}, LatticePoint{-r.side, 2 * r.side + 1}};
    },
    helix,
    [](PatchSize, const LatticePoint& p) {
      return LatticePoint{-p[1], p[0] + p[1]};
    },
    nullptr,
    outline,
    // every second column steps down, so that columns stand level
    [](PatchSize, int x, int y) {
      return std::pair(LatticePoint{x, y - x / 2}, false);
    },
    [](PatchSize, const Vec2&) { return Vec2(0.0, 0.0); },
};

}  // namespace patchmill::patch

// Square patches of m x m dimples on the square lattice.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/shapes/shape_traits.h"
#include "patchmill/patch/shapes/walk.h"

#include <algorithm>
#include <cmath>

namespace patchmill::patch {
namespace {

// Then two sides of each length: m-1, m-2, ..., 1, turning left each time.
std::vector<LatticePoint> helix(PatchSize m) {
  LatticePoint at{0, 0};
  std::vector<LatticePoint> path{at};
  path.reserve(std::size_t(m.side) * std::size_t(m.side));
  walk(path, at, m.side - 1, +1, 0);
  const int turn[4][2] = {{0, +1}, {-1, 0}, {0, -1}, {+1, 0}};
  for (int length = m.side - 1, k = 0; length > 0; --length)
    for (int twice = 0; twice < 2; ++twice, ++k)
      walk(path, at, length, turn[k % 4][0], turn[k % 4][1]);
  return path;
}

// As few patches as cover the area, evenly about its middle.
Vec2 anchor(PatchSize m, const Vec2& cells) {
  Vec2 at;
  for (int k = 0; k < 2; ++k) {
    const double patches = std::max(1.0, std::ceil(cells[k] / m.side - 1e-9));
    at[k] = 0.5 - 0.5 * (std::fmod(patches, 2.0) == 0.0 ? 0.0 : m.side);
  }
  return at;
}

}  // namespace

extern const ShapeTraits kSquareShape;
const ShapeTraits kSquareShape{
    "Square",
    LatticeKind::Square,
    4,
    false,
    false,
    false,
    {1},
    {10000},
    "dimples",
    [](PatchSize m) { return std::int64_t(m.side) * m.side; },
    [](PatchSize m) {
      return std::array{LatticePoint{m.side, 0}, LatticePoint{0, m.side}};
    },
    helix,
    [](PatchSize m, const LatticePoint& p) {
      return LatticePoint{m.side - 1 - p[1], p[0]};
    },
    nullptr,
    [](PatchSize s, bool) {
      const double m = s.side - 0.5;
      return Polygon{{-0.5, -0.5}, {m, -0.5}, {m, m}, {-0.5, m}};
    },
    [](PatchSize, int x, int y) {
      return std::pair(LatticePoint{x, y}, false);
    },
    anchor,
};

}  // namespace patchmill::patch

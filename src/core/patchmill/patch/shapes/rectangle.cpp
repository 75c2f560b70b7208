// Rectangular patches of a x b dimples on the square lattice: `side` along x, `across` along y.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/shapes/shape_traits.h"
#include "patchmill/patch/shapes/walk.h"

#include <algorithm>
#include <cmath>

namespace patchmill::patch {
namespace {

int across(PatchSize size) {
  return size.across > 0 ? size.across : size.side;
}

std::int64_t point_count(PatchSize size) {
  return std::int64_t(size.side) * across(size);
}

// Sides of a-1, b-1, a-1, b-2, a-2, b-3 ... steps, turning left each time.
std::vector<LatticePoint> helix(PatchSize size) {
  LatticePoint at{0, 0};
  std::vector<LatticePoint> path{at};
  const auto count = static_cast<std::size_t>(point_count(size));
  path.reserve(count);
  const int turn[4][2] = {{+1, 0}, {0, +1}, {-1, 0}, {0, -1}};
  int length[2] = {size.side - 1, across(size) - 1};
  for (int k = 0; path.size() < count; ++k) {
    walk(path, at, length[k % 2], turn[k % 4][0], turn[k % 4][1]);
    if (k > 0) --length[k % 2];
  }
  return path;
}

Polygon outline(PatchSize size, bool) {
  const double x = size.side - 0.5, y = across(size) - 0.5;
  return {{-0.5, -0.5}, {x, -0.5}, {x, y}, {-0.5, y}};
}

// As few patches as cover the area, evenly about its middle.
Vec2 anchor(PatchSize size, const Vec2& cells) {
  Vec2 at;
  for (int k = 0; k < 2; ++k) {
    const double side = k == 0 ? size.side : across(size);
    const double patches = std::max(1.0, std::ceil(cells[k] / side - 1e-9));
    at[k] = 0.5 - 0.5 * (std::fmod(patches, 2.0) == 0.0 ? 0.0 : side);
  }
  return at;
}

}  // namespace

extern const ShapeTraits kRectangleShape;
const ShapeTraits kRectangleShape{
    "Rectangle",
    LatticeKind::Square,
    2,
    true,
    false,
    false,
    {1, 0},
    {10000, 10000},
    "dimples",
    point_count,
    [](PatchSize size) {
      return std::array{LatticePoint{size.side, 0}, LatticePoint{0, across(size)}};
    },
    helix,
    [](PatchSize size, const LatticePoint& p) {
      return LatticePoint{size.side - 1 - p[0], across(size) - 1 - p[1]};
    },
    nullptr,
    outline,
    [](PatchSize, int x, int y) {
      return std::pair(LatticePoint{x, y}, false);
    },
    anchor,
};

}  // namespace patchmill::patch

// Helical order on square patches; see helix.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/patch/helix.h"

#include "core/geometry/error.h"

#include <algorithm>

namespace patchmill {
namespace {

// Appends the points met going `steps` steps from `at` in direction (dx, dy).
void walk(std::vector<LatticePoint>& path, LatticePoint& at, int steps, int dx, int dy) {
  for (int i = 0; i < steps; ++i) {
    at = {at[0] + dx, at[1] + dy};
    path.push_back(at);
  }
}

}  // namespace

std::vector<LatticePoint> square_helix(int side, HelixOrder order) {
  require_in_range("PatchSide", side, 1, 100000, "dimples");
  std::vector<LatticePoint> path;
  path.reserve(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  LatticePoint at{0, 0};
  path.push_back(at);
  walk(path, at, side - 1, +1, 0);
  // then two sides of each length: side-1, side-2, ..., 1, turning left each time
  const int turn[4][2] = {{0, +1}, {-1, 0}, {0, -1}, {+1, 0}};
  for (int length = side - 1, k = 0; length > 0; --length)
    for (int twice = 0; twice < 2; ++twice, ++k)
      walk(path, at, length, turn[k % 4][0], turn[k % 4][1]);
  if (order == HelixOrder::Outward) std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace patchmill

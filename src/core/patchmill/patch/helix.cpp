// Helical order on square, hexagonal and triangular patches; see helix.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/helix.h"

#include "patchmill/geometry/error.h"

#include <algorithm>

namespace patchmill::patch {
namespace {

// Appends the points met going `steps` steps from `at` in direction (dx, dy).
void walk(std::vector<LatticePoint>& path, LatticePoint& at, int steps, int dx, int dy) {
  for (int i = 0; i < steps; ++i) {
    at = {at[0] + dx, at[1] + dy};
    path.push_back(at);
  }
}

std::vector<LatticePoint> in_order(std::vector<LatticePoint> inward, HelixOrder order) {
  if (order == HelixOrder::Outward) std::reverse(inward.begin(), inward.end());
  return inward;
}

std::vector<LatticePoint> begin_path(PatchShape shape, int size, const LatticePoint& start) {
  std::vector<LatticePoint> path;
  path.reserve(static_cast<std::size_t>(point_count(shape, size)));
  path.push_back(start);
  return path;
}

// One turn, counter-clockwise about the patch's centre, of a point of an upright patch.
LatticePoint turned(PatchShape shape, int size, const LatticePoint& p) {
  switch (shape) {
    case PatchShape::Square:
      return {size - 1 - p[1], p[0]};
    case PatchShape::Hexagon:
      return {-p[1], p[0] + p[1]};
    case PatchShape::Triangle:
      return {size - 1 - p[0] - p[1], p[0]};
  }
  return p;
}

}  // namespace

std::int64_t point_count(PatchShape shape, int size) {
  const auto m = static_cast<std::int64_t>(size);
  switch (shape) {
    case PatchShape::Square:
      return m * m;
    case PatchShape::Hexagon:
      return 3 * m * (m + 1) + 1;
    case PatchShape::Triangle:
      return m * (m + 1) / 2;
  }
  return 0;
}

std::vector<LatticePoint> square_helix(int side, HelixOrder order) {
  require_in_range("PatchSide", side, 1, 100000, "dimples");
  LatticePoint at{0, 0};
  std::vector<LatticePoint> path = begin_path(PatchShape::Square, side, at);
  walk(path, at, side - 1, +1, 0);
  // then two sides of each length: side-1, side-2, ..., 1, turning left each time
  const int turn[4][2] = {{0, +1}, {-1, 0}, {0, -1}, {+1, 0}};
  for (int length = side - 1, k = 0; length > 0; --length)
    for (int twice = 0; twice < 2; ++twice, ++k)
      walk(path, at, length, turn[k % 4][0], turn[k % 4][1]);
  return in_order(std::move(path), order);
}

std::vector<LatticePoint> hexagon_helix(int radius, HelixOrder order) {
  require_in_range("PatchSide", radius, 0, 50000, "steps from the centre to a corner");
  LatticePoint at{radius, 0};
  std::vector<LatticePoint> path = begin_path(PatchShape::Hexagon, radius, at);
  // The last side of ring k stops one short of its start; from there the next step along the first
  // side's direction is the start (k-1, 0) of the ring inside.
  const int side[6][2] = {{-1, 1}, {-1, 0}, {0, -1}, {1, -1}, {1, 0}, {0, 1}};
  for (int k = radius; k > 0; --k) {
    for (int s = 0; s < 6; ++s) walk(path, at, s < 5 ? k : k - 1, side[s][0], side[s][1]);
    walk(path, at, 1, side[0][0], side[0][1]);
  }
  return in_order(std::move(path), order);
}

std::vector<LatticePoint> triangle_helix(int side, bool down, HelixOrder order) {
  require_in_range("PatchSide", side, 1, 100000, "dimples");
  LatticePoint at{0, 0};
  std::vector<LatticePoint> path = begin_path(PatchShape::Triangle, side, at);
  // Each loop has three points less per side than the one around it and starts one step beyond the
  // end of that one, straight on along the first side's direction.
  for (int m = side; m > 1; m -= 3) {
    walk(path, at, m - 1, 1, 0);
    walk(path, at, m - 1, -1, 1);
    walk(path, at, m - 2, 0, -1);
    if (m > 3) walk(path, at, 1, 1, 0);
  }
  if (down)
    for (LatticePoint& p : path) p = {side - p[0], side - 1 - p[1]};
  return in_order(std::move(path), order);
}

std::vector<LatticePoint> patch_helix(PatchShape shape, int size, HelixOrder order, bool down,
                                      int turn) {
  std::vector<LatticePoint> path;
  if (shape == PatchShape::Square) path = square_helix(size, order);
  if (shape == PatchShape::Hexagon) path = hexagon_helix(size, order);
  if (shape == PatchShape::Triangle) path = triangle_helix(size, false, order);
  for (LatticePoint& p : path) {
    for (int i = 0; i < turn; ++i) p = turned(shape, size, p);
    if (down && shape == PatchShape::Triangle) p = {size - p[0], size - 1 - p[1]};
  }
  return path;
}

}  // namespace patchmill::patch

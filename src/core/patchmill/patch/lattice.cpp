// Square and triangular lattices; see lattice.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/lattice.h"

#include <cmath>
#include <cstdlib>

namespace patchmill::patch {

Vec2 second_axis(LatticeKind kind) {
  return kind == LatticeKind::Square ? Vec2(0.0, 1.0) : Vec2(0.5, std::sqrt(0.75));
}

Vec2 lattice_coordinates(LatticeKind kind, double spacing, const Vec2& place) {
  const Vec2 a2 = second_axis(kind);
  const double j = place.y() / (spacing * a2.y());
  return {place.x() / spacing - j * a2.x(), j};
}

const std::vector<LatticePoint>& neighbour_steps(LatticeKind kind) {
  static const std::vector<LatticePoint> square{{1, 0}, {0, 1}};
  static const std::vector<LatticePoint> triangular{{1, 0}, {0, 1}, {-1, 1}};
  return kind == LatticeKind::Square ? square : triangular;
}

int lattice_distance(LatticeKind kind, const LatticePoint& p) {
  const int sum = std::abs(p[0]) + std::abs(p[1]);
  return kind == LatticeKind::Square ? sum : (sum + std::abs(p[0] + p[1])) / 2;
}

double cell_area(LatticeKind kind) {
  return second_axis(kind).y();
}

}  // namespace patchmill::patch

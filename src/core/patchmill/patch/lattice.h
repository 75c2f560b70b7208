// The lattice of dimple places in the texture plane: square (Matsuda 2008, Fig. 1a) or triangular.
// Lattice coordinates (i, j) mean i a1 + j a2 with |a1| = |a2| = f, a1 along x, and a2 at 90° or
// 60° to it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/dimple.h"

namespace patchmill::patch {

enum class LatticeKind : std::uint8_t { Square, Triangular };

/// Basis vector a2 for spacing 1; a1 is (1, 0).
Vec2 second_axis(LatticeKind kind);

/// Place of lattice coordinates, also between the points, relative to lattice point (0, 0) [mm].
inline Vec2 lattice_place(LatticeKind kind, double spacing, const Vec2& coordinates) {
  return spacing * (Vec2(coordinates.x(), 0.0) + coordinates.y() * second_axis(kind));
}

/// The coordinates that lattice_place() puts at `place`.
Vec2 lattice_coordinates(LatticeKind kind, double spacing, const Vec2& place);

inline Vec2 to_vec(const LatticePoint& p) {
  return {double(p[0]), double(p[1])};
}

/// Steps to the nearest neighbours, one of each pair of opposites: 2 (square) or 3 (triangular).
const std::vector<LatticePoint>& neighbour_steps(LatticeKind kind);

/// Number of lattice steps from (0, 0): |i| + |j| (square), or the hexagonal distance (triangular).
int lattice_distance(LatticeKind kind, const LatticePoint& p);

/// Area of the plane that one lattice point stands for, for spacing 1.
double cell_area(LatticeKind kind);

}  // namespace patchmill::patch

// The order of dimples inside a patch: the helical path of Matsuda 2008 (Fig. 1b) and Xu & Sasahara
// 2016 (Fig. 1a) as lattice steps. The outline loop first, then the next loop inside it, to the
// centre (or from the centre out). Every step, also from loop to loop, is one lattice step, and
// loops shrink by 8 points (square), 6 (hexagon) or 9 (triangle).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/lattice.h"

#include <vector>

namespace patchmill::patch {

enum class HelixOrder : std::uint8_t { Inward, Outward };

/// Regular polygons that tile the plane. Squares lie on the square lattice, the others on the
/// triangular one.
enum class PatchShape : std::uint8_t { Square, Hexagon, Triangle };

constexpr LatticeKind lattice_of(PatchShape shape) {
  return shape == PatchShape::Square ? LatticeKind::Square : LatticeKind::Triangular;
}

/// Number of corners: 4, 6 or 3; also the number of turns that map a patch on itself.
constexpr int corners(PatchShape shape) {
  return shape == PatchShape::Square ? 4 : shape == PatchShape::Hexagon ? 6 : 3;
}

/// Points of a patch: m² (square of m per side), 3r²+3r+1 (hexagon of radius r) or m(m+1)/2
/// (triangle of m per side).
std::int64_t point_count(PatchShape shape, int size);

/// The m*m points {0..m-1}² of a square patch, each once. Every step, also from loop to loop, is
/// one lattice step. Inward starts at (0, 0) and goes first along +x, counter-clockwise; Outward is
/// the same path backwards. Errors: InputError if `side` is not in 1..100000.
std::vector<LatticePoint> square_helix(int side, HelixOrder order);

/// The 3r²+3r+1 points within `radius` lattice steps of (0, 0), on the triangular lattice. Inward
/// starts at the corner (r, 0), counter-clockwise.
/// Errors: InputError naming PatchSide if `radius` is not in 0..50000.
std::vector<LatticePoint> hexagon_helix(int radius, HelixOrder order);

/// The m(m+1)/2 points {i, j >= 0, i + j <= m-1} on the triangular lattice, or, if `down`, the
/// points {i <= m, j <= m-1, i + j >= m} that complete the cell of (m+1) x m points. Inward starts
/// at (0, 0) (down: at (m, m-1)), counter-clockwise.
/// Errors: InputError naming PatchSide if `side` is not in 1..100000.
std::vector<LatticePoint> triangle_helix(int side, bool down, HelixOrder order);

/// The helix of any shape, turned counter-clockwise about the patch's centre by `turn` of its
/// corners, so that it starts at another corner and covers the same points. `down` is for
/// triangles.
std::vector<LatticePoint> patch_helix(PatchShape shape, int size, HelixOrder order,
                                      bool down = false, int turn = 0);

}  // namespace patchmill::patch

// Parity and touch along rows of voxels; see row_bits.h and voxelise.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/voxel/row_bits.h"

#include "patchmill/geometry/stop.h"
#include "patchmill/mesh/parity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace patchmill::voxel {
namespace {

constexpr double kTouch = 1e-9;  // [cells]

struct Range {
  int lo, hi;  // both ends belong to it
};

// Cells touched by [lo, hi] (cell units), no further than 0 .. count - 1; empty if lo > hi.
Range touched_cells(double lo, double hi, int count) {
  const double near_lo = std::round(lo), near_hi = std::round(hi);
  const double first = std::abs(lo - near_lo) <= kTouch ? near_lo - 1.0 : std::floor(lo);
  const double last = std::abs(hi - near_hi) <= kTouch ? near_hi : std::floor(hi);
  return {static_cast<int>(std::max(0.0, first)),
          static_cast<int>(std::min(static_cast<double>(count) - 1.0, last))};
}

Range touched_cells(const mesh::Triangle& t, int axis, int count) {
  return touched_cells(std::min({t.a[axis], t.b[axis], t.c[axis]}),
                       std::max({t.a[axis], t.b[axis], t.c[axis]}), count);
}

// A convex polygon in the making: a triangle cut by up to four planes.
struct Polygon {
  std::array<Vec3, 8> corner;
  int size = 0;
  Polygon() { corner.fill(Vec3::Zero()); }
};

// The part of `in` with sign * (p[axis] - at) <= 0.
Polygon clip(const Polygon& in, int axis, double at, double sign) {
  Polygon out;
  for (int i = 0; i < in.size; ++i) {
    const Vec3& p = in.corner[i];
    const Vec3& q = in.corner[(i + 1) % in.size];
    const double dp = sign * (p[axis] - at), dq = sign * (q[axis] - at);
    if (dp <= 0.0) out.corner[out.size++] = p;
    if ((dp < 0.0 && dq > 0.0) || (dp > 0.0 && dq < 0.0))
      out.corner[out.size++] = p + (q - p) * (dp / (dp - dq));
  }
  return out;
}

void set_bits(RowBits& bits, int row, Range x) {
  for (int i = x.lo; i <= x.hi; ++i)
    bits[64 * (i >> 3) + row] = static_cast<std::uint8_t>(bits[64 * (i >> 3) + row] | 1 << (i & 7));
}

// The slab [cell, cell + 1] of a polygon along an axis, wider by kTouch on both sides.
Polygon slab(const Polygon& in, int axis, int cell) {
  return clip(clip(in, axis, cell - kTouch, -1.0), axis, cell + 1 + kTouch, 1.0);
}

// The rows of the column that begins at (first_y, first_z) which a triangle touches, and where.
void touch(const mesh::Triangle& t, int first_y, int first_z, const Cell& bricks, RowBits& bits) {
  const Range y = touched_cells(t, 1, 8 * bricks.y()), z = touched_cells(t, 2, 8 * bricks.z());
  Polygon whole;
  whole.corner[0] = t.a;
  whole.corner[1] = t.b;
  whole.corner[2] = t.c;
  whole.size = 3;
  for (int k = std::max(z.lo, first_z); k <= std::min(z.hi, first_z + 7); ++k) {
    const Polygon layer = z.lo < z.hi ? slab(whole, 2, k) : whole;
    for (int j = std::max(y.lo, first_y); j <= std::min(y.hi, first_y + 7); ++j) {
      const Polygon piece = y.lo < y.hi ? slab(layer, 1, j) : layer;
      if (piece.size == 0) continue;
      double lo = piece.corner[0].x(), hi = lo;
      for (int i = 1; i < piece.size; ++i) {
        lo = std::min(lo, piece.corner[i].x());
        hi = std::max(hi, piece.corner[i].x());
      }
      set_bits(bits, 8 * (k - first_z) + (j - first_y), touched_cells(lo, hi, 8 * bricks.x()));
    }
  }
}

// From toggles to states, brick by brick along each row; eight rows at a time, a byte each.
void toggles_to_states(RowBits& bits, int bricks) {
  constexpr std::uint64_t kOnes = 0x0101010101010101U;
  std::array<std::uint64_t, 8> carry{};
  for (int b = 0; b < bricks; ++b) {
    std::array<std::uint64_t, 8> rows;
    std::memcpy(rows.data(), &bits[64 * b], sizeof rows);
    for (int i = 0; i < 8; ++i) {
      std::uint64_t v = rows[i];
      v ^= (v << 1) & (0xffU - 0x1U) * kOnes;
      v ^= (v << 2) & (0xffU - 0x3U) * kOnes;
      v ^= (v << 4) & (0xffU - 0xfU) * kOnes;
      rows[i] = v ^ carry[i];
      carry[i] = (rows[i] >> 7 & kOnes) * 0xffU;
    }
    std::memcpy(&bits[64 * b], rows.data(), sizeof rows);
  }
}

}  // namespace

ColumnTriangles sort_into_columns(const mesh::TriangleMesh& mesh, const GridFrame& frame) {
  ColumnTriangles out;
  const Cell bricks = brick_box(frame.cells);
  out.triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles)
    out.triangles.push_back({frame.in_cells(mesh.vertices[t[0]]),
                             frame.in_cells(mesh.vertices[t[1]]),
                             frame.in_cells(mesh.vertices[t[2]])});
  out.first.assign(static_cast<std::size_t>(bricks.y()) * bricks.z() + 1, 0);
  const auto visit = [&](const auto& found) {
    for (std::size_t i = 0; i < out.triangles.size(); ++i) {
      stop_point();
      const Range y = touched_cells(out.triangles[i], 1, 8 * bricks.y());
      const Range z = touched_cells(out.triangles[i], 2, 8 * bricks.z());
      for (int k = z.lo >> 3; k <= z.hi >> 3; ++k)
        for (int j = y.lo >> 3; j <= y.hi >> 3; ++j)
          found(static_cast<std::size_t>(k) * bricks.y() + j, static_cast<std::int32_t>(i));
    }
  };
  visit([&](std::size_t column, std::int32_t) { ++out.first[column + 1]; });
  for (std::size_t c = 1; c < out.first.size(); ++c) out.first[c] += out.first[c - 1];
  out.list.resize(out.first.back());
  std::vector<std::int64_t> next(out.first.begin(), out.first.end() - 1);
  visit([&](std::size_t column, std::int32_t i) { out.list[next[column]++] = i; });
  return out;
}

void inside_bits(const ColumnTriangles& mesh, const Cell& bricks, int column, RowBits& bits) {
  bits.assign(std::size_t{64} * bricks.x(), 0);
  const int first_y = 8 * (column % bricks.y()), first_z = 8 * (column / bricks.y());
  for (std::int64_t n = mesh.first[column]; n < mesh.first[column + 1]; ++n) {
    const mesh::Triangle& t = mesh.triangles[mesh.list[n]];
    const Range y = touched_cells(t, 1, first_y + 8), z = touched_cells(t, 2, first_z + 8);
    for (int k = std::max(z.lo, first_z); k <= z.hi; ++k)
      for (int j = std::max(y.lo, first_y); j <= y.hi; ++j) {
        double x = 0.0;
        if (!mesh::line_crosses(t, j + 0.5, k + 0.5, x)) continue;
        const int i = static_cast<int>(std::max(0.0, std::ceil(x - 0.5)));
        if (i < 8 * bricks.x())
          bits[64 * (i >> 3) + 8 * (k - first_z) + (j - first_y)] ^=
              static_cast<std::uint8_t>(1 << (i & 7));
      }
  }
  toggles_to_states(bits, bricks.x());
}

void touched_bits(const ColumnTriangles& mesh, const Cell& bricks, int column, RowBits& bits) {
  bits.assign(std::size_t{64} * bricks.x(), 0);
  const int first_y = 8 * (column % bricks.y()), first_z = 8 * (column / bricks.y());
  for (std::int64_t n = mesh.first[column]; n < mesh.first[column + 1]; ++n)
    touch(mesh.triangles[mesh.list[n]], first_y, first_z, bricks, bits);
}

}  // namespace patchmill::voxel

// Interpolation; see field_reader.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/voxel/field_reader.h"

#include <cmath>

namespace patchmill {
namespace {

bool has_field(VoxelKind kind) {
  return kind != VoxelKind::Air && kind != VoxelKind::Part;
}

void add(const VoxelGrid& grid, const Cell& cell, double weight, ReadingStencil& stencil) {
  const std::int64_t index = cell_index(grid.table, cell);
  if (index < 0 || weight <= 0.0 || !has_field(grid.kind[index])) return;
  stencil.cell[stencil.size] = index;
  stencil.weight[stencil.size++] = weight;
}

}  // namespace

ReadingStencil reading_stencil(const VoxelGrid& grid, const Vec3& p, Reading reading) {
  ReadingStencil stencil;
  const Vec3 u = grid.frame.in_cells(p);
  // far away (or not a number): nothing to read, and no integer to overflow
  if (!((u.array() > -2.0).all() &&
        (u.array() < grid.frame.cells.cast<double>().array() + 2.0).all()))
    return stencil;
  if (reading == Reading::Nearest) {
    add(grid, u.array().floor().cast<int>(), 1.0, stencil);
    return stencil;
  }
  const Vec3 v = u - Vec3::Constant(0.5), base = v.array().floor(), s = v - base;
  for (int n = 0; n < 8; ++n) {
    const Cell side(n & 1, n >> 1 & 1, n >> 2 & 1);
    double weight = 1.0;
    for (int k = 0; k < 3; ++k) weight *= side[k] ? s[k] : 1.0 - s[k];
    add(grid, base.cast<int>() + side, weight, stencil);
  }
  double sum = 0.0;
  for (int i = 0; i < stencil.size; ++i) sum += stencil.weight[i];
  if (sum < 1e-9) stencil.size = 0;
  for (int i = 0; i < stencil.size; ++i) stencil.weight[i] /= sum;
  return stencil;
}

std::optional<double> read_feed(const VoxelGrid& grid, const FeedField& feed, const Vec3& p,
                                const Vec3& d, Reading reading) {
  const ReadingStencil at = reading_stencil(grid, p, reading);
  if (at.size == 0) return std::nullopt;
  return feed_in_direction(Vec3(at(feed.along[0]), at(feed.along[1]), at(feed.along[2])), d);
}

std::optional<Vec3> read_axis(const VoxelGrid& grid, const PostureField& posture, const Vec3& p,
                              Reading reading) {
  const ReadingStencil at = reading_stencil(grid, p, reading);
  if (at.size == 0) return std::nullopt;
  if (posture.form == PostureForm::Angles)
    return posture_axis(
        {Angle::radians(at(posture.value[0])), Angle::radians(at(posture.value[1]))});
  const Vec3 sum(at(posture.value[0]), at(posture.value[1]), at(posture.value[2]));
  return sum.norm() > 1e-9 ? Vec3(sum.normalized()) : Vec3::UnitZ();
}

}  // namespace patchmill

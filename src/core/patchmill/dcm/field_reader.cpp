// Interpolation; see field_reader.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/dcm/field_reader.h"

#include "patchmill/geometry/require.h"

#include <cmath>

namespace patchmill::dcm {
namespace {

void add(const voxel::VoxelGrid& grid, const voxel::Cell& cell, double weight,
         ReadingStencil& stencil) {
  if (weight <= 0.0) return;
  const voxel::VoxelKind kind = grid.at(cell);
  if (kind == voxel::VoxelKind::Air) stencil.air += weight;
  if (kind == voxel::VoxelKind::Air || kind == voxel::VoxelKind::Part) return;
  stencil.cell[stencil.size] = voxel::cell_index(grid.table, cell);
  stencil.weight[stencil.size++] = weight;
}

}  // namespace

ReadingStencil reading_stencil(const voxel::VoxelGrid& grid, const Vec3& p, Reading reading) {
  ReadingStencil stencil;
  const Vec3 u = grid.frame.in_cells(p);
  const Vec3 end = grid.frame.cells.cast<double>();
  // outside the box, and so far that no integer holds the cell, or not a number: air
  if (!((u.array() > -2.0).all() && (u.array() < end.array() + 2.0).all())) {
    stencil.air = 1.0;
    return stencil;
  }
  if (reading == Reading::Nearest) {
    add(grid, u.array().floor().cast<int>(), 1.0, stencil);
    return stencil;
  }
  const Vec3 v = u - Vec3::Constant(0.5), base = v.array().floor(), s = v - base;
  for (int n = 0; n < 8; ++n) {
    const voxel::Cell side(n & 1, n >> 1 & 1, n >> 2 & 1);
    double weight = 1.0;
    for (int k = 0; k < 3; ++k) weight *= side[k] ? s[k] : 1.0 - s[k];
    add(grid, base.cast<int>() + side, weight, stencil);
  }
  double sum = stencil.air;
  for (int i = 0; i < stencil.size; ++i) sum += stencil.weight[i];
  if (sum < 1e-9) return {};
  stencil.air /= sum;
  for (int i = 0; i < stencil.size; ++i) stencil.weight[i] /= sum;
  return stencil;
}

void require_over(const voxel::VoxelGrid& grid, const FeedField& feed) {
  for (const auto& along : feed.along)
    require_one_each("FeedField", along.size(), grid.table.cell_count(), "voxels of the grid");
}

void require_over(const voxel::VoxelGrid& grid, const PostureField& posture) {
  for (const auto& value : posture.value)
    require_one_each("PostureField", value.size(), grid.table.cell_count(), "voxels of the grid");
}

std::optional<double> read_feed(const voxel::VoxelGrid& grid, const FeedField& feed, const Vec3& p,
                                const Vec3& d, Reading reading) {
  const ReadingStencil at = reading_stencil(grid, p, reading);
  if (at.empty()) return std::nullopt;
  Vec3 v;
  for (int axis = 0; axis < 3; ++axis) v[axis] = at(feed.along[axis], feed.limits.high);
  return feed_in_direction(v, d);
}

std::optional<Vec3> read_axis(const voxel::VoxelGrid& grid, const PostureField& posture,
                              const Vec3& p, Reading reading) {
  const ReadingStencil at = reading_stencil(grid, p, reading);
  if (at.empty()) return std::nullopt;
  const auto& value = posture.value;
  if (posture.form == PostureForm::Angles)
    return posture_axis({Angle::radians(at(value[0], 0.0)), Angle::radians(at(value[1], 0.0))});
  const Vec3 sum(at(value[0], 0.0), at(value[1], 0.0), at(value[2], 1.0));
  return sum.norm() > 1e-9 ? Vec3(sum.normalized()) : Vec3::UnitZ();
}

}  // namespace patchmill::dcm

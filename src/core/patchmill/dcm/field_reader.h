// Reading a field over the removal volume at any point. The paper (Kobayashi & Shirase 2014,
// sections 4.1 and 4.2) takes the value of the voxel that the tool is in and gets a staircase that
// "needed to be smoothed"; the default here is trilinear interpolation between voxel centres, which
// is continuous.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/dcm/posture_field.h"

#include <array>
#include <optional>
#include <vector>

namespace patchmill::dcm {

enum class Reading {
  Trilinear,  ///< between the eight voxel centres around the point
  Nearest     ///< the value of the voxel that holds the point (the paper)
};

/// The voxels to read and their weights. Voxels of the part alone are left out and the other
/// weights enlarged, so that the field goes on at the product surface as it is there. Air has the
/// values of the stock's skin (V_Hi, upright), so that a path enters and leaves the stock without a
/// step.
struct ReadingStencil {
  std::array<std::int64_t, 8> cell{};
  std::array<double, 8> weight{};
  int size = 0;
  double air = 0.0;  ///< weight of air; all weights add up to one, or to zero within the part

  /// Whether there is nothing to read: the point is in the middle of the part.
  bool empty() const { return size == 0 && air == 0.0; }
  /// The weighted mean of a field over the cells of its grid; `in_air` is its value in air.
  template <class T>
  double operator()(const std::vector<T>& field, double in_air) const {
    double sum = air * in_air;
    for (int i = 0; i < size; ++i) sum += weight[i] * static_cast<double>(field[cell[i]]);
    return sum;
  }
};

/// The stencil at `p` [mm]; of a point off the box or not finite all is air.
ReadingStencil reading_stencil(const voxel::VoxelGrid& grid, const Vec3& p, Reading reading);

/// Errors: InputError naming FeedField or PostureField if the field was made over another grid: one that stores
/// another number of voxels. The readers below do not look.
void require_over(const voxel::VoxelGrid& grid, const FeedField& feed);
void require_over(const voxel::VoxelGrid& grid, const PostureField& posture);

/// Feed [mm/s] at `p` [mm] in the unit direction d; nothing in the middle of the part.
std::optional<double> read_feed(const voxel::VoxelGrid& grid, const FeedField& feed, const Vec3& p,
                                const Vec3& d, Reading reading = Reading::Trilinear);

/// Unit axis at `p` [mm]; nothing in the middle of the part.
std::optional<Vec3> read_axis(const voxel::VoxelGrid& grid, const PostureField& posture,
                              const Vec3& p, Reading reading = Reading::Trilinear);

}  // namespace patchmill::dcm

// Feed over the removal volume. Kobayashi & Shirase 2014, section 3.2, Eqs. (2) to (4): three
// fields V_x, V_y, V_z, each diffused along its own axis only, with V_Lo held in voxels that
// contain product surface. Here V_Hi is held in exterior voxels (default) or is only the initial
// value ("free").
//
// The steady state of one-dimensional diffusion is a straight line between held values, so it is
// written down, not iterated: along each run of voxels between two held ones the feed is linear,
// between a held one and a free end it is constant, and a run that meets no held voxel keeps the
// initial V_Hi.
//
// In the feed direction d (unit) the paper weighs the three "with a vector component"; taken as
// V = d_x^2 V_x + d_y^2 V_y + d_z^2 V_z, whose weights add up to one for every direction.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/voxel/laplace_level.h"
#include "patchmill/voxel/voxel_grid.h"

#include <array>
#include <vector>

namespace patchmill::dcm {

/// What exterior voxels are to the diffusion.
enum class ExteriorRule {
  Held,  ///< their value is held (default): the stable state has the profile of the paper's Fig. 8
  Free   ///< only their initial value is given; nothing flows out of the volume
};

/// Feeds at the surface of the part and at the skin of the stock.
struct FeedLimits {
  double low = 0.0;   ///< V_Lo, at the product surface [mm/s], > 0
  double high = 0.0;  ///< V_Hi, at the stock's skin [mm/s], >= V_Lo
};

/// Feeds over a voxel grid.
struct FeedField {
  FeedLimits limits;
  std::array<std::vector<double>, 3> along;  ///< V_x, V_y, V_z [mm/s]; 0 where there is no removal
};

/// The steady feed fields. Errors: InputError if the limits are not 0 < low <= high.
FeedField steady_feed(const voxel::VoxelGrid& grid, const FeedLimits& limits,
                      ExteriorRule rule = ExteriorRule::Held);

/// What each voxel is to the solvers. Surface voxels are held; exterior ones by the rule.
std::vector<voxel::CellRole> roles(const voxel::VoxelGrid& grid, ExteriorRule rule);

/// Values before diffusion: V_Lo at surface voxels, V_Hi elsewhere in the removal volume. Errors: as steady_feed.
std::vector<double> initial_feed(const voxel::VoxelGrid& grid, const FeedLimits& limits);

/// V in a direction; `d` is a unit vector, v the values of V_x, V_y, V_z [mm/s].
inline double feed_in_direction(const Vec3& v, const Vec3& d) {
  return v.dot(d.cwiseProduct(d));
}

}  // namespace patchmill::dcm

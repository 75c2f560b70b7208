// The cutting load along a tool path, and a path whose feed keeps it within limits. The voxel model is cut step by
// step, a quarter of a voxel each, and the engagement (engagement.h) is that of a voxel's length of the way around
// each step.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/load/cutting_load.h"
#include "patchmill/voxel/voxel_grid.h"

#include <cstdint>
#include <vector>

namespace patchmill::load {

/// The load somewhere on a path.
struct LoadAt {
  std::int64_t move = 0;  ///< of the path
  double at = 0.0;        ///< where the step ends on that move, 0 .. 1
  double length = 0.0;    ///< of the step [mm]
  double feed = 0.0;      ///< [mm/s]; 0 where it is not known, and the load there
  Engagement engagement;
  Load load;
};

/// The load at every step of the path through the stock of a grid, which it cuts. Errors: InputError naming tool
/// radius, spindle speed, flutes, or what require_valid names.
std::vector<LoadAt> load_along(const ToolPath& path, const voxel::VoxelGrid& grid,
                               const Resistance& resistance);

/// The path with its timed moves divided and slowed down where the load would be over a limit, from half a voxel before
/// to half a voxel behind; no move gets faster. `source`: the number of the given move of each move. Errors: as
/// load_along, and InputError naming base operation for a texture path.
ToolPath limit_load(const ToolPath& path, const voxel::VoxelGrid& grid,
                    const Resistance& resistance, const LoadLimits& limits,
                    std::vector<std::int64_t>* source = nullptr);

}  // namespace patchmill::load

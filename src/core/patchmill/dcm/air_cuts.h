// Air cuts: voxels are emptied as the tool passes, and where nothing is left to cut a move may run at a feed
// of its own. Each voxel is sampled at 4 x 4 x 4 places, so that material thinner than a quarter of a voxel
// may go unseen: the feed in air should be one that the tool survives in such a sliver.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/path/tool_path.h"
#include "patchmill/voxel/voxel_grid.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace patchmill::dcm {

/// What is left of the material to be removed. Samples are kept only for bricks that the tool has been in and
/// not emptied: 4 KiB each, of which a path that goes layer by layer has few at a time. The grid must live as
/// long.
class RemainingStock {
 public:
  /// All of the stock of a voxel model, which must outlive it.
  explicit RemainingStock(const voxel::VoxelGrid& grid);

  /// Takes away what the cutter holds with the tool's centre (tool.h) at a place [mm], its flank going on upwards.
  /// Returns whether anything was there.
  /// `taken`: the samples that were there are added to it [mm].
  bool cut(const Vec3& centre, const Vec3& axis, const Tool& tool,
           std::vector<Vec3>* taken = nullptr);

  /// Volume that a sample stands for [mm^3].
  double sample_volume() const;

  /// Volume of the samples that are left [mm^3].
  double volume() const;

  /// Bricks of which samples are kept.
  std::size_t opened() const;

 private:
  struct Swath;
  using Samples = std::array<std::uint64_t, voxel::kBrickCells>;  // per cell; bit x + 4 y + 16 z
  Samples whole(std::size_t brick) const;
  bool cut_brick(std::size_t brick, const voxel::Cell& lo, const voxel::Cell& hi, const Swath& tool,
                 std::vector<Vec3>* taken);

  const voxel::VoxelGrid& grid_;
  std::vector<std::unique_ptr<Samples>> left_;  // per stored brick; null: whole, or emptied
  std::vector<std::uint8_t> emptied_;
};

/// How air cuts are looked for and how fast they go.
struct AirCutOptions {
  double feed = 0.0;  ///< V_Air [mm/s], > 0
  double shortest =
      0.0;  ///< no stretch of air shorter than this is hurried over [mm]; 0: one voxel
};

/// The path with its timed moves divided where cutting and air meet, those in air at V_Air where that is
/// faster; half a voxel before the material comes again they have their own feed. `source` as in
/// apply_dcm. Errors: InputError naming an option out of range, or a texture path.
ToolPath hurry_in_air(const ToolPath& path, const voxel::VoxelGrid& grid,
                      const AirCutOptions& options, std::vector<std::int64_t>* source = nullptr);

}  // namespace patchmill::dcm

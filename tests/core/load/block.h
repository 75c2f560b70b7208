// A block to be milled, and paths through it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/load/path_load.h"
#include "patchmill/voxel/voxelise.h"

#include <cmath>
#include <vector>

namespace patchmill::load {

const Vec3 kBlock(20, 20, 14);
constexpr double kFloor = 4.0;  // of the part below the block [mm]
constexpr double kTop = 14.0;

inline voxel::VoxelGrid block(double pitch) {
  voxel::VoxelOptions options;
  options.pitch = pitch;
  return voxel::voxelise(mesh::box_mesh(Vec3::Zero(), kBlock),
                         mesh::box_mesh(Vec3::Zero(), Vec3(20, 20, kFloor)), options);
}

inline ToolPath passes(const Tool& tool, const std::vector<Vec3>& tips, double feed) {
  ToolPath path;
  path.tool = tool;
  path.spindle.speed = 100.0;
  path.start.tip = tips.front();
  Vec3 from = tips.front();
  for (std::size_t i = 1; i < tips.size(); ++i) {
    Move move;
    move.kind = MoveKind::Cut;
    move.end.tip = tips[i];
    move.turns = path.spindle.speed * (tips[i] - from).norm() / feed;
    path.moves.push_back(move);
    from = tips[i];
  }
  return path;
}

}  // namespace patchmill::load

// A hill in its stock with its fields, and paths over it, for tests of the paths that are made with them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/dcm/apply_dcm.h"
#include "patchmill/voxel/voxelise.h"
#include "voxel/shapes.h"

#include <utility>

namespace patchmill::dcm {

inline constexpr double kRadius = 3.0;
inline constexpr FeedLimits kFeed{400.0 / 60.0, 800.0 / 60.0};

struct Model {
  voxel::VoxelGrid grid;
  FeedField feed;
  PostureField posture;
};

inline const Model& convex_model() {
  static const Model model = [] {
    voxel::VoxelOptions options;
    options.pitch = 2.0;
    const mesh::TriangleMesh part = shapes::convex_part(30);
    const mesh::TriangleBvh bvh(part);
    voxel::VoxelGrid grid =
        voxel::voxelise(mesh::box_mesh(Vec3::Zero(), Vec3(50, 50, 36)), part, options);
    FeedField feed = steady_feed(grid, kFeed);
    PostureField posture = steady_posture(grid, part, bvh);
    return Model{std::move(grid), std::move(feed), std::move(posture)};
  }();
  return model;
}

inline ToolPath line(const Vec3& a, const Vec3& b, double speed = 10.0) {
  ToolPath path;
  path.tool = {kRadius, 2};
  path.spindle.speed = 100.0;
  path.start.tip = a;
  Move move;
  move.end.tip = b;
  move.kind = MoveKind::Cut;
  move.turns = path.spindle.speed * (b - a).norm() / speed;
  path.moves.push_back(move);
  return path;
}

// Over the hill: in from the left, up and over, down, and out.
inline ToolPath over_the_hill() {
  ToolPath path = line(Vec3(-4, 23, 12), Vec3(12, 23, 25));
  for (const Vec3& p : {Vec3(25, 23, 29), Vec3(40, 24, 24), Vec3(54, 24, 12)}) {
    Move move = path.moves.back();
    move.end.tip = p;
    path.moves.push_back(move);
  }
  return path;
}

}  // namespace patchmill::dcm

// Steady one-dimensional diffusion along the lines of voxels; see feed_field.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/dcm/feed_field.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/large_vector.h"

namespace patchmill::dcm {
namespace {

void require_limits(const FeedLimits& limits) {
  require_positive("lower feed", limits.low, "mm/s");
  require_positive("upper feed", limits.high, "mm/s");
  if (limits.high < limits.low)
    throw InputError("upper feed", std::to_string(limits.high) + " mm/s",
                     "give at least the lower feed.");
}

// Values along one run of unknown cells between `left` and `right`, each a held value or nothing.
struct End {
  bool held = false;
  double value = 0.0;
};

void fill_run(const std::vector<std::int64_t>& run, const End& left, const End& right,
              std::vector<double>& field) {
  const double n = static_cast<double>(run.size()) + 1.0;
  for (std::size_t i = 0; i < run.size(); ++i) {
    const double s = (static_cast<double>(i) + 1.0) / n;
    if (left.held && right.held)
      field[run[i]] = (1.0 - s) * left.value + s * right.value;
    else if (left.held || right.held)
      field[run[i]] = left.held ? left.value : right.value;
  }
}

// One line of cells through a row of bricks: `bricks` are numbers along the axis, or kNoBrick.
struct Line {
  std::vector<std::int32_t> bricks;
  int offset;  // of the first cell in a brick
  int step;    // between cells in a brick
};

void diffuse_line(const Line& line, const std::vector<voxel::CellRole>& role,
                  std::vector<double>& field, std::vector<std::int64_t>& run) {
  End left;
  run.clear();
  const auto finish = [&](const End& right) {
    fill_run(run, left, right, field);
    run.clear();
    left = right;
  };
  for (const std::int32_t brick : line.bricks) {
    if (brick == voxel::kNoBrick) {
      finish({});
      continue;
    }
    for (int i = 0; i < voxel::kBrickSide; ++i) {
      const std::int64_t cell =
          std::int64_t{brick} * voxel::kBrickCells + line.offset + i * line.step;
      if (role[cell] == voxel::CellRole::Unknown)
        run.push_back(cell);
      else
        finish({role[cell] == voxel::CellRole::Held, field[cell]});
    }
  }
  finish({});
}

constexpr int kStep[3] = {1, voxel::kBrickSide, voxel::kBrickSide* voxel::kBrickSide};

void diffuse_along(const voxel::BrickTable& table, int axis,
                   const std::vector<voxel::CellRole>& role, std::vector<double>& field) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const int columns = table.bricks[u] * table.bricks[v];
  patchmill::parallel_for(0, columns, [&](int column) {
    Line line{std::vector<std::int32_t>(table.bricks[axis]), 0, kStep[axis]};
    bool any = false;
    for (int i = 0; i < table.bricks[axis]; ++i) {
      voxel::Cell place;
      place[axis] = i;
      place[u] = column % table.bricks[u];
      place[v] = column / table.bricks[u];
      line.bricks[i] = table.at[table.flat(place)];
      any = any || line.bricks[i] != voxel::kNoBrick;
    }
    std::vector<std::int64_t> run;
    for (int row = 0; any && row < 64; ++row) {
      line.offset = row % 8 * kStep[u] + row / 8 * kStep[v];
      diffuse_line(line, role, field, run);
    }
  });
}

}  // namespace

std::vector<voxel::CellRole> roles(const voxel::VoxelGrid& grid, ExteriorRule rule) {
  return large_vector<voxel::CellRole>(grid.kind.size(), [&](std::size_t i) {
    const voxel::VoxelKind kind = grid.kind[i];
    if (kind == voxel::VoxelKind::Surface ||
        (kind == voxel::VoxelKind::Exterior && rule == ExteriorRule::Held))
      return voxel::CellRole::Held;
    return kind == voxel::VoxelKind::Removal || kind == voxel::VoxelKind::Exterior
               ? voxel::CellRole::Unknown
               : voxel::CellRole::Outside;
  });
}

std::vector<double> initial_feed(const voxel::VoxelGrid& grid, const FeedLimits& limits) {
  require_limits(limits);
  return large_vector<double>(grid.kind.size(), [&](std::size_t i) {
    const voxel::VoxelKind kind = grid.kind[i];
    if (kind == voxel::VoxelKind::Surface) return limits.low;
    const bool inside = kind == voxel::VoxelKind::Removal || kind == voxel::VoxelKind::Exterior;
    return inside ? limits.high : 0.0;
  });
}

FeedField steady_feed(const voxel::VoxelGrid& grid, const FeedLimits& limits, ExteriorRule rule) {
  require_limits(limits);
  FeedField feed;
  feed.limits = limits;
  const std::vector<voxel::CellRole> role = roles(grid, rule);
  for (int axis = 0; axis < 3; ++axis) {
    feed.along[axis] = initial_feed(grid, limits);
    diffuse_along(grid.table, axis, role, feed.along[axis]);
  }
  return feed;
}

}  // namespace patchmill::dcm

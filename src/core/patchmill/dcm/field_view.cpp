// Sections and arrows; see field_view.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/dcm/field_view.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace patchmill::dcm {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

bool has_field(voxel::VoxelKind kind) {
  return kind == voxel::VoxelKind::Removal || kind == voxel::VoxelKind::Surface ||
         kind == voxel::VoxelKind::Exterior;
}

}  // namespace

GridSection section_of(const voxel::VoxelGrid& grid, int axis, double place) {
  if (axis < 0 || axis > 2)
    throw InputError("axis", std::to_string(axis), "give 0, 1 or 2 for x, y or z.");
  const voxel::GridFrame& frame = grid.frame;
  const double in_cells = (place - frame.origin[axis]) / frame.pitch;
  if (!(in_cells >= 0.0 && in_cells < frame.cells[axis]))
    throw InputError("place", fmt::format("{} mm", place),
                     fmt::format("the voxels lie from {} to {} mm.", frame.origin[axis],
                                 frame.origin[axis] + frame.pitch * frame.cells[axis]));
  const int u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
  voxel::Cell cell;
  cell[axis] = static_cast<int>(in_cells);
  GridSection s;
  s.columns = frame.cells[u];
  s.rows = frame.cells[v];
  s.origin = {frame.origin[u], frame.origin[v]};
  s.pitch = frame.pitch;
  s.place = frame.centre(cell)[axis];
  for (cell[v] = 0; cell[v] < s.rows; ++cell[v])
    for (cell[u] = 0; cell[u] < s.columns; ++cell[u]) {
      s.kind.push_back(grid.at(cell));
      s.index.push_back(has_field(s.kind.back()) ? voxel::cell_index(grid.table, cell) : -1);
    }
  return s;
}

std::vector<double> feed_on(const GridSection& section, const FeedField& feed, const Vec3& d) {
  std::vector<double> values;
  values.reserve(section.index.size());
  for (const std::int64_t i : section.index)
    values.push_back(
        i < 0 ? kNone
              : feed_in_direction({feed.along[0][i], feed.along[1][i], feed.along[2][i]}, d));
  return values;
}

Vec3 axis_in(const PostureField& posture, std::size_t cell) {
  const auto& v = posture.value;
  if (posture.form == PostureForm::Angles)
    return posture_axis({Angle::radians(v[0][cell]), Angle::radians(v[1][cell])});
  const Vec3 sum(v[0][cell], v[1][cell], v[2][cell]);
  return sum.norm() > 1e-6 ? Vec3(sum.normalized()) : Vec3::UnitZ();
}

std::vector<Vec3> axes_on(const GridSection& section, const PostureField& posture) {
  std::vector<Vec3> axes;
  axes.reserve(section.index.size());
  for (const std::int64_t i : section.index)
    axes.push_back(i < 0 ? Vec3(Vec3::Constant(kNone))
                         : axis_in(posture, static_cast<std::size_t>(i)));
  return axes;
}

std::vector<FieldArrow> arrows_of(const voxel::VoxelGrid& grid, const PostureField& posture,
                                  int stride) {
  if (stride < 1) throw InputError("stride", std::to_string(stride), "give 1 or more.");
  std::vector<FieldArrow> arrows;
  for (std::size_t b = 0; b < grid.table.size(); ++b)
    for (int n = 0; n < voxel::kBrickCells; ++n) {
      const std::size_t i = b * voxel::kBrickCells + n;
      const voxel::Cell cell =
          voxel::first_cell(grid.table, b) + voxel::Cell(n % 8, n / 8 % 8, n / 64);
      const bool wanted = (cell - cell / stride * stride).isZero();
      if (wanted && has_field(grid.kind[i]))
        arrows.push_back({grid.frame.centre(cell), axis_in(posture, i)});
    }
  return arrows;
}

std::vector<float> distance_to_part(const voxel::VoxelGrid& grid, const mesh::TriangleBvh& part) {
  std::vector<float> distance(grid.kind.size(), 0.0F);
  patchmill::parallel_for(std::size_t{0}, grid.table.size(), [&](std::size_t b) {
    for (int n = 0; n < voxel::kBrickCells; ++n) {
      const std::size_t i = b * voxel::kBrickCells + n;
      if (!has_field(grid.kind[i])) continue;
      const voxel::Cell cell =
          voxel::first_cell(grid.table, b) + voxel::Cell(n % 8, n / 8 % 8, n / 64);
      distance[i] = static_cast<float>(mesh::closest_point(part, grid.frame.centre(cell)).distance);
    }
  });
  return distance;
}

}  // namespace patchmill::dcm

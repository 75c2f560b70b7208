// Sections and arrows of the voxel model, as plain arrays for pictures: Kobayashi & Shirase 2014,
// Figs. 8 and 12 show feed and posture in planes through the removal volume.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/dcm/posture_field.h"

#include <cstdint>
#include <vector>

namespace patchmill::dcm {

/// One layer of voxels at right angles to an axis. Rows run along the later of the two other axes
/// (z, or y for a section at constant z), columns along the earlier one.
struct GridSection {
  int rows = 0, columns = 0;
  Vec2 origin = Vec2::Zero();          ///< low corner: (column axis, row axis) [mm]
  double pitch = 0.0;                  ///< [mm]
  double place = 0.0;                  ///< middle of the layer along the axis [mm]
  std::vector<voxel::VoxelKind> kind;  ///< row by row
  std::vector<std::int64_t> index;     ///< into the fields, -1 where nothing is stored
};

/// The layer that holds `place` [mm] along `axis` (0, 1, 2 for x, y, z). Errors: InputError naming
/// the axis or, if it is outside the grid, the place.
GridSection section_of(const voxel::VoxelGrid& grid, int axis, double place);

/// Feed [mm/s] in the unit direction d over a section; NaN where there is nothing to remove.
std::vector<double> feed_on(const GridSection& section, const FeedField& feed, const Vec3& d);

/// Unit axis of the posture field in a stored voxel.
Vec3 axis_in(const PostureField& posture, std::size_t cell);

/// Unit axes over a section; NaN where there is nothing to remove.
std::vector<Vec3> axes_on(const GridSection& section, const PostureField& posture);

/// A tool axis of the field, to be drawn.
struct FieldArrow {
  Vec3 place = Vec3::Zero();  ///< centre of a voxel [mm]
  Vec3 axis = Vec3::UnitZ();
};

/// The axis in every `stride`-th voxel to be removed each way. Errors: InputError if stride < 1.
std::vector<FieldArrow> arrows_of(const voxel::VoxelGrid& grid, const PostureField& posture,
                                  int stride);

/// Distance [mm] of the centre of every stored voxel from the part, and 0 where there is nothing to
/// remove: one of the attributes that the paper (section 3) gives a voxel.
std::vector<float> distance_to_part(const voxel::VoxelGrid& grid, const mesh::TriangleBvh& part);

}  // namespace patchmill::dcm

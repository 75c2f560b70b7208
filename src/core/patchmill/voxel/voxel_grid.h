// The voxel model of the removal volume: stock minus part on a cubic grid, in bricks (bricks.h).
// Kobayashi & Shirase 2014, section 3: voxels that contain product surface carry the boundary
// condition; those at the skin of the stock are called exterior here.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"
#include "patchmill/voxel/bricks.h"

#include <array>
#include <cstdint>
#include <vector>

namespace patchmill::voxel {

enum class VoxelKind : std::uint8_t {
  Air,       ///< centre outside the stock
  Part,      ///< centre inside the part, and no product surface in it
  Removal,   ///< to be removed
  Surface,   ///< in the stock, and touched by the surface of the part
  Exterior,  ///< to be removed, and a face of it borders on Air: the skin of the stock
};
constexpr int kVoxelKinds = 5;

/// Where the voxels are: cubes of side `pitch`; cell (i, j, k) begins at origin + pitch (i, j, k).
struct GridFrame {
  Vec3 origin = Vec3::Zero();  ///< [mm]
  double pitch = 0.0;          ///< side of a voxel [mm], > 0
  Cell cells = Cell::Zero();

  /// Middle of a voxel [mm].
  Vec3 centre(const Cell& c) const {
    return origin + pitch * (c.cast<double>() + Vec3::Constant(0.5));
  }
  /// Position in units of cells: whole numbers at cell corners.
  Vec3 in_cells(const Vec3& p) const { return (p - origin) / pitch; }
  /// The cell that holds a point [mm], also one beyond the box.
  Cell cell_at(const Vec3& p) const { return in_cells(p).array().floor().cast<int>(); }
  /// How many cells the box has.
  double box_cells() const { return cells.cast<double>().prod(); }
};

/// The voxel model: what each voxel is.
struct VoxelGrid {
  GridFrame frame;
  BrickTable table;             ///< bricks that hold anything but Air alone or Part alone
  std::vector<VoxelKind> kind;  ///< per cell of the table
  std::vector<std::uint8_t>
      solid_bricks;  ///< per brick of the box: 1 where a brick not stored is Part

  /// What a voxel is; Air beyond the box.
  VoxelKind at(const Cell& cell) const;
};

/// How many voxels of each kind the stored bricks hold, indexed by VoxelKind.
std::array<std::int64_t, kVoxelKinds> count_kinds(const VoxelGrid& grid);

/// Bytes for a job, and the refusal of one that is too large.
struct MemoryEstimate {
  double grid = 0.0;  ///< the voxel model itself
  double fields =
      0.0;  ///< of every stored voxel: feed (three doubles), posture (floats), material (a byte)
  double solver = 0.0;  ///< what solving the posture, done first, takes beyond that
  /// All of it.
  double total() const { return grid + fields + solver; }
};

/// Foreseen from the volume V [mm^3] that will be stored and the area A [mm^2] that bounds it: of cubes of side L
/// at random, V / L^3 + 0.75 A / L^2 meet it (Steiner's formula: the volume of the sum of both; what edges and corners
/// add is left out). The posture has `posture_fields`
/// components: two angles, or three of the unit vector; `materials`: whether there are other than the stock's own.
MemoryEstimate estimate_memory(const GridFrame& frame, double volume, double area,
                               int posture_fields = 2, bool materials = false);

/// Exact, for bricks that are known.
MemoryEstimate memory_of(const BrickTable& table, int posture_fields = 2, bool materials = false);

/// Throws InputError naming the bytes and the voxel size that would fit, if total() is over
/// `limit`.
void require_memory(const MemoryEstimate& need, double limit, const GridFrame& frame);

}  // namespace patchmill::voxel

// Materials of voxels; see materials.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/dcm/materials.h"

#include "patchmill/geometry/large_vector.h"
#include "patchmill/geometry/require.h"
#include "patchmill/voxel/row_bits.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace patchmill::dcm {
namespace {

constexpr std::size_t kMost = 255;

// Gives `number` to the voxels of one column of bricks along x whose centres are in the body.
void fill_column(const voxel::VoxelGrid& grid, const MaterialBody& body,
                 const voxel::ColumnTriangles& triangles, int column, std::uint8_t number,
                 std::vector<std::uint8_t>& material) {
  const voxel::Cell bricks = grid.table.bricks;
  voxel::RowBits inside;
  voxel::inside_bits(triangles, bricks, column, inside);
  for (int x = 0; x < bricks.x(); ++x) {
    const std::int32_t brick = grid.table.find({x, column % bricks.y(), column / bricks.y()});
    if (brick == voxel::kNoBrick) continue;
    const voxel::Cell first = voxel::first_cell(grid.table, static_cast<std::size_t>(brick));
    for (int n = 0; n < voxel::kBrickCells; ++n) {
      if (!(inside[64 * x + n / 8] >> (n % 8) & 1)) continue;
      const Vec3 centre = grid.frame.centre(first + voxel::Cell(n % 8, n / 8 % 8, n / 64));
      const bool deep = std::isfinite(body.depth) &&
                        mesh::closest_point(*body.bvh, centre, body.depth).triangle < 0;
      if (!deep) material[static_cast<std::size_t>(brick) * voxel::kBrickCells + n] = number;
    }
  }
}

}  // namespace

std::vector<std::uint8_t> materials_of(const voxel::VoxelGrid& grid,
                                       const std::vector<MaterialBody>& bodies) {
  if (bodies.size() > kMost)
    throw InputError("Materials", std::to_string(bodies.size()), "give 255 at most.");
  auto material = large_vector<std::uint8_t>(grid.table.cell_count(),
                                             [](std::size_t) { return std::uint8_t{0}; });
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (!(bodies[b].depth > 0.0))
      throw InputError("Materials", fmt::format("{} mm", bodies[b].depth),
                       "give a depth greater than zero.");
    const voxel::ColumnTriangles triangles = voxel::sort_into_columns(*bodies[b].mesh, grid.frame);
    const int columns = grid.table.bricks.y() * grid.table.bricks.z();
    patchmill::parallel_for(0, columns, [&](int column) {
      fill_column(grid, bodies[b], triangles, column, static_cast<std::uint8_t>(b + 1), material);
    });
  }
  return material;
}

void require_over(const voxel::VoxelGrid& grid, const std::vector<std::uint8_t>& material) {
  require_one_each("Materials", material.size(), grid.table.cell_count(), "voxels of the grid");
}

void scale_feed(FeedField& feed, const std::vector<std::uint8_t>& material,
                const std::vector<double>& factor) {
  for (const double f : factor)
    if (!(f > 0.0 && std::isfinite(f)))
      throw InputError("Materials", fmt::format("factor {}", f), "give one greater than zero.");
  for (const std::uint8_t m : material)
    if (m >= factor.size())
      throw InputError("Materials", fmt::format("{} factors", factor.size()),
                       "give one for the stock and one for each material.");
  for (auto& along : feed.along)
    require_one_each("Materials", material.size(), along.size(), "voxels of the field");
  constexpr std::size_t kPiece = std::size_t{1} << 16;  // voxels
  for (auto& along : feed.along)
    patchmill::parallel_for(std::size_t{0}, material.size() / kPiece + 1, [&](std::size_t piece) {
      const std::size_t end = std::min(material.size(), (piece + 1) * kPiece);
      for (std::size_t i = piece * kPiece; i < end; ++i) along[i] *= factor[material[i]];
    });
}

}  // namespace patchmill::dcm

// The material of each voxel: an attribute that Kobayashi & Shirase 2014, section 3, give a voxel beside
// its distance to the product, and do not use. Here the feed does: V of a voxel is V_Lo .. V_Hi of the
// field times the factor of its material.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/dcm/feed_field.h"
#include "patchmill/mesh/triangle_bvh.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace patchmill::dcm {

/// Where another material than the stock's own is. With a depth it is a layer: the stock's mesh and
/// 1.5 mm are a cast skin.
struct MaterialBody {
  const mesh::TriangleMesh* mesh = nullptr;                ///< closed
  const mesh::TriangleBvh* bvh = nullptr;                  ///< over that mesh
  double depth = std::numeric_limits<double>::infinity();  ///< below its surface, no further [mm]
};

/// Per stored voxel: 0 for the stock's own material, else 1 + the number of the last body that holds its
/// centre. Parallel; the same on any number of threads. Errors: InputError naming Materials for more
/// than 255 bodies or a depth of zero or less.
std::vector<std::uint8_t> materials_of(const voxel::VoxelGrid& grid,
                                       const std::vector<MaterialBody>& bodies);

/// Errors: InputError naming Materials if the numbers were made over another grid: one that stores another number
/// of voxels.
void require_over(const voxel::VoxelGrid& grid, const std::vector<std::uint8_t>& material);

/// What materials do to the feed: the material of each stored voxel, and a factor for each material, the stock's own
/// first. Without materials, nothing.
struct FeedFactors {
  std::vector<std::uint8_t> material;
  std::vector<double> factor;
};

/// Multiplies the feed of each voxel by the factor of its material; factor[0] is that of the stock's own.
/// Errors: InputError naming Materials if a factor is missing, or not above zero and finite, or if the numbers
/// are of another grid than the field.
void scale_feed(FeedField& feed, const std::vector<std::uint8_t>& material,
                const std::vector<double>& factor);

}  // namespace patchmill::dcm

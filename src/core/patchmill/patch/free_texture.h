// Patches in Matsuda's free form on faces (Matsuda 2008, section 2.2 and the experiments on an inclined
// plane and on a cylinder): copies of one regular polygon of side a, each in a plane of its own, with the
// marks of its helix every f_z along the path. Side, cross-feed and feed per tooth are true lengths in
// the patch's plane.
//
// The patches stand on a lattice: squares a apart, hexagons √3 a apart on a triangular lattice, and
// triangles two to a mesh of a triangular lattice of spacing a. The lattice may be projected, or laid on
// the surface, where patches then touch on slopes too.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/progress.h"
#include "patchmill/patch/free_helix.h"
#include "patchmill/patch/patch_surface.h"

#include <optional>

namespace patchmill::patch {

/// The lattice that patches stand on, as a pattern of patches with one point each: cover() and
/// patch_block() of it give the stands. Errors: as require_valid(patch), and InputError naming Corners
/// if it is not 3, 4 or 6: other polygons do not tile.
PatchPattern stand_pattern(const FreePatch& patch);

/// A patch's plane: local places (x, y), the polygon's centre at the origin and the first side of the
/// helix along +x, are at origin + x x_axis + y y_axis.
struct FreeFrame {
  Vec3 origin = Vec3::Zero(), x_axis = Vec3::UnitX(), y_axis = Vec3::UnitY();
  Vec3 normal = Vec3::UnitZ();  ///< out of the material
  bool on_faces = false;        ///< else there is no plane: all of its marks are off the faces

  /// Point of local coordinates [mm].
  Vec3 at(const Vec2& p) const { return origin + p.x() * x_axis + p.y() * y_axis; }
  /// Local coordinates of the foot of a point [mm].
  Vec2 local(const Vec3& p) const { return {(p - origin).dot(x_axis), (p - origin).dot(y_axis)}; }
};

/// Patches in planes of their own with the marks of the free form.
struct FreeTexture {
  FreePatch patch;
  std::vector<HelixSide> path;  ///< of every patch, in its plane
  std::vector<HelixMark> marks;
  std::vector<FreeFrame> frames;  ///< of the patches, in milling order
};

/// A free texture and its marks as dimples, patch by patch along the path: dimple number n + k *
/// marks.size() is mark n of patch k, and {n, k} its lattice coordinates. Positions and normals are those
/// of the patch's plane, states those of the faces there.
struct PlacedFreeTexture {
  FreeTexture texture;
  Dimples dimples;
};

/// Puts the patches of `stands`, a division of stand_pattern(patch), on the faces. The plane of a patch
/// fits a grid of points of the faces, or its corners on them. Nothing if `progress` asks to stop.
/// Errors: as require_valid(patch); InputError naming FeedPerTooth if there would be more than
/// `max_dimples` marks.
std::optional<PlacedFreeTexture> place_free(const FreePatch& patch, HelixOrder order,
                                            const PatchDivision& stands,
                                            const LatticePlace& place_of, const TexturePlane& plane,
                                            const SurfaceSampler& sampler, PlaneFit fit,
                                            const Progress& progress = {},
                                            std::int64_t max_dimples = 20000000);

/// Corners of the polygon in its plane, counter-clockwise, the start of the first side first.
Polygon free_outline(const FreePatch& patch);

}  // namespace patchmill::patch

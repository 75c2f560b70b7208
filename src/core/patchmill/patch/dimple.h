// SurfacePoint and Dimple: what sampling a face and dividing it into patches give.
// Xu & Sasahara 2016, section 2.2.1: the dimples of a planar patch, projected on the target
// surface.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"

#include <array>
#include <cstdint>
#include <vector>

namespace patchmill::patch {

/// What became of one lattice point. Everything but Cut is left out of the path, and counted.
enum class DimpleState : std::uint8_t {
  Cut,       ///< will be milled
  OffFace,   ///< the ray meets no trimmed face
  TooSteep,  ///< the face's normal is further from the projection direction than the limit
  ToolTip,   ///< n parallel to t within the limit: the contact azimuth is undefined, the tip rubs
  Undercut,  ///< the face looks away from the tool, or from where the projection comes from
  NearEdge,  ///< nearer to an edge of the faces than the margin
  Sliver,    ///< its patch has too few dimples on the faces to be worth milling
  Masked,    ///< left out by an image or a curve
  NoFacet,   ///< its planar patch or facet would stand along the projection direction
  OffNet,    ///< a lattice laid on the surface does not reach so far
  Crowded,   ///< too near to another dimple
};
constexpr int kDimpleStates = 11;
const char* name(DimpleState state);

/// A place on a face and the unit normal out of the material there [mm].
struct SurfacePoint {
  Vec3 position = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();
};

/// Integer coordinates of a lattice point; the lattice says where that is in the texture plane.
using LatticePoint = std::array<std::int32_t, 2>;

/// A lattice point and what becomes of it.
struct Dimple {
  SurfacePoint surface;
  LatticePoint lattice{};
  std::int32_t patch = 0;  ///< number of its patch, in the order in which patches are milled
  DimpleState state = DimpleState::Cut;
  /// How far below the surface point the dimple's bottom lies [mm]: the ball centre is at
  /// position + (R - depth) normal. 0 where the bottoms themselves make the surface.
  double depth = 0.0;
};

/// All lattice points that were tried, in milling order: patch by patch, helix by helix. A dimple's
/// number is its index here.
using Dimples = std::vector<Dimple>;

/// Puts the bottoms of all dimples `depth` [mm] below the surface: isolated dimples, all alike.
/// Errors: InputError naming Depth if it is negative or not finite.
void sink(Dimples& dimples, double depth);

/// How many dimples there are of each state, indexed by DimpleState; the sum is dimples.size().
std::array<std::int64_t, kDimpleStates> count_states(const Dimples& dimples);

}  // namespace patchmill::patch

// SurfaceSampler: how surfaces enter the core. Whoever knows the faces (OpenCASCADE, a formula, a
// mesh) gives a function that projects places of the texture plane on them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/dimple.h"
#include "patchmill/patch/texture_plane.h"

#include <functional>

namespace patchmill::patch {

/// Where the projection ray of a place first meets the faces.
struct SurfaceSample {
  SurfacePoint point;  ///< on the ray plane.at(place) + t direction; unset if `state` is OffFace
  DimpleState state = DimpleState::OffFace;  ///< Cut, or the reason why nothing can be cut there
};

/// One sample for each place of the texture plane [mm], in the same order. Places are finite. Must
/// give the same samples for the same places and may work on them in parallel.
using SurfaceSampler = std::function<std::vector<SurfaceSample>(const std::vector<Vec2>& places)>;

/// Places of lattice coordinates in the texture plane [mm]; not finite where the lattice ends.
using LatticePlace = std::function<Vec2(const Vec2& lattice)>;

/// Whether a sample is a point on a face, even if it may not be cut.
inline bool on_face(DimpleState state) {
  return state == DimpleState::Cut || state == DimpleState::TooSteep ||
         state == DimpleState::Undercut;
}

}  // namespace patchmill::patch

// Lattices laid on the surface instead of projected on it: spacing is kept along the surface, where
// projection stretches it by up to 1/cos(slope) (Xu & Sasahara 2016, section 4.2, note it as
// constant "in the XY plane"). Only a surface of no Gaussian curvature lets all spacings be kept;
// the two ways here give up different things.
//
// Chebyshev net (Chebyshev 1878; draping of cloth, Mack & Taylor 1956): all meshes keep both their
// edges f, and the angle between them gives. The two threads through the start are straight
// (geodesic). Over a curved quadrangle at the start the angle is off from 90° by its total
// curvature, so a net cannot be laid over more than a hemisphere, and dimples stop where meshes
// close under `least_angle`.
//
// Low distortion: the places of a coarse triangular lattice that make the sum of squared relative
// changes of its edges' lengths least, edges measured along the surface; dimples between by cubic
// interpolation. What is on the faces and not steeper than `steepest` counts, and gaps wider than
// two coarse edges are not crossed. No map of a sphere's cap of angular radius θ has spacings whose
// greatest and least are nearer than θ/sin θ (Milnor 1969).
//
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/angle.h"
#include "patchmill/geometry/progress.h"
#include "patchmill/patch/division.h"
#include "patchmill/patch/node_grid.h"
#include "patchmill/patch/sampler.h"

#include <memory>
#include <optional>

namespace patchmill::patch {

/// How a lattice comes on the surface.
enum class Mapping : std::uint8_t {
  Projected,     ///< spacing kept in the texture plane (the papers)
  ChebyshevNet,  ///< both edges of every mesh kept along the surface, angles shear
  LowDistortion  ///< lengths and angles both kept as well as the curvature lets them
};

/// What lattice is asked for.
struct LatticeRequest {
  LatticeKind kind = LatticeKind::Square;
  double spacing = 0.0;                    ///< f, along the surface [mm]
  Vec2 start = Vec2::Zero();               ///< place of lattice point (0, 0), on a face [mm]
  Box2 area;                               ///< of the texture plane that is to be covered [mm]
  Angle least_angle = Angle::degrees(20);  ///< at which a Chebyshev net ends
  Angle steepest = Angle::degrees(75);     ///< slope up to which low distortion is sought
  std::int64_t max_nodes = 8000000;        ///< of a Chebyshev net
};

/// A lattice on the surface.
struct SurfaceLattice {
  LatticePlace place_of;  ///< from lattice coordinates to places of the texture plane
  /// From lattice coordinates to the faces, without a projection; empty for lattices in the plane.
  std::function<SurfaceSample(const Vec2& lattice)> sample_of;
  /// Holds all lattice points with places in the area, the lattice spread out flat with point (0,
  /// 0) at the origin [mm].
  Box2 flat;
};

/// Errors of both: InputError naming Spacing, Start (off the faces or not finite), Area, or Spacing
/// again if it takes more than `max_nodes`. Nothing if `progress` asks to stop.
std::optional<SurfaceLattice> chebyshev_net(const LatticeRequest& request,
                                            const TexturePlane& plane,
                                            const SurfaceSampler& sampler,
                                            const Progress& progress = {});
std::optional<SurfaceLattice> low_distortion_lattice(const LatticeRequest& request,
                                                     const TexturePlane& plane,
                                                     const SurfaceSampler& sampler,
                                                     const Progress& progress = {});

/// The place nearest to `wanted` that can be cut: `wanted` itself, or one of a grid of 64 x 64 over
/// `area`. Errors: InputError naming Start if there is none or `wanted` is not finite, Area if it is empty or not
/// finite.
Vec2 nearest_start(const Vec2& wanted, const Box2& area, const SurfaceSampler& sampler);

/// The lattice with another of its points as (0, 0): that next to `flat`, a place of the lattice
/// spread out flat [mm]. It is what carries a block of patches, whose anchor is `flat`.
/// `spacing` [mm], > 0. Errors: InputError naming Start if `flat` is not finite.
SurfaceLattice counted_from(const SurfaceLattice& lattice, const Vec2& flat, LatticeKind kind,
                            double spacing);

/// The patches that have lattice points with places in `area`. The division's anchor is the place
/// of lattice point (0, 0), where hexagons have their centre and the others a corner. Errors: as
/// for cover() of an area.
PatchDivision cover(const PatchPattern& pattern, const SurfaceLattice& lattice, const Box2& area,
                    std::int64_t max_dimples = 20000000);

/// Checks a request and gives the surface at its start; used by both maps.
SurfacePoint require_start(const LatticeRequest& request, const SurfaceSampler& sampler);

/// Distances of neighbouring dimples as they came out.
struct SpacingSpread {
  /// In one direction of the lattice.
  struct Direction {
    double least = 0.0, greatest = 0.0, mean = 0.0;  ///< distance / f
    std::int64_t pairs = 0;
  };
  std::array<Direction, 3> along;  ///< the lattice's 2 (square) or 3 (triangular) neighbour steps
  double least = 0.0, greatest = 0.0;  ///< over all of them
  double rms = 0.0;                    ///< root mean square of distance / f - 1
  Angle least_angle, greatest_angle;   ///< between the steps (1, 0) and (0, 1)
};

/// Straight distances in space of all cut dimples that are lattice neighbours, over `spacing`.
/// The angle is taken at each dimple that has both neighbours (1, 0) and (0, 1); if none has, least_angle is a half
/// turn and greatest_angle zero. `spacing` [mm], > 0.
SpacingSpread spacing_spread(const Dimples& dimples, LatticeKind kind, double spacing);

}  // namespace patchmill::patch

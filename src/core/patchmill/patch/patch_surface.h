// The surface of a patch: planar (Matsuda 2008), pyramid (Xu & Sasahara 2013: flat facets that meet
// in an apex), or curved (Xu & Sasahara 2016, section 2.2.1: each dimple projected on the surface).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/progress.h"
#include "patchmill/patch/division.h"
#include "patchmill/patch/sampler.h"
#include "patchmill/patch/surface_lattice.h"

#include <optional>

namespace patchmill::patch {

enum class SurfaceKind : std::uint8_t {
  Planar,   ///< one plane to a patch
  Pyramid,  ///< a facet from each edge of the outline to the apex over the patch's middle
  Curved    ///< the faces themselves
};

/// Where the plane of a planar patch lies.
enum class PlaneFit : std::uint8_t {
  BestFit,  ///< least squares of the distances to the patch's dimples on the faces
  Corners   ///< through the patch's corners on the faces (best fit to them if there are over three)
};

/// Which surface the dimples of a patch lie on.
struct PatchSurface {
  SurfaceKind kind = SurfaceKind::Curved;
  PlaneFit fit = PlaneFit::BestFit;
  /// Height of the apex over the corners' mean: 1 puts it on the surface, 0 makes the patch flat
  /// where its corners are, others exaggerate or turn the pyramid over.
  double height_factor = 1.0;
  /// Added to the apex' height, against the projection direction [mm]; gives pyramids on a plane.
  double apex_lift = 0.0;
};

/// The division's lattice points on the surface of their patches, in milling order.
///
/// A dimple is left out for the reason that the sampler gives at its own place, also on planar and
/// pyramid patches, so that a patch cut by the faces' border keeps its order without the missing
/// points. Its normal is that of the plane or facet. A corner or apex that is off the faces lies on
/// the best-fit plane of the patch's dimples that are on them. A plane or facet within 1° of the
/// projection direction makes its dimples NoFacet.
///
/// `place_of` puts lattice coordinates in the texture plane; where it is not finite, dimples are
/// OffNet. Patches are worked on in parallel; the result does not depend on the number of threads.
/// Returns nothing if `progress` asks to stop.
/// Errors: as lattice_points(division), and InputError naming HeightFactor or ApexLift if not
/// finite.
std::optional<Dimples> sample_patches(const PatchDivision& division, const TexturePlane& plane,
                                      const LatticePlace& place_of, const SurfaceSampler& sampler,
                                      const PatchSurface& surface, const Progress& progress = {});

/// As above on a lattice that is laid on the faces, by its `sample_of` if it has one.
std::optional<Dimples> sample_patches(const PatchDivision& division, const TexturePlane& plane,
                                      const SurfaceLattice& lattice, const SurfaceSampler& sampler,
                                      const PatchSurface& surface, const Progress& progress = {});

/// As above with the lattice flat in the texture plane: the papers' projected dimples.
std::optional<Dimples> sample_patches(const PatchDivision& division, const TexturePlane& plane,
                                      const SurfaceSampler& sampler, const PatchSurface& surface,
                                      const Progress& progress = {});

/// A plane by a point and the unit normal on the side that the projection comes from.
struct FitPlane {
  Vec3 point = Vec3::Zero(), normal = Vec3::UnitZ();
};

/// The plane with the least sum of squared distances to the points, from their principal axes.
/// Where they do not make a plane (fewer than three, or, seen along the unit `direction`, in a
/// strip narrower than a tenth of its length), the plane through their mean at right angles to
/// their mean normal. Nothing if there are no points.
std::optional<FitPlane> best_fit_plane(const std::vector<SurfacePoint>& points,
                                       const Vec3& direction);

}  // namespace patchmill::patch

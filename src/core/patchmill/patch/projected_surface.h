// ProjectedSurface: a surface as it is seen from a texture plane along its direction. What meets the ray of a place
// first is a sample; how it is found is the surface's own: trimmed faces (brep/face_sampler.h), triangles
// (patchmill/patch/mesh_sampler.h).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/angle.h"
#include "patchmill/geometry/progress.h"
#include "patchmill/patch/sampler.h"

#include <utility>

namespace patchmill::patch {

/// What places of a texture plane are projected on.
class ProjectedSurface {
 public:
  /// `steepest`: greatest angle between the normal out of the material and -direction that may be cut; in
  /// (0, 90) degrees. Errors: InputError naming SteepestSlope.
  ProjectedSurface(const TexturePlane& plane, Angle steepest);
  virtual ~ProjectedSurface() = default;

  /// Projects places of the texture plane [mm], many at a time. Sample i belongs to place i, whatever the number of
  /// threads. States: Cut, OffFace, TooSteep, Undercut. Empty if `progress` asked for a stop.
  std::vector<SurfaceSample> sample(const std::vector<Vec2>& places,
                                    const Progress& progress = {}) const;

  /// Rectangle of the texture plane that the surface covers: {least, greatest} coordinates [mm].
  virtual std::pair<Vec2, Vec2> extent() const = 0;

 protected:
  ProjectedSurface(const ProjectedSurface&) = default;
  ProjectedSurface(ProjectedSurface&&) = default;
  ProjectedSurface& operator=(const ProjectedSurface&) = default;
  ProjectedSurface& operator=(ProjectedSurface&&) = default;

  /// Samples of `count` places; other threads do the same meanwhile.
  virtual void sample_run(const Vec2* places, SurfaceSample* samples, std::size_t count) const = 0;

  /// Whether what has the normal (unit, out of the material) may be cut.
  DimpleState state_of(const Vec3& normal) const;
  const TexturePlane& plane() const { return plane_; }

 private:
  TexturePlane plane_;
  double least_cosine_;
};

}  // namespace patchmill::patch

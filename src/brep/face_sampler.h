// Points and normals on trimmed B-rep faces along a direction: the projection of Xu & Sasahara
// 2016, section 2.2, for any surface and any direction. For a point q of the texture plane, solve
//     S(u, v) = q + lambda d
// by Newton's method on the surface's first derivatives, from seeds that a grid of flat cells gives
// (several where the surface folds), keep the solutions inside the trimming, and of them the first
// that the ray meets. Where Newton does not converge, OpenCASCADE's own intersector is asked.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "brep/face_bins.h"
#include "brep/face_projection.h"
#include "patchmill/geometry/angle.h"
#include "patchmill/geometry/progress.h"
#include "patchmill/patch/sampler.h"
#include "patchmill/patch/texture_plane.h"

#include <memory>
#include <optional>
#include <vector>

#include <TopoDS_Face.hxx>

namespace patchmill {

class FaceSampler {
 public:
  /// `steepest`: greatest angle between the normal out of the material and -direction that may be
  /// cut; in (0, 90) degrees. Errors: InputError naming Base (no face, or a face without a surface)
  /// or SteepestSlope.
  FaceSampler(const std::vector<TopoDS_Face>& faces, const patch::TexturePlane& plane,
              Angle steepest);
  ~FaceSampler();
  FaceSampler(FaceSampler&&) noexcept;
  FaceSampler& operator=(FaceSampler&&) noexcept;

  /// Projects points of the texture plane [mm]. Only faces that may lie over a point are tried on it. Sample i
  /// belongs to point i, whatever the number of threads. Positions are exact to 1e-9 mm along the plane. States: Cut,
  /// OffFace, TooSteep, Undercut. Returns an empty vector if `progress` asked for a stop.
  std::vector<patch::SurfaceSample> sample(const std::vector<Vec2>& points,
                                           const Progress& progress = {}) const;

  /// Rectangle of the texture plane that the faces cover: {least, greatest} coordinates [mm].
  std::pair<Vec2, Vec2> extent() const;

  /// How many points of the last calls needed OpenCASCADE's intersector.
  long fallbacks() const;

 private:
  patch::DimpleState state_of(const Vec3& normal) const;
  class Workers;
  std::optional<Hit> first_hit(const Vec2& place, Workers& workers) const;

  patch::TexturePlane plane_;
  double least_cosine_;
  std::vector<std::unique_ptr<FaceProjection>> faces_;
  FaceBins bins_;
};

}  // namespace patchmill

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
#include "patchmill/patch/projected_surface.h"

#include <memory>
#include <optional>
#include <vector>

#include <TopoDS_Face.hxx>

namespace patchmill {

class FaceSampler : public patch::ProjectedSurface {
 public:
  /// Errors: InputError naming Base (no face, or a face without a surface) or what ProjectedSurface names.
  FaceSampler(const std::vector<TopoDS_Face>& faces, const patch::TexturePlane& plane,
              Angle steepest);
  ~FaceSampler() override;
  FaceSampler(FaceSampler&&) noexcept;
  FaceSampler& operator=(FaceSampler&&) noexcept;

  std::pair<Vec2, Vec2> extent() const override;

  /// How many points of the last calls needed OpenCASCADE's intersector.
  long fallbacks() const;

 private:
  // Only faces that may lie over a place are tried on it. Positions are exact to 1e-9 mm along the plane.
  void sample_run(const Vec2* places, patch::SurfaceSample* samples,
                  std::size_t count) const override;
  class Workers;
  std::optional<Hit> first_hit(const Vec2& place, Workers& workers) const;

  std::vector<std::unique_ptr<FaceProjection>> faces_;
  FaceBins bins_;
};

}  // namespace patchmill

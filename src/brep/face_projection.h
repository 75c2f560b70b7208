// One trimmed face as seen along the projection direction; FaceSampler's workhorse.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "brep/face_bins.h"
#include "brep/polynomial_of_face.h"
#include "brep/seed_grid.h"
#include "brep/trim_grid.h"
#include "patchmill/patch/dimple.h"
#include "patchmill/patch/texture_plane.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>

#include <BRepAdaptor_Surface.hxx>
#include <IntCurvesFace_Intersector.hxx>

namespace patchmill {

struct Hit {
  patch::SurfacePoint point;
  double depth;  ///< along the direction, from the texture plane [mm]
};

class FaceProjection {
 public:
  FaceProjection(const TopoDS_Face& face, const patch::TexturePlane& plane);

  /// State of one worker: an OpenCASCADE evaluator of its own, since they cache what they evaluated
  /// last (null where the polynomial serves), and scratch space.
  struct Worker {
    Handle(Adaptor3d_Surface) surface;
    std::vector<Seed> seeds, roots;  ///< of one place: where Newton's method starts, what it found
  };
  Worker worker() const;

  /// First place, by depth, where the ray through texture-plane point `q` meets the trimmed face.
  std::optional<Hit> first_hit(const Vec2& q, Worker& worker) const;

  Vec2 low() const { return seeds_.low(); }
  Vec2 high() const { return seeds_.high(); }
  /// Beyond this box there is no hit.
  PlanBox box() const { return {seeds_.low() - seeds_.reach(), seeds_.high() + seeds_.reach()}; }
  long fallbacks() const { return fallbacks_; }

 private:
  enum class Outcome { Converged, Known, Left, Failed };  // Known: of another seed
  Outcome newton(const Vec2& q, const Seed& seed, Worker& worker, Seed& root, Hit& hit) const;
  std::optional<Hit> ask_intersector(const Vec2& q, Worker& worker) const;
  bool near_known(double u, double v, const Worker& worker) const;
  Vec3 normal_near(const Seed& at, const Worker& worker) const;
  Vec3 normal_of(const SurfaceD1& at) const;
  SurfaceD1 d1(double u, double v, const Worker& worker) const;

  patch::ObliqueFrame frame_;
  patch::TexturePlane plane_;
  BRepAdaptor_Surface surface_;
  std::optional<PolynomialSurface> polynomial_;  // of spline surfaces, for speed
  bool reversed_;
  TrimGrid trim_;
  ParameterBox box_;
  SeedGrid seeds_;
  TopoDS_Face face_;
  mutable std::mutex mutex_;
  mutable std::unique_ptr<IntCurvesFace_Intersector>
      intersector_;  // made when asked; guarded by mutex_
  mutable std::atomic<long> fallbacks_{0};
};

}  // namespace patchmill

// Newton projection on one face; see face_sampler.h for the method.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/face_projection.h"

#include "patchmill/geometry/angle.h"
#include "patchmill/geometry/stop.h"

#include <algorithm>
#include <cmath>

#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <gp_Lin.hxx>

namespace patchmill {
namespace {

// Half length of the ray given to the intersector [mm].
constexpr double kRay = 1e6;
// Residual [mm] from which one linear step is exact, and the normal taken before it is too.
constexpr double kNearEnough = 1e-9;
constexpr int kMostSteps = 20;
// Of the parameter rectangle: nearer than that to a root an iteration would end there, in two steps more.
constexpr double kSameRoot = 1e-5;

Vec3 vec(const gp_XYZ& p) {
  return {p.X(), p.Y(), p.Z()};
}
gp_Pnt pnt(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

// Cells that a parameter direction takes to begin with: a few per polynomial piece, one per 15
// degrees.
int first_cells(const Adaptor3d_Surface& s, bool u) {
  switch (s.GetType()) {
    case GeomAbs_Plane:
      return 2;
    case GeomAbs_Cylinder:
    case GeomAbs_Cone:
    case GeomAbs_Sphere:
    case GeomAbs_Torus: {
      const double range =
          u ? s.LastUParameter() - s.FirstUParameter() : s.LastVParameter() - s.FirstVParameter();
      const bool angular = u || s.GetType() == GeomAbs_Sphere || s.GetType() == GeomAbs_Torus;
      return angular ? static_cast<int>(std::ceil(range / (kPi / 12.0))) : 2;
    }
    default:
      return 4 * (u ? s.NbUIntervals(GeomAbs_C2) : s.NbVIntervals(GeomAbs_C2));
  }
}

}  // namespace

FaceProjection::FaceProjection(const TopoDS_Face& face, const patch::TexturePlane& plane)
    : frame_(plane),
      plane_(plane),
      surface_(face, false),
      polynomial_(polynomial_of(face)),
      reversed_(face.Orientation() == TopAbs_REVERSED),
      trim_(face),
      box_{trim_.u_min(), trim_.u_max(), trim_.v_min(), trim_.v_max()},
      seeds_(
          [this, work = worker()](double u, double v) {
            return Vec2(frame_.coordinates(d1(u, v, work).point).head<2>());
          },
          box_, first_cells(surface_, true), first_cells(surface_, false)),
      face_(face) {}

FaceProjection::Worker FaceProjection::worker() const {
  return {polynomial_ ? Handle(Adaptor3d_Surface)() : surface_.ShallowCopy(), {}, {}};
}

SurfaceD1 FaceProjection::d1(double u, double v, const Worker& worker) const {
  if (polynomial_) return polynomial_->d1(u, v);
  gp_Pnt p;
  gp_Vec pu, pv;
  worker.surface->D1(u, v, p, pu, pv);
  return {vec(p.XYZ()), vec(pu.XYZ()), vec(pv.XYZ())};
}

Vec3 FaceProjection::normal_of(const SurfaceD1& at) const {
  return (reversed_ ? -1.0 : 1.0) * at.du.cross(at.dv).normalized();
}

// One ray from one seed. Left: the iteration went off the parameter rectangle, so there is nothing
// near.
FaceProjection::Outcome FaceProjection::newton(const Vec2& q, const Seed& seed, Worker& worker,
                                               Seed& root, Hit& hit) const {
  const double margin_u = 0.05 * (box_.u1 - box_.u0), margin_v = 0.05 * (box_.v1 - box_.v0);
  double u = seed.u, v = seed.v;
  for (int i = 0; i < kMostSteps; ++i) {
    const SurfaceD1 surface = d1(u, v, worker);
    const Vec3 at = frame_.coordinates(surface.point);
    const Vec3 su = frame_.along(surface.du), sv = frame_.along(surface.dv);
    const double ru = q.x() - at.x(), rv = q.y() - at.y();
    const double det = su.x() * sv.y() - su.y() * sv.x();
    const double most = su.lpNorm<1>() * sv.lpNorm<1>();  // not less than with roots
    if (!(std::abs(det) > 1e-9 * most) && !(std::abs(det) > 1e-9 * (su.norm() * sv.norm())))
      return Outcome::Failed;
    const double du = (ru * sv.y() - rv * sv.x()) / det, dv = (su.x() * rv - su.y() * ru) / det;
    u += du;
    v += dv;
    if (std::abs(ru) + std::abs(rv) < kNearEnough) {
      root = {u, v};
      hit.depth = at.z() + du * su.z() + dv * sv.z();
      hit.point.position = plane_.at(q) + hit.depth * plane_.direction;
      hit.point.normal = normal_of(surface);
      return Outcome::Converged;
    }
    if (u < box_.u0 - margin_u || u > box_.u1 + margin_u || v < box_.v0 - margin_v ||
        v > box_.v1 + margin_v)
      return Outcome::Left;
    if (near_known(u, v, worker)) return Outcome::Known;
  }
  return Outcome::Failed;
}

bool FaceProjection::near_known(double u, double v, const Worker& worker) const {
  for (const Seed& root : worker.roots)
    if (std::abs(u - root.u) < kSameRoot * (box_.u1 - box_.u0) &&
        std::abs(v - root.v) < kSameRoot * (box_.v1 - box_.v0))
      return true;
  return false;
}

std::optional<Hit> FaceProjection::first_hit(const Vec2& q, Worker& worker) const {
  worker.seeds.clear();
  worker.roots.clear();
  seeds_.seeds(q, worker.seeds);
  std::optional<Hit> first;
  bool failed = false;
  for (const Seed& seed : worker.seeds) {
    Seed root;
    Hit hit;
    const Outcome outcome = newton(q, seed, worker, root, hit);
    if (outcome == Outcome::Failed) failed = true;
    if (outcome != Outcome::Converged) continue;
    worker.roots.push_back(root);
    if (first && hit.depth >= first->depth) continue;
    if (trim_.inside(root.u, root.v)) first = hit;
  }
  if (!failed) return first;
  const std::optional<Hit> asked = ask_intersector(q, worker);
  return asked && (!first || asked->depth < first->depth) ? asked : first;
}

std::optional<Hit> FaceProjection::ask_intersector(const Vec2& q, Worker& worker) const {
  stop_point();
  ++fallbacks_;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!intersector_)
    intersector_ = std::make_unique<IntCurvesFace_Intersector>(face_, Precision::Confusion());
  const Vec3 from = plane_.at(q);
  const gp_Dir direction(plane_.direction.x(), plane_.direction.y(), plane_.direction.z());
  intersector_->Perform(gp_Lin(pnt(from), direction), -kRay, kRay);
  std::optional<Hit> first;
  worker.roots.clear();
  if (!intersector_->IsDone()) return first;
  for (int k = 1; k <= intersector_->NbPnt(); ++k) {
    const Seed found{intersector_->UParameter(k), intersector_->VParameter(k)};
    Seed root;
    Hit hit;
    if (newton(q, found, worker, root, hit) != Outcome::Converged) {
      hit.depth = intersector_->WParameter(k);
      hit.point = {from + hit.depth * plane_.direction, normal_near(found, worker)};
    }
    if (!first || hit.depth < first->depth) first = hit;
  }
  return first;
}

// The normal at a place where the parametrisation may be degenerate (a pole): a hair's breadth
// inside.
Vec3 FaceProjection::normal_near(const Seed& at, const Worker& worker) const {
  const double u_middle = 0.5 * (box_.u0 + box_.u1), v_middle = 0.5 * (box_.v0 + box_.v1);
  return normal_of(d1(at.u + 1e-7 * (u_middle - at.u), at.v + 1e-7 * (v_middle - at.v), worker));
}

}  // namespace patchmill

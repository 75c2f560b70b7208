// How near a frustum comes to a mesh: the least over the mesh of the signed distance from it, by branch and bound.
// A frustum is convex, so that the distance is, and its tangent plane in the middle of a box of the mesh's tree or of
// a triangle bounds it there (frustum.h): what cannot come below the least found so far by more than the resolution is
// left out; triangles are halved across their longest side until that decides.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/collision/sweep.h"
#include "patchmill/mesh/triangle_bvh.h"

namespace patchmill::collision {

/// Least signed distance of a mesh from frusta on one axis through `origin` [mm], wherever they are on their way from
/// there along `travel` [mm]; the axis is of unit length. The mesh must outlive it.
class FrustumSearch {
 public:
  /// Finds distances to `resolution` [mm, > 0], or to the fraction `relative` of how far they are below the best so
  /// far that nearer() is given, if that is more; those below `stop` need not be found any better.
  FrustumSearch(const mesh::TriangleBvh& mesh, const Vec3& origin, const Vec3& axis,
                double resolution, double stop, const Vec3& travel = Vec3::Zero(),
                double relative = 0.0);

  /// Least distance from one more frustum, if it is less than `best`; `best` again if not.
  double nearer(const Frustum& frustum, double best);

  /// Point of the mesh where the least distance of all calls was found.
  const Vec3& point() const { return point_; }
  /// The fraction of the travel there, 0 .. 1.
  double fraction() const { return fraction_; }

 private:
  SweptDistance distance(const Frustum& frustum, const Vec3& p) const {
    if (!still_) return swept_distance(frustum, origin_, axis_, travel_, p);
    const SignedDistance d = frustum_distance(frustum, origin_, axis_, p);
    return {d.value, d.gradient, 0.0};
  }
  bool decided(double bound) const;
  double bound(const Frustum& frustum, const mesh::BvhNode& node) const;
  void triangle(const Frustum& frustum, const mesh::Triangle& t);

  const mesh::TriangleBvh& mesh_;
  Vec3 origin_, axis_, travel_;
  bool still_;  // there is no way to go
  double resolution_, stop_, relative_;
  double best_ = 0.0, given_ = 0.0;
  Vec3 point_ = Vec3::Zero();
  double fraction_ = 0.0;
};

}  // namespace patchmill::collision

// Points that move on a surface known only by its sampler: what lattices laid on the surface are
// built from. A place (x, y) of the texture plane stands for the surface point over it, and moving
// the place by dx moves the point along the tangent e_x - d (n·e_x)/(n·d).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/sampler.h"

namespace patchmill::patch {

/// A point of the surface, or of a plane that carries it on where the faces end.
struct WalkPoint {
  Vec2 place = Vec2::Zero();
  Vec3 position = Vec3::Zero(), normal = Vec3::UnitZ();
  bool on_face = false;  ///< a point of the faces that the projection can see
};

/// What takes the faces' place where a ray misses them: a plane for the point, and the normal
/// there.
struct ExtensionPlane {
  Vec3 point = Vec3::Zero(), normal = Vec3::UnitZ(), normal_there = Vec3::UnitZ();
};

/// The extension from `point` with unit `normal` over a step on which the normal turns by `change`:
/// the chord of an arc lies at right angles to the normal half-way, so that a surface of constant
/// curvature goes on as it was, to third order in the step. Normals are kept within 75° of the
/// projection, so that steps get on.
ExtensionPlane extension(const Vec3& point, const Vec3& normal, const Vec3& change,
                         const TexturePlane& plane);

/// The extension for the fourth corner of a mesh, across from `c` and next to `a` and `b`.
inline ExtensionPlane parallelogram(const WalkPoint& a, const WalkPoint& b, const WalkPoint& c,
                                    const TexturePlane& plane) {
  const Vec3 normal = (a.normal + b.normal).normalized();
  return extension(0.5 * (a.position + b.position), normal, normal - c.normal, plane);
}

/// Place of a point of space, along the projection direction.
Vec2 place_of_point(const TexturePlane& plane, const Vec3& point);

/// The point over `place`: the sample if it is on a face (and not steeper than 85°), else on the
/// extension.
WalkPoint walk_point(const TexturePlane& plane, const Vec2& place, const SurfaceSample& sample,
                     const ExtensionPlane& extension);

/// Tangents of the surface for unit moves of the place along x and y, as columns.
Eigen::Matrix<double, 3, 2> tangents(const TexturePlane& plane, const Vec3& normal);

/// A place wanted at `length` from `a`, and either at the same length from `b` (a mesh of a net) or
/// at right angles to `across` (a straight step from `a`).
struct WalkStep {
  const WalkPoint* a = nullptr;
  const WalkPoint* b = nullptr;  ///< or null
  Vec3 across = Vec3::Zero();    ///< if `b` is null; unit
  double length = 0.0;
  ExtensionPlane extension;  ///< for where the faces end
  WalkPoint at;              ///< the first guess (its place counts), then the result
  bool reached = false;      ///< found to 1e-9 of the length, or as near as 1e-3
};

/// Takes all steps together by Newton's method, with one call of the sampler for each iteration.
void take_steps(const TexturePlane& plane, const SurfaceSampler& sampler,
                std::vector<WalkStep>& steps);

}  // namespace patchmill::patch

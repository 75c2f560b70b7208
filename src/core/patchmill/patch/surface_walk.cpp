// Newton's method for points at given distances on a sampled surface; see surface_walk.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/surface_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>

namespace patchmill::patch {
namespace {

constexpr double kSteepest = 0.0872;      // cos 85°
constexpr double kLeastOutside = 0.2588;  // cos 75°
constexpr int kIterations = 14;

// What is missing of a step, in units of its length, and how that changes with the place.
struct Residual {
  Vec2 value;
  Eigen::Matrix2d slope;
};

Residual residual(const TexturePlane& plane, const WalkStep& s) {
  const auto along = tangents(plane, s.at.normal);
  const Vec3 from_a = s.at.position - s.a->position;
  const double a = std::max(from_a.norm(), 1e-12);
  Residual r;
  r.value[0] = a - s.length;
  r.slope.row(0) = from_a.transpose() / a * along;
  if (s.b) {
    const Vec3 from_b = s.at.position - s.b->position;
    const double b = std::max(from_b.norm(), 1e-12);
    r.value[1] = b - s.length;
    r.slope.row(1) = from_b.transpose() / b * along;
  } else {
    r.value[1] = from_a.dot(s.across);
    r.slope.row(1) = s.across.transpose() * along;
  }
  return r;
}

// The unit vector of `normal`, brought within 75° of `up`.
Vec3 limited(const Vec3& normal, const Vec3& up) {
  const Vec3 unit = normal.normalized();
  const double facing = unit.dot(up);
  if (facing >= kLeastOutside) return unit;
  const Vec3 level = unit - facing * up;
  if (!(level.norm() > 1e-9)) return up;
  return kLeastOutside * up + std::sqrt(1.0 - kLeastOutside * kLeastOutside) * level.normalized();
}

}  // namespace

ExtensionPlane extension(const Vec3& point, const Vec3& normal, const Vec3& change,
                         const TexturePlane& plane) {
  return {point, limited(normal + 0.5 * change, -plane.direction),
          limited(normal + change, -plane.direction)};
}

Vec2 place_of_point(const TexturePlane& plane, const Vec3& point) {
  const Vec3 normal = plane.x_axis.cross(plane.y_axis), off = point - plane.origin;
  const Vec3 in_plane = off - off.dot(normal) / plane.direction.dot(normal) * plane.direction;
  return {in_plane.dot(plane.x_axis), in_plane.dot(plane.y_axis)};
}

WalkPoint walk_point(const TexturePlane& plane, const Vec2& place, const SurfaceSample& sample,
                     const ExtensionPlane& extension) {
  if (on_face(sample.state) && -sample.point.normal.dot(plane.direction) > kSteepest)
    return {place, sample.point.position, sample.point.normal, true};
  const Vec3 from = plane.at(place);
  const double t =
      (extension.point - from).dot(extension.normal) / plane.direction.dot(extension.normal);
  return {place, from + t * plane.direction, extension.normal_there, false};
}

Eigen::Matrix<double, 3, 2> tangents(const TexturePlane& plane, const Vec3& normal) {
  const double facing = normal.dot(plane.direction);
  Eigen::Matrix<double, 3, 2> t;
  t.col(0) = plane.x_axis - normal.dot(plane.x_axis) / facing * plane.direction;
  t.col(1) = plane.y_axis - normal.dot(plane.y_axis) / facing * plane.direction;
  return t;
}

void take_steps(const TexturePlane& plane, const SurfaceSampler& sampler,
                std::vector<WalkStep>& steps) {
  std::vector<WalkStep*> open;
  for (WalkStep& s : steps) open.push_back(&s);
  std::vector<Vec2> places;
  for (int iteration = 0; iteration < kIterations && !open.empty(); ++iteration) {
    places.clear();
    for (const WalkStep* s : open) places.push_back(s->at.place);
    const std::vector<SurfaceSample> samples = sampler(places);
    std::vector<WalkStep*> still;
    for (std::size_t k = 0; k < open.size(); ++k) {
      WalkStep& s = *open[k];
      s.at = walk_point(plane, s.at.place, samples[k], s.extension);
      const Residual r = residual(plane, s);
      const double miss = r.value.norm() / s.length;
      s.reached = miss < 1e-3;
      if (miss < 1e-9) continue;
      Vec2 move = -r.slope.fullPivLu().solve(r.value);
      if (!move.allFinite()) {
        s.reached = false;
        continue;
      }
      // no move longer than the step itself: far from the answer Newton overshoots
      const double far = (tangents(plane, s.at.normal) * move).norm() / s.length;
      if (far > 0.7) move *= 0.7 / far;
      if (iteration + 1 < kIterations) s.at.place += move;
      still.push_back(&s);
    }
    open.swap(still);
  }
}

}  // namespace patchmill::patch

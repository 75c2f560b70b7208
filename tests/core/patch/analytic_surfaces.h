// Surfaces with a formula, as samplers: what a face of a part is to the core, without a part.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/sampler.h"

#include <cmath>
#include <optional>

namespace patchmill::analytic {

using Ray =
    std::function<std::optional<patch::SurfacePoint>(const Vec3& from, const Vec3& direction)>;

inline patch::SurfaceSampler by_rays(const patch::TexturePlane& plane, const Ray& ray) {
  return [plane, ray](const std::vector<Vec2>& places) {
    std::vector<patch::SurfaceSample> samples(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
      if (const auto hit = ray(plane.at(places[i]), plane.direction))
        samples[i] = {*hit, hit->normal.dot(plane.direction) < 0.0 ? patch::DimpleState::Cut
                                                                   : patch::DimpleState::Undercut};
    return samples;
  };
}

/// Upper half of what the ray meets of a sphere: the first of the two points.
inline Ray sphere(const Vec3& centre, double radius) {
  return [=](const Vec3& from, const Vec3& d) -> std::optional<patch::SurfacePoint> {
    const Vec3 a = from - centre;
    const double b = a.dot(d), c = a.squaredNorm() - radius * radius, root = b * b - c;
    if (root <= 0.0) return std::nullopt;
    const Vec3 p = from + (-b - std::sqrt(root)) * d;
    return patch::SurfacePoint{p, (p - centre) / radius};
  };
}

/// Cylinder about a line through `on` along unit `axis`.
inline Ray cylinder(const Vec3& on, const Vec3& axis, double radius) {
  return [=](const Vec3& from, const Vec3& d) -> std::optional<patch::SurfacePoint> {
    auto across = [&](const Vec3& v) { return Vec3(v - v.dot(axis) * axis); };
    const Vec3 a = across(from - on), e = across(d);
    const double b = a.dot(e), c = a.squaredNorm() - radius * radius;
    const double root = b * b - e.squaredNorm() * c;
    if (root <= 0.0) return std::nullopt;
    const Vec3 p = from + (-b - std::sqrt(root)) / e.squaredNorm() * d;
    return patch::SurfacePoint{p, across(p - on) / radius};
  };
}

inline Ray flat(const Vec3& on, const Vec3& normal) {
  return [=](const Vec3& from, const Vec3& d) -> std::optional<patch::SurfacePoint> {
    if (!(normal.dot(d) < 0.0)) return std::nullopt;
    return patch::SurfacePoint{from + normal.dot(on - from) / normal.dot(d) * d, normal};
  };
}

/// z = height(x, y) seen along -z from a texture plane at z = 0 with the world's x and y axes.
inline Ray height_field(std::function<double(double, double)> height,
                        std::function<Vec2(double, double)> slope) {
  return [=](const Vec3& from, const Vec3&) -> std::optional<patch::SurfacePoint> {
    const Vec2 s = slope(from.x(), from.y());
    return patch::SurfacePoint{{from.x(), from.y(), height(from.x(), from.y())},
                               Vec3(-s.x(), -s.y(), 1.0).normalized()};
  };
}

/// Waves of both signs of curvature: z = h sin(kx) cos(ky).
inline Ray waves(double h, double length) {
  const double k = 2.0 * 3.14159265358979323846 / length;
  return height_field([=](double x, double y) { return h * std::sin(k * x) * std::cos(k * y); },
                      [=](double x, double y) {
                        return Vec2(h * k * std::cos(k * x) * std::cos(k * y),
                                    -h * k * std::sin(k * x) * std::sin(k * y));
                      });
}

/// Outer upper part of a torus about the z axis.
inline Ray torus(double major, double minor) {
  return height_field(
      [=](double x, double y) {
        const double d = std::hypot(x, y) - major;
        return std::sqrt(std::max(0.0, minor * minor - d * d));
      },
      [=](double x, double y) {
        const double r = std::hypot(x, y), d = r - major;
        const double z = std::sqrt(std::max(1e-12, minor * minor - d * d));
        return Vec2(-d / z * x / r, -d / z * y / r);
      });
}

/// The part of a surface where `inside` is true of the point.
inline Ray trimmed(Ray ray, std::function<bool(const patch::SurfacePoint&)> inside) {
  return [=](const Vec3& from, const Vec3& d) -> std::optional<patch::SurfacePoint> {
    auto hit = ray(from, d);
    return hit && inside(*hit) ? hit : std::nullopt;
  };
}

}  // namespace patchmill::analytic

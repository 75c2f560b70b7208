// Stands, planes and marks of patches in free form; see free_texture.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/free_texture.h"

#include "patchmill/geometry/angle.h"
#include "patchmill/geometry/error.h"
#include "patchmill/patch/surface_walk.h"

#include <cmath>

#include <fmt/format.h>

namespace patchmill::patch {
namespace {

constexpr int kFitGrid = 7;
constexpr double kLeastSlope = 0.0175;  // sin 1°, as for planar patches

// Where a patch stands: lattice coordinates of its centre, and how it is turned in its plane.
struct Stand {
  Vec2 lattice;
  double turn;
};

std::vector<Stand> stands_of(const FreePatch& patch, const PatchDivision& division) {
  std::vector<Stand> stands;
  for (const PatchCell& cell : division.cells) {
    const Vec2 at = to_vec(cell_origin(division.pattern, cell));
    if (patch.corners == 4) {
      stands.push_back({at, 0.0});
    } else if (patch.corners == 6) {
      stands.push_back({at, kPi / 6.0});
    } else {  // the two triangles of the mesh around the point
      stands.push_back({at - Vec2::Constant(1.0 / 6.0), 0.0});
      stands.push_back({at + Vec2::Constant(1.0 / 6.0), kPi});
    }
  }
  return stands;
}

// Direction of the lattice's first axis in the texture plane, as a vector of space.
Vec3 first_axis(const Stand& stand, const LatticePlace& place_of, const TexturePlane& plane) {
  const Vec2 step =
      place_of(stand.lattice + Vec2(0.25, 0)) - place_of(stand.lattice - Vec2(0.25, 0));
  if (!step.allFinite() || !(step.norm() > 0.0)) return plane.x_axis;
  return step.x() * plane.x_axis + step.y() * plane.y_axis;
}

// The frame on a plane, its origin over `place`.
FreeFrame frame_on(const FitPlane& fit, const Vec2& place, const Vec3& axis, double turn,
                   const TexturePlane& plane) {
  FreeFrame frame;
  const double facing = plane.direction.dot(fit.normal);
  const Vec3 from = plane.at(place);
  frame.origin = from + (fit.point - from).dot(fit.normal) / facing * plane.direction;
  frame.normal = fit.normal;
  const Vec3 x = (axis - axis.dot(fit.normal) / facing * plane.direction).normalized();
  const Vec3 y = fit.normal.cross(x);
  frame.x_axis = std::cos(turn) * x + std::sin(turn) * y;
  frame.y_axis = std::cos(turn) * y - std::sin(turn) * x;
  frame.on_faces = true;
  return frame;
}

bool inside(const Polygon& polygon, const Vec2& p) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 edge = polygon[(i + 1) % polygon.size()] - polygon[i], to = p - polygon[i];
    if (edge.x() * to.y() - edge.y() * to.x() < 0.0) return false;
  }
  return true;
}

// Local places at which a patch's plane is fitted to the faces.
Polygon fit_places(const FreePatch& patch, PlaneFit fit) {
  const Polygon outline = free_outline(patch);
  if (fit == PlaneFit::Corners) return outline;
  Box2 around;
  for (const Vec2& p : outline) around.extend(p);
  Polygon places = outline;
  for (int i = 0; i < kFitGrid; ++i)
    for (int j = 0; j < kFitGrid; ++j) {
      const Vec2 share((i + 0.5) / kFitGrid, (j + 0.5) / kFitGrid);
      const Vec2 p = around.min() + share.cwiseProduct(around.sizes());
      if (inside(outline, p)) places.push_back(p);
    }
  return places;
}

std::vector<SurfaceSample> samples_at(const FreeFrame& frame, const Polygon& local,
                                      const TexturePlane& plane, const SurfaceSampler& sampler) {
  std::vector<Vec2> places;
  for (const Vec2& p : local) places.push_back(place_of_point(plane, frame.at(p)));
  return sampler(places);
}

// The tangent plane under the patch's centre, or, if that is off the faces, under a corner.
FreeFrame first_frame(const FreePatch& patch, const Vec2& centre, const Vec3& axis, double turn,
                      const TexturePlane& plane, const SurfaceSampler& sampler) {
  const FreeFrame level = frame_on({plane.origin, -plane.direction}, centre, axis, turn, plane);
  Polygon tried{Vec2::Zero()};
  for (const Vec2& corner : free_outline(patch)) tried.push_back(corner);
  for (const SurfaceSample& s : samples_at(level, tried, plane, sampler))
    if (on_face(s.state) && -s.point.normal.dot(plane.direction) > kLeastSlope)
      return frame_on({s.point.position, s.point.normal}, centre, axis, turn, plane);
  return {};
}

FreeFrame fitted_frame(const FreePatch& patch, const Stand& stand, const LatticePlace& place_of,
                       const TexturePlane& plane, const SurfaceSampler& sampler,
                       const Polygon& fit) {
  const Vec2 centre = place_of(stand.lattice);
  if (!centre.allFinite()) return {};
  const Vec3 axis = first_axis(stand, place_of, plane);
  const FreeFrame first = first_frame(patch, centre, axis, stand.turn, plane, sampler);
  if (!first.on_faces) return {};
  std::vector<SurfacePoint> points;
  for (const SurfaceSample& s : samples_at(first, fit, plane, sampler))
    if (on_face(s.state)) points.push_back(s.point);
  const auto best = best_fit_plane(points, plane.direction);
  if (!best || !(-best->normal.dot(plane.direction) > kLeastSlope)) return first;
  return frame_on(*best, centre, axis, stand.turn, plane);
}

}  // namespace

PatchPattern stand_pattern(const FreePatch& patch) {
  require_valid(patch);
  switch (patch.corners) {
    case 3:
      return {PatchShape::Hexagon, patch.side, 0};
    case 4:
      return {PatchShape::Square, patch.side, 1};
    case 6:
      return {PatchShape::Hexagon, std::sqrt(3.0) * patch.side, 0};
    default:
      throw InputError("Corners", fmt::format("{}", patch.corners),
                       "choose 3, 4 or 6: other regular polygons do not cover a face.");
  }
}

Polygon free_outline(const FreePatch& patch) {
  const double step = 2.0 * kPi / patch.corners;
  const double radius = 0.5 * patch.side / std::sin(0.5 * step);
  Polygon corners;
  for (int i = 0; i < patch.corners; ++i) {
    const double angle = -0.5 * kPi + (i - 0.5) * step;
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return corners;
}

std::optional<PlacedFreeTexture> place_free(const FreePatch& patch, HelixOrder order,
                                            const PatchDivision& division,
                                            const LatticePlace& place_of, const TexturePlane& plane,
                                            const SurfaceSampler& sampler, PlaneFit fit,
                                            const Progress& progress, std::int64_t max_dimples) {
  PlacedFreeTexture placed;
  FreeTexture& texture = placed.texture;
  texture.patch = patch;
  texture.path = helix_path(patch, order);
  texture.marks = helix_marks(texture.path, patch.feed_per_tooth);
  const std::vector<Stand> stands = stands_of(patch, division);
  const double count = double(stands.size()) * double(texture.marks.size());
  if (count > double(max_dimples))
    throw InputError("FeedPerTooth", fmt::format("{} mm", patch.feed_per_tooth),
                     fmt::format("{:.0f} marks are more than the limit of {}: choose a larger feed "
                                 "per tooth or fewer patches.",
                                 count, max_dimples));
  const Polygon fit_at = fit_places(patch, fit);
  Polygon marks;
  for (const HelixMark& mark : texture.marks) marks.push_back(mark.place);
  placed.dimples.reserve(static_cast<std::size_t>(count));
  for (std::size_t k = 0; k < stands.size(); ++k) {
    texture.frames.push_back(fitted_frame(patch, stands[k], place_of, plane, sampler, fit_at));
    const FreeFrame& frame = texture.frames.back();
    std::vector<SurfaceSample> samples(marks.size());
    if (frame.on_faces) samples = samples_at(frame, marks, plane, sampler);
    for (std::size_t n = 0; n < marks.size(); ++n) {
      Dimple dimple;
      dimple.patch = static_cast<std::int32_t>(k);
      dimple.lattice = {static_cast<std::int32_t>(n), dimple.patch};
      dimple.state = samples[n].state;
      if (on_face(dimple.state)) dimple.surface = {frame.at(marks[n]), frame.normal};
      placed.dimples.push_back(dimple);
    }
    if (!go_on(progress, double(k + 1) / double(stands.size()))) return std::nullopt;
  }
  return placed;
}

}  // namespace patchmill::patch

// The first triangle on a line, through the tree; see mesh_sampler.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/mesh_sampler.h"

#include "patchmill/geometry/stop.h"
#include "patchmill/mesh/parity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace patchmill::patch {
namespace {

constexpr std::size_t kLook = 16;  // places between looks whether to stop
constexpr double kFar = std::numeric_limits<double>::infinity();

}  // namespace

// The line of a place, for boxes: from its point next to the middle of the mesh, so that numbers stay small.
class MeshSampler::Line {
 public:
  Line(const Vec3& from, const Vec3& direction, const Vec3& middle, double slack)
      : along_(direction.dot(middle - from)), start_(from + along_ * direction), slack_(slack) {
    for (int k = 0; k < 3; ++k) inverse_[k] = 1.0 / direction[k];
  }

  /// Depth at which the line comes into a box, or infinity. Of a box that is touched it is no greater than that of
  /// any point in it.
  double entry(const mesh::BvhNode& node) const {
    double first = -kFar, last = kFar;
    for (int k = 0; k < 3; ++k) {
      const double lo = node.lo[k] - slack_ - start_[k], hi = node.hi[k] + slack_ - start_[k];
      if (std::isinf(inverse_[k])) {
        if (lo > 0.0 || hi < 0.0) return kFar;
        continue;
      }
      const auto [from, to] = std::minmax({lo * inverse_[k], hi * inverse_[k]});
      first = std::max(first, from);
      last = std::min(last, to);
    }
    return first <= last ? along_ + first - slack_ : kFar;
  }

 private:
  double along_;
  Vec3 start_;
  double slack_;
  Vec3 inverse_;
};

MeshSampler::MeshSampler(std::shared_ptr<const MeshSurface> surface, const TexturePlane& plane,
                         Angle steepest)
    : ProjectedSurface(plane, steepest), surface_(std::move(surface)), frame_(plane), slack_(0.0) {
  if (!surface_) throw InputError("Base", "no mesh", "give the surface that is projected on.");
  const mesh::BvhNode& all = surface_->bvh().nodes()[0];
  const double size = (all.hi - all.lo).norm() + all.lo.norm() + plane.origin.norm();
  slack_ = 1e-11 * size * frame_.inverse.norm();
}

void MeshSampler::sample_run(const Vec2* places, SurfaceSample* samples, std::size_t count) const {
  for (std::size_t i = 0; i < count; ++i) {
    if (i % kLook == 0) stop_point();
    const std::optional<Hit> hit = first_hit(places[i]);
    if (!hit) continue;
    const SurfacePoint point = point_at(places[i], *hit);
    samples[i] = {point, state_of(point.normal)};
  }
}

// A triangle as (depth, x, y), for lines along the first axis.
mesh::Triangle MeshSampler::seen(std::int32_t triangle) const {
  const mesh::Triangle& t = surface_->bvh().triangles()[std::size_t(triangle)];
  const auto turned = [&](const Vec3& p) {
    const Vec3 c = frame_.coordinates(p);
    return Vec3(c.z(), c.x(), c.y());
  };
  return {turned(t.a), turned(t.b), turned(t.c)};
}

std::optional<MeshSampler::Hit> MeshSampler::first_hit(const Vec2& place) const {
  if (!place.allFinite()) return std::nullopt;
  const mesh::TriangleBvh& bvh = surface_->bvh();
  const mesh::BvhNode& root = bvh.nodes()[0];
  const Line line(plane().at(place), plane().direction, 0.5 * (root.lo + root.hi), slack_);
  struct Visit {
    std::int32_t node;
    double entry;
  };
  std::array<Visit, 64> stack;
  std::size_t top = 0;
  stack[top++] = {0, line.entry(root)};
  Hit first{-1, kFar};
  while (top > 0) {
    const Visit visit = stack[--top];
    if (visit.entry == kFar || visit.entry > first.depth) continue;
    const mesh::BvhNode& node = bvh.nodes()[std::size_t(visit.node)];
    if (node.count == 0) {
      Visit left{node.first, line.entry(bvh.nodes()[std::size_t(node.first)])};
      Visit right{node.first + 1, line.entry(bvh.nodes()[std::size_t(node.first) + 1])};
      if (left.entry < right.entry) std::swap(left, right);
      stack[top++] = left;  // the nearer one is looked at first
      stack[top++] = right;
      continue;
    }
    double depth = 0.0;
    for (std::int32_t i = node.first; i < node.first + node.count; ++i)
      if (mesh::line_crosses(seen(i), place.x(), place.y(), depth) && depth < first.depth)
        first = {i, depth};
  }
  if (first.triangle < 0) return std::nullopt;
  return first;
}

SurfacePoint MeshSampler::point_at(const Vec2& place, const Hit& hit) const {
  const Vec3 p = plane().at(place) + hit.depth * plane().direction;
  const mesh::Triangle& t = surface_->bvh().triangles()[std::size_t(hit.triangle)];
  const auto number = std::size_t(surface_->bvh().order()[std::size_t(hit.triangle)]);
  const std::array<Vec3, 3>& corners = surface_->normals()[number];
  const Vec3 area = (t.b - t.a).cross(t.c - t.a);
  const Vec3 weights = Vec3(area.dot((t.b - p).cross(t.c - p)), area.dot((t.c - p).cross(t.a - p)),
                            area.dot((t.a - p).cross(t.b - p)))
                           .cwiseMax(0.0);
  Vec3 normal = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
  if (!(weights.sum() > 0.0)) normal = corners[0] + corners[1] + corners[2];
  const double length = normal.norm();
  return {p, length > 0.0 ? Vec3(normal / length) : corners[0]};
}

std::pair<Vec2, Vec2> MeshSampler::extent() const {
  Vec2 low = Vec2::Constant(kFar), high = Vec2::Constant(-kFar);
  for (const auto& triangle : surface_->mesh().triangles)
    for (const std::int32_t v : triangle) {
      const Vec2 p = frame_.coordinates(surface_->mesh().vertices[std::size_t(v)]).head<2>();
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  return {low, high};
}

}  // namespace patchmill::patch

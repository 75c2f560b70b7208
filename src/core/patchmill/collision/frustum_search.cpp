// Branch and bound over a mesh with tangent planes as bounds; see frustum_search.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/collision/frustum_search.h"

#include "patchmill/geometry/stop.h"

#include <algorithm>

namespace patchmill::collision {

FrustumSearch::FrustumSearch(const mesh::TriangleBvh& mesh, const Vec3& origin, const Vec3& axis,
                             double resolution, double stop, const Vec3& travel, double relative)
    : mesh_(mesh),
      origin_(origin),
      axis_(axis),
      travel_(travel),
      still_(travel.isZero(0.0)),
      resolution_(resolution),
      stop_(stop),
      relative_(relative) {}

bool FrustumSearch::decided(double bound) const {
  return best_ < stop_ || bound >= best_ - std::max(resolution_, relative_ * (given_ - best_));
}

// No point of the box is nearer.
double FrustumSearch::bound(const Frustum& frustum, const mesh::BvhNode& node) const {
  const auto d = distance(frustum, 0.5 * (node.lo + node.hi));
  return d.value - 0.5 * d.gradient.cwiseAbs().dot(node.hi - node.lo);
}

double FrustumSearch::nearer(const Frustum& frustum, double best) {
  stop_point();
  best_ = given_ = best;
  struct Visit {
    std::int32_t node;
    double bound;
  };
  Visit stack[64];
  int top = 0;
  stack[top++] = {0, bound(frustum, mesh_.nodes()[0])};
  while (top > 0) {
    const Visit visit = stack[--top];
    if (decided(visit.bound)) continue;
    const mesh::BvhNode& node = mesh_.nodes()[visit.node];
    for (std::int32_t i = node.first; i < node.first + node.count; ++i)
      triangle(frustum, mesh_.triangles()[i]);
    if (node.count > 0) continue;
    const double l = bound(frustum, mesh_.nodes()[node.first]);
    const double r = bound(frustum, mesh_.nodes()[node.first + 1]);
    stack[top++] = {node.first + (l <= r ? 1 : 0), std::max(l, r)};
    stack[top++] = {node.first + (l <= r ? 0 : 1), std::min(l, r)};
  }
  return best_;
}

void FrustumSearch::triangle(const Frustum& frustum, const mesh::Triangle& t) {
  const Vec3 middle = (t.a + t.b + t.c) / 3.0;
  const auto d = distance(frustum, middle);
  if (d.value < best_) {
    best_ = d.value;
    point_ = middle;
    fraction_ = d.fraction;
  }
  const Vec3& g = d.gradient;
  if (decided(d.value + std::min({g.dot(t.a - middle), g.dot(t.b - middle), g.dot(t.c - middle)})))
    return;
  const double ab = (t.b - t.a).norm(), bc = (t.c - t.b).norm(), ca = (t.a - t.c).norm();
  if (ab < std::max(bc, ca)) return triangle(frustum, {t.b, t.c, t.a});  // the longest in front
  const Vec3 half = 0.5 * (t.a + t.b);
  const mesh::Triangle first{t.c, t.a, half}, second{t.b, t.c, half};
  const bool first_nearer = g.dot(t.a) <= g.dot(t.b);
  triangle(frustum, first_nearer ? first : second);
  triangle(frustum, first_nearer ? second : first);
}

}  // namespace patchmill::collision

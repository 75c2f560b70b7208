// Bounding-box tree over triangles.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/mesh/triangle_bvh.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"
#include "patchmill/mesh/parity.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace patchmill::mesh {
namespace {

constexpr std::int32_t kLeaf = 4;

double box_distance_squared(const BvhNode& node, const Vec3& p) {
  return (node.lo - p).cwiseMax(p - node.hi).cwiseMax(0.0).squaredNorm();
}

// Barycentric weights of the point of a triangle nearest to p (Ericson 2005, section 5.1.5).
Vec3 closest_weights(const Triangle& t, const Vec3& p) {
  const Vec3 ab = t.b - t.a, ac = t.c - t.a, ap = p - t.a, bp = p - t.b, cp = p - t.c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp);
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  if (va <= 0 && d4 >= d3 && d5 >= d6) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - w, w};
  }
  const double sum = va + vb + vc;
  return {1 - vb / sum - vc / sum, vb / sum, vc / sum};
}

void visit_leaf(const TriangleBvh& bvh, const BvhNode& node, const Vec3& p, ClosestPoint& best) {
  for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
    const Triangle& t = bvh.triangles()[i];
    const Vec3 w = closest_weights(t, p);
    const Vec3 q = w[0] * t.a + w[1] * t.b + w[2] * t.c;
    const double d = (q - p).norm();
    if (d < best.distance) best = {bvh.order()[i], q, w, d};
  }
}

}  // namespace

TriangleBvh::TriangleBvh(const TriangleMesh& mesh) {
  const auto n = static_cast<std::int32_t>(mesh.triangles.size());
  if (n == 0) throw InputError("mesh", "0 triangles", "give a tessellated surface.");
  std::vector<Vec3> middle(n);
  for (std::int32_t i = 0; i < n; ++i) {
    Box box;
    for (const std::int32_t v : mesh.triangles[i]) box.include(mesh.vertices[v]);
    middle[i] = 0.5 * (box.lo + box.hi);
  }
  order_.resize(n);
  std::iota(order_.begin(), order_.end(), 0);
  nodes_.reserve(n);
  nodes_.push_back({Vec3::Zero(), Vec3::Zero(), 0, n});
  std::vector<std::int32_t> todo{0};
  while (!todo.empty()) {
    stop_point();
    const std::int32_t node = todo.back();
    todo.pop_back();
    const std::int32_t left = split(node, middle, mesh);
    if (left > 0) todo.insert(todo.end(), {left + 1, left});
  }
  for (const std::int32_t i : order_) {
    const auto& t = mesh.triangles[i];
    triangles_.push_back({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
  }
  drops_ = DropTree(triangles_);
}

// Halves a leaf at the median of the longest side of its middles; returns the left child, or 0.
std::int32_t TriangleBvh::split(std::int32_t at, const std::vector<Vec3>& middle,
                                const TriangleMesh& mesh) {
  const std::int32_t first = nodes_[at].first, count = nodes_[at].count;
  Box box, middles;
  for (std::int32_t i = first; i < first + count; ++i) {
    for (const std::int32_t v : mesh.triangles[order_[i]]) box.include(mesh.vertices[v]);
    middles.include(middle[order_[i]]);
  }
  nodes_[at].lo = box.lo;
  nodes_[at].hi = box.hi;
  if (count <= kLeaf) return 0;
  int axis = 0;
  middles.size().maxCoeff(&axis);
  const auto less = [&](std::int32_t a, std::int32_t b) {
    return middle[a][axis] != middle[b][axis] ? middle[a][axis] < middle[b][axis] : a < b;
  };
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count, less);
  const auto left = static_cast<std::int32_t>(nodes_.size());
  nodes_.push_back({Vec3::Zero(), Vec3::Zero(), first, count / 2});
  nodes_.push_back({Vec3::Zero(), Vec3::Zero(), first + count / 2, count - count / 2});
  nodes_[at].first = left;
  nodes_[at].count = 0;
  return left;
}

Vec3 closest_on(const Triangle& t, const Vec3& p) {
  const Vec3 w = closest_weights(t, p);
  return w[0] * t.a + w[1] * t.b + w[2] * t.c;
}

ClosestPoint closest_point(const TriangleBvh& bvh, const Vec3& p, double reach) {
  ClosestPoint best;
  stop_point();
  best.distance = reach;
  struct Visit {
    std::int32_t node;
    double d2;
  };
  Visit stack[64];
  int top = 0;
  stack[top++] = {0, box_distance_squared(bvh.nodes()[0], p)};
  while (top > 0) {
    const Visit visit = stack[--top];
    if (visit.d2 >= best.distance * best.distance) continue;
    const BvhNode& node = bvh.nodes()[visit.node];
    if (node.count > 0) {
      visit_leaf(bvh, node, p, best);
      continue;
    }
    const double l = box_distance_squared(bvh.nodes()[node.first], p);
    const double r = box_distance_squared(bvh.nodes()[node.first + 1], p);
    const bool left_first = l <= r;
    stack[top++] = {node.first + (left_first ? 1 : 0), left_first ? r : l};
    stack[top++] = {node.first + (left_first ? 0 : 1), left_first ? l : r};
  }
  return best;
}

bool is_over(const TriangleBvh& bvh, const Vec3& p, double reach, double least) {
  std::int32_t stack[64];
  int top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const BvhNode& node = bvh.nodes()[stack[--top]];
    if (box_distance_squared(node, p) > reach * reach) continue;
    if (node.count == 0) {
      stack[top++] = node.first;
      stack[top++] = node.first + 1;
      continue;
    }
    for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
      const Triangle& t = bvh.triangles()[i];
      const Vec3 w = closest_weights(t, p);
      const Vec3 way = p - (w[0] * t.a + w[1] * t.b + w[2] * t.c);
      const Vec3 normal = (t.b - t.a).cross(t.c - t.a);
      if (way.norm() <= reach && std::abs(normal.dot(way)) >= least * normal.norm() * way.norm())
        return true;
    }
  }
  return false;
}

std::vector<double> line_crossings(const TriangleBvh& bvh, double y, double z) {
  std::vector<double> found;
  std::int32_t stack[64];
  int top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const BvhNode& node = bvh.nodes()[stack[--top]];
    if (y < node.lo.y() || y > node.hi.y() || z < node.lo.z() || z > node.hi.z()) continue;
    if (node.count == 0) {
      stack[top++] = node.first;
      stack[top++] = node.first + 1;
      continue;
    }
    double x = 0.0;
    for (std::int32_t i = node.first; i < node.first + node.count; ++i)
      if (line_crosses(bvh.triangles()[i], y, z, x)) found.push_back(x);
  }
  std::sort(found.begin(), found.end());
  return found;
}

bool inside(const TriangleBvh& bvh, const Vec3& p) {
  const std::vector<double> x = line_crossings(bvh, p.y(), p.z());
  return (x.end() - std::upper_bound(x.begin(), x.end(), p.x())) % 2 != 0;
}

}  // namespace patchmill::mesh

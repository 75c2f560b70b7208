// Making of the tree; see drop_tree.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/mesh/drop_tree.h"

#include "patchmill/geometry/stop.h"
#include "patchmill/mesh/float_rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace patchmill::mesh {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Mean slope of the triangles, each weighed by its area; of one triangle alone also if it faces down.
Vec2 mean_slope(const Triangle* first, std::size_t count) {
  Vec3 up = Vec3::Zero();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 n = (first[i].b - first[i].a).cross(first[i].c - first[i].a);
    if (n.z() > 0.0) up += n;
    if (n.z() < 0.0 && count == 1) up = -n;
  }
  return up.z() > 0.05 * up.norm() ? Vec2(-up.head<2>() / up.z()) : Vec2::Zero();
}

}  // namespace

DropLeaf empty_drop_leaf() {
  const float inf = std::numeric_limits<float>::infinity();
  DropLeaf leaf{};
  for (int i = 0; i < kDropWidth; ++i) {
    leaf.node.lo_x[i] = leaf.node.lo_y[i] = inf;
    leaf.node.hi_x[i] = leaf.node.hi_y[i] = leaf.node.top[i] = -inf;
    leaf.node.stretch[i] = 1.0f;
  }
  return leaf;
}

void copy_triangle(const DropLeaf& from, int lane, DropLeaf& to, int to_lane) {
  for (DropNode::Row DropNode::*row :
       {&DropNode::lo_x, &DropNode::hi_x, &DropNode::lo_y, &DropNode::hi_y, &DropNode::top,
        &DropNode::slope_x, &DropNode::slope_y, &DropNode::height, &DropNode::stretch})
    (to.node.*row)[to_lane] = (from.node.*row)[lane];
  for (int k = 0; k < 3; ++k) {
    to.side_x[k][to_lane] = from.side_x[k][lane];
    to.side_y[k][to_lane] = from.side_y[k][lane];
    to.side_c[k][to_lane] = from.side_c[k][lane];
  }
  to.node.child[to_lane] = from.node.child[lane];
}

// A run of the list of triangles.
struct DropTree::Span {
  const Triangle* triangle;
  std::size_t start, count;

  std::vector<Span> halved(int times) const {
    std::vector<Span> parts{*this};
    for (; times > 0; --times) {
      std::vector<Span> halves;
      for (const Span& s : parts) {
        const std::size_t half = s.count / 2;
        halves.push_back({s.triangle, s.start, half});
        halves.push_back({s.triangle + half, s.start + half, s.count - half});
      }
      parts = std::move(halves);
    }
    return parts;
  }
};

DropTree::DropTree(const std::vector<Triangle>& triangles) {
  Vec3 lo = Vec3::Constant(kInfinity), hi = -lo;
  for (const Triangle& t : triangles) {
    lo = lo.cwiseMin(t.a).cwiseMin(t.b).cwiseMin(t.c);
    hi = hi.cwiseMax(t.a).cwiseMax(t.b).cwiseMax(t.c);
  }
  middle_ = 0.5 * (lo + hi);
  extent_ = 0.5 * (hi - lo).maxCoeff();
  int halvings = 0;  // until no more than eight triangles are left
  while ((std::size_t{kDropWidth} << halvings) < triangles.size()) ++halvings;
  add_node(halvings, {triangles.data(), 0, triangles.size()});
}

// A span that becomes leaves by so many halvings. The root takes what three halvings a level leave over, so
// that the nodes below it are full.
std::int32_t DropTree::add_node(int halvings, const Span& span) {
  stop_point();
  const auto at = static_cast<std::int32_t>(nodes_.size());
  nodes_.push_back(empty_drop_leaf().node);
  const int now = halvings == 0 ? 0 : (halvings - 1) % 3 + 1;
  int lane = 0;
  for (const Span& part : span.halved(now)) {
    bound(nodes_[at], lane, part);
    const std::int32_t child = halvings == now ? ~add_leaf(part) : add_node(halvings - now, part);
    nodes_[at].child[lane++] = child;
  }
  return at;
}

std::int32_t DropTree::add_leaf(const Span& span) {
  DropLeaf leaf = empty_drop_leaf();
  for (int lane = 0; lane < static_cast<int>(span.count); ++lane) {
    const std::size_t one = static_cast<std::size_t>(lane);
    bound(leaf.node, lane, {span.triangle + one, span.start + one, 1});
    bound_sides(leaf, lane, span.triangle[one]);
    leaf.node.child[lane] = static_cast<std::int32_t>(span.start + one);
  }
  leaves_.push_back(leaf);
  return static_cast<std::int32_t>(leaves_.size()) - 1;
}

void DropTree::bound(DropNode& node, int lane, const Span& span) const {
  Vec3 lo = Vec3::Constant(kInfinity), hi = -lo;
  const Vec2 slope = mean_slope(span.triangle, span.count).cast<float>().cast<double>();
  double height = -kInfinity;
  for (std::size_t i = 0; i < span.count; ++i)
    for (const Vec3* corner : {&span.triangle[i].a, &span.triangle[i].b, &span.triangle[i].c}) {
      const Vec3 p = *corner - middle_;
      lo = lo.cwiseMin(p);
      hi = hi.cwiseMax(p);
      height = std::max(height, p.z() - slope.dot(p.head<2>()));
    }
  const double more = kFloatError * extent_;
  const double terms = 2.0 * extent_ * (1.0 + slope.lpNorm<1>()) + std::abs(height);
  node.lo_x[lane] = below(lo.x() - more);
  node.hi_x[lane] = above(hi.x() + more);
  node.lo_y[lane] = below(lo.y() - more);
  node.hi_y[lane] = above(hi.y() + more);
  node.top[lane] = above(hi.z() + more);
  node.slope_x[lane] = static_cast<float>(slope.x());
  node.slope_y[lane] = static_cast<float>(slope.y());
  node.height[lane] = above(height + kFloatError * terms);
  node.stretch[lane] = above(std::sqrt(1.0 + slope.squaredNorm()));
}

// Along a plane with the unit normal N the length of a step in the plan by n across a side is 1 / sqrt(1 - (n . N)^2)
// for each unit of n; so much longer is the n that is kept. A side of no length in the plan has no line, and none is
// needed: it holds nothing back.
void DropTree::bound_sides(DropLeaf& leaf, int lane, const Triangle& t) const {
  const Vec2 corner[3] = {(t.a - middle_).head<2>(), (t.b - middle_).head<2>(),
                          (t.c - middle_).head<2>()};
  const Vec2 slope(leaf.node.slope_x[lane], leaf.node.slope_y[lane]);
  const Vec2 normal = -slope / std::sqrt(1.0 + slope.squaredNorm());
  for (int k = 0; k < 3; ++k) {
    const Vec2 &p = corner[k], &q = corner[(k + 1) % 3], &across = corner[(k + 2) % 3];
    const double length = (q - p).norm();
    if (length == 0.0) continue;
    Vec2 n = Vec2(q.y() - p.y(), p.x() - q.x()) / length;
    if (n.dot(across - p) > 0.0) n = -n;
    n /= std::sqrt(1.0 - n.dot(normal) * n.dot(normal));
    const Vec2 m = n.cast<float>().cast<double>();
    const double furthest = std::max({m.dot(p), m.dot(q), m.dot(across)});
    leaf.side_x[k][lane] = static_cast<float>(m.x());
    leaf.side_y[k][lane] = static_cast<float>(m.y());
    leaf.side_c[k][lane] = below(-furthest - 4.0 * kFloatError * extent_ * m.norm());
  }
}

}  // namespace patchmill::mesh

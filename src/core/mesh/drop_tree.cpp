// Bounds for a dropped ball; see drop_tree.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/mesh/drop_tree.h"

#include "core/geometry/vector_clones.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace patchmill {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFloatError = 1.0 / (1 << 20);  // of a sum of a few floats, relative to its terms

float above(double v) {
  return std::nextafter(static_cast<float>(v), std::numeric_limits<float>::infinity());
}

float below(double v) {
  return std::nextafter(static_cast<float>(v), -std::numeric_limits<float>::infinity());
}

void clear(DropNode& node) {
  const float inf = std::numeric_limits<float>::infinity();
  for (int i = 0; i < kDropWidth; ++i) {
    node.lo_x[i] = node.lo_y[i] = inf;
    node.hi_x[i] = node.hi_y[i] = node.top[i] = -inf;
    node.slope_x[i] = node.slope_y[i] = node.height[i] = 0.0f;
    node.stretch[i] = 1.0f;
    node.child[i] = 0;
  }
}

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
  std::vector<Span> singles() const {
    std::vector<Span> parts;
    for (std::size_t i = 0; i < count; ++i) parts.push_back({triangle + i, start + i, 1});
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
  nodes_.emplace_back();
  add(0, halvings, {triangles.data(), 0, triangles.size()});
}

// Fills node `at`, whose span becomes spans of single triangles' nodes by so many halvings. The root takes
// what three halvings a level leave over, so that the nodes below it are full.
void DropTree::add(std::size_t at, int halvings, const Span& span) {
  clear(nodes_[at]);
  const int now = halvings == 0 ? 0 : (halvings - 1) % 3 + 1;
  const std::vector<Span> parts = halvings == 0 ? span.singles() : span.halved(now);
  for (std::size_t lane = 0; lane < parts.size(); ++lane) {
    bound(nodes_[at], lane, parts[lane]);
    if (halvings == 0) {
      nodes_[at].child[lane] = ~static_cast<std::int32_t>(parts[lane].start);
      continue;
    }
    const std::size_t next = nodes_.size();
    nodes_[at].child[lane] = static_cast<std::int32_t>(next);
    nodes_.emplace_back();
    add(next, halvings - now, parts[lane]);
  }
}

void DropTree::bound(DropNode& node, std::size_t lane, const Span& span) const {
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

DropBall drop_ball_over(const DropTree& tree, double x, double y, double radius) {
  const double cx = x - tree.middle().x(), cy = y - tree.middle().y();
  const double more = kFloatError * radius, larger = radius * (1.0 + 4.0 * kFloatError);
  return {below(cx - more),           above(cx + more),
          below(cy - more),           above(cy + more),
          static_cast<float>(radius), above(larger),
          above(larger * larger),     below((0.5 - kFloatError) / radius)};
}

PATCHMILL_VECTOR_CLONES
void drop_bounds(const DropNode& node, const DropBall& of, float best, DropNode::Row& bound) {
  const DropBall ball = of;
  const float none = -std::numeric_limits<float>::infinity();
  DropNode::Row found;
  for (int i = 0; i < kDropWidth; ++i) {
    const float dx =
        std::max(std::max(node.lo_x[i] - ball.high_x, ball.low_x - node.hi_x[i]), 0.0f);
    const float dy =
        std::max(std::max(node.lo_y[i] - ball.high_y, ball.low_y - node.hi_y[i]), 0.0f);
    const float d2 = dx * dx + dy * dy;
    const float share = ball.ahead / node.stretch[i];
    const float qx = share * node.slope_x[i], qy = share * node.slope_y[i];
    const float ex = std::max(
        std::max(node.lo_x[i] - (ball.high_x + qx), (ball.low_x + qx) - node.hi_x[i]), 0.0f);
    const float ey = std::max(
        std::max(node.lo_y[i] - (ball.high_y + qy), (ball.low_y + qy) - node.hi_y[i]), 0.0f);
    const float on_lid = (node.slope_x[i] * ball.low_x + node.slope_y[i] * ball.low_y) +
                         node.height[i] + ball.radius * node.stretch[i] -
                         (ex * ex + ey * ey) * ball.half_curve;
    // sqrt(R^2 - d^2) <= R - d^2 / 2R; and against `best` the root itself, squared
    const float on_box = node.top[i] + ball.radius - d2 * ball.half_curve;
    const float gap = std::max(best - node.top[i], 0.0f);
    const float most = std::min(on_box, on_lid);
    const bool cannot = gap * gap + d2 >= ball.radius2 || !(most > best);
    found[i] = cannot ? none : most;
  }
  std::copy_n(found, kDropWidth, bound);
}

}  // namespace patchmill

// Zones of a moving probe; see drop_probe.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/copy/drop_probe.h"

#include "patchmill/copy/drop_search.h"
#include "patchmill/geometry/stop.h"

#include <algorithm>
#include <cmath>

namespace patchmill::copy {
namespace {

constexpr double kSteepest = 20.0;            // of a floor; a steeper contact has no zone
constexpr std::size_t kFew = 12, kMany = 24;  // triangles for which zones get longer, or shorter
constexpr std::size_t kMost = 64;             // a zone of more is given up
constexpr double kLeastBend = 1e-4, kMostBend = 4.0;  // in 1 / R
constexpr double kSteps = 32.0;                       // half of the longest zone
constexpr double kAhead = 0.9;                        // of a half is where the zone's middle lies

}  // namespace

DropProbe::DropProbe(const mesh::TriangleBvh& bvh, double radius)
    : bvh_(&bvh), radius_(radius), bend_(1.0 / radius) {
  const mesh::BvhNode& all = bvh.nodes()[0];
  const double size = (all.hi - all.lo).head<2>().maxCoeff();
  length_ = size * std::sqrt(8.0 / double(bvh.triangles().size()));
}

double DropProbe::operator()(double x, double y) {
  stop_point();
  const Vec2 p(x, y);
  follow(p);
  double guess = kNoContact;
  if (in_zone(p)) {
    const double plane = zone_.height + zone_.slope.dot(p - zone_.at);
    guess = highest_in_zone(p, plane - zone_.margin);
    zone_.sag = std::max(zone_.sag, plane - guess);
    if (guess > plane - zone_.margin) return guess;
  } else if (triangle_ >= 0) {
    guess = drop_ball_on(bvh_->triangles()[triangle_], x, y, radius_);
  }
  // a zone with its floor under the guess holds the height itself
  if (make_zone(p, guess)) return highest_in_zone(p, zone_.height - zone_.margin);
  DropSearch search(*bvh_, x, y, radius_);
  if (triangle_ >= 0) search.touch(triangle_);
  search.look_at_all();
  if (search.triangle() >= 0) triangle_ = search.triangle();
  return search.height();
}

void DropProbe::follow(const Vec2& p) {
  if (begun_) {
    const Vec2 step = p - last_;
    drift_ = 0.75 * drift_ + 0.25 * step;
    spread_ = 0.75 * spread_ + 0.25 * step.cwiseAbs();
  }
  begun_ = true;
  last_ = p;
}

bool DropProbe::in_zone(const Vec2& p) const {
  return p.x() >= zone_.lo.x() && p.x() <= zone_.hi.x() && p.y() >= zone_.lo.y() &&
         p.y() <= zone_.hi.y();
}

// Among the triangles of the zone; what is not above the floor may be missed.
double DropProbe::highest_in_zone(const Vec2& p, double floor) {
  DropSearch search(*bvh_, p.x(), p.y(), radius_, floor);
  search.touch(triangle_);
  for (const mesh::DropLeaf& leaf : zone_.leaves) search.look_at(leaf);
  if (search.triangle() >= 0) triangle_ = search.triangle();
  return search.height();
}

// From how far the heights in the zone fell below its plane.
void DropProbe::learn_bend() {
  if (zone_.reach == 0.0) return;
  const double needed = 2.0 * zone_.sag / (zone_.reach * zone_.reach);
  bend_ = std::max(1.3 * needed, 0.8 * bend_);
  bend_ = std::min(std::max(bend_, kLeastBend / radius_), kMostBend / radius_);
}

// Around p and, more so, ahead of it; `height` is the ball's over p, or lower.
bool DropProbe::make_zone(const Vec2& p, double height) {
  learn_bend();
  const double step = spread_.maxCoeff();
  zone_.reach = 0.0;
  zone_.lo = Vec2::Ones();
  zone_.hi = Vec2::Zero();
  if (height == kNoContact || step == 0.0 || length_ < step) return false;
  const Vec3 centre(p.x(), p.y(), height);
  const Vec3 up = centre - mesh::closest_on(bvh_->triangles()[triangle_], centre);
  if (up.z() * kSteepest < radius_) return false;
  const double steps = std::min(length_ / step, kSteps);
  const Vec2 half = steps * spread_, middle = p + kAhead * steps * drift_;
  zone_.at = p;
  zone_.height = height;
  zone_.slope = -up.head<2>() / up.z();
  zone_.sag = 0.0;
  const double reach = ((middle - p).cwiseAbs() + half).norm();
  zone_.margin = 0.5 * bend_ * reach * reach;
  const double floor = height + zone_.slope.dot(middle - p) - zone_.margin;
  const std::size_t count = gather(mesh::drop_floor_over(
      bvh_->drops(), middle - half, middle + half, zone_.slope, floor, radius_));
  if (count > kMany) length_ *= 0.7;
  if (count < kFew && length_ < kSteps * step) length_ *= 1.4;
  if (count > kMost) return false;
  zone_.lo = middle - half;
  zone_.hi = middle + half;
  zone_.reach = reach;
  return true;
}

// The triangles that can lift the ball above the floor; their number.
std::size_t DropProbe::gather(const mesh::DropFloor& floor) {
  const mesh::DropTree& tree = bvh_->drops();
  zone_.leaves.clear();
  std::size_t count = 0;
  const auto keep = [&](const mesh::DropLeaf& leaf) {
    for (unsigned bits = mesh::drop_above(leaf, floor); bits != 0; bits &= bits - 1) {
      const int lane = static_cast<int>(count++ % mesh::kDropWidth);
      if (lane == 0) zone_.leaves.push_back(mesh::empty_drop_leaf());
      mesh::copy_triangle(leaf, __builtin_ctz(bits), zone_.leaves.back(), lane);
    }
  };
  std::int32_t stack[16 * mesh::kDropWidth];  // a tree of 2^31 triangles is ten nodes deep
  int top = 0;
  for (stack[top++] = 0; top > 0 && count <= kMost;) {
    const std::int32_t at = stack[--top];
    if (at < 0) {
      keep(tree.leaves()[~at]);
      continue;
    }
    const mesh::DropNode& node = tree.nodes()[at];
    for (unsigned bits = mesh::drop_above(node, floor); bits != 0; bits &= bits - 1)
      stack[top++] = node.child[__builtin_ctz(bits)];
  }
  return count;
}

}  // namespace patchmill::copy

// Bounds for a dropped ball; see drop_bounds.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/mesh/drop_bounds.h"

#include "patchmill/geometry/vector_clones.h"
#include "patchmill/mesh/float_rounding.h"

#include <algorithm>
#include <cmath>

namespace patchmill::mesh {
namespace {

// With its place anywhere from `lo` to `hi`, from the middle of the tree.
DropBall ball_between(const Vec2& lo, const Vec2& hi, double radius) {
  const double more = kFloatError * radius, wider = radius * (1.0 + 4.0 * kFloatError);
  return {below(lo.x() - more),       above(hi.x() + more),
          below(lo.y() - more),       above(hi.y() + more),
          static_cast<float>(radius), above(wider),
          above(wider * wider),       below((0.5 - kFloatError) / radius),
          above(4.0 * more)};
}

// By value: the compiler makes vectors of them.
inline float larger(float a, float b) {
  return a < b ? b : a;
}
inline float smaller(float a, float b) {
  return b < a ? b : a;
}

// From an interval to an interval; 0 where they meet.
inline float gap(float lo, float hi, float low, float high) {
  return larger(larger(lo - high, low - hi), 0.0f);
}

// Squared distance in the plan from the ball's axis to the box of child i.
inline float to_box(const DropNode& node, const DropBall& ball, int i) {
  const float dx = gap(node.lo_x[i], node.hi_x[i], ball.low_x, ball.high_x);
  const float dy = gap(node.lo_y[i], node.hi_y[i], ball.low_y, ball.high_y);
  return dx * dx + dy * dy;
}

// From the ball's axis to the place where it would touch the upper bounding plane of child i.
struct Ahead {
  float x, y;
};
inline Ahead ahead(const DropNode& node, const DropBall& ball, int i) {
  const float share = ball.ahead / node.stretch[i];
  return {share * node.slope_x[i], share * node.slope_y[i]};
}

// Squared distance in the plan from that place to the box.
inline float from_lid(const DropNode& node, const DropBall& ball, const Ahead& q, int i) {
  const float ex = gap(node.lo_x[i], node.hi_x[i], ball.low_x + q.x, ball.high_x + q.x);
  const float ey = gap(node.lo_y[i], node.hi_y[i], ball.low_y + q.y, ball.high_y + q.y);
  return ex * ex + ey * ey;
}

// The same to the sides of triangle i, with the ball's axis at (x, y) or less than half a box from there.
inline float from_sides(const DropLeaf& leaf, const DropBall& ball, const Ahead& q, float x,
                        float y, float half_x, float half_y, int i) {
  float most = 0.0f;
  for (int k = 0; k < 3; ++k) {
    const float nx = leaf.side_x[k][i], ny = leaf.side_y[k][i];
    const float side = (nx * (x + q.x) + ny * (y + q.y)) + leaf.side_c[k][i] -
                       (std::abs(nx) * half_x + std::abs(ny) * half_y);
    most = larger(most, side - ball.slack);
  }
  return most * most;
}

// What the ball's centre falls by, at least, for a contact that is a length away from where the upper bounding plane
// would hold it: squared in the plan, and on that plane itself if that is known, else in the plan again.
inline float fall(const DropNode& node, const DropBall& ball, float in_plan, float on_lid, int i) {
  const float curve = ball.half_curve * node.stretch[i], tilt = 1.0f + std::sqrt(on_lid) * curve;
  return larger(in_plan * ball.half_curve, on_lid * curve / (tilt * tilt));
}

// Bit i where value i is above the limit.
inline unsigned bits_above(const DropNode::Row& value, float limit) {
  unsigned bits = 0;
  for (int i = 0; i < kDropWidth; ++i) bits |= value[i] > limit ? 1u << i : 0u;
  return bits;
}

// What bounds child i for a ball over a place or a box of places. `from_sides` tells the squared distance on the plane
// from its place to a single triangle, or 0.
struct Limits {
  float d2,
      down;  // squared distance to the box; what the ball falls by from where the upper bounding plane would hold it
  float on_box;  // how high the box can hold it; sqrt(R^2 - d^2) <= R - d^2 / 2R
};
template <typename FromSides>
inline Limits limits(const DropNode& node, const DropBall& ball, const FromSides& from_sides,
                     int i) {
  const float d2 = to_box(node, ball, i);
  const Ahead q = ahead(node, ball, i);
  const float e2 = from_lid(node, ball, q, i);
  return {d2, fall(node, ball, e2, larger(e2, from_sides(q, i)), i),
          node.top[i] + ball.radius - d2 * ball.half_curve};
}

// Whether the box of child i, which is d away, holds the ball no higher than `height`: the root itself, squared.
inline bool too_low(const DropNode& node, const DropBall& ball, float d2, float height, int i) {
  const float over = larger(height - node.top[i], 0.0f);
  return over * over + d2 >= ball.radius2;
}

template <typename FromSides>
inline unsigned bounds(const DropNode& node, const DropBall& ball, float best, DropNode::Row& bound,
                       const FromSides& from_sides) {
  DropNode::Row found;
  for (int i = 0; i < kDropWidth; ++i) {
    const Limits limit = limits(node, ball, from_sides, i);
    const float on_lid = (node.slope_x[i] * ball.low_x + node.slope_y[i] * ball.low_y) +
                         node.height[i] + ball.radius * node.stretch[i] - limit.down;
    const float most = smaller(limit.on_box, on_lid);
    const bool cannot = too_low(node, ball, limit.d2, best, i);
    found[i] = cannot ? best : most;
  }
  std::copy_n(found, kDropWidth, bound);
  return bits_above(found, best);
}

// Over the box an upper bounding plane lies above the floor by no more than in the middle and, for each half side,
// the difference of slopes; and the floor is no lower than in the middle less its own slope.
template <typename FromSides>
inline unsigned above_floor(const DropNode& node, const DropFloor& floor,
                            const FromSides& from_sides) {
  const DropBall& ball = floor.ball;
  const float lowest = floor.height - std::abs(floor.slope_x) * floor.half_x -
                       std::abs(floor.slope_y) * floor.half_y;
  DropNode::Row height;
  for (int i = 0; i < kDropWidth; ++i) {
    const Limits limit = limits(node, ball, from_sides, i);
    const float on_lid = (node.slope_x[i] * floor.middle_x + node.slope_y[i] * floor.middle_y) +
                         node.height[i] + std::abs(node.slope_x[i] - floor.slope_x) * floor.half_x +
                         std::abs(node.slope_y[i] - floor.slope_y) * floor.half_y +
                         ball.radius * node.stretch[i] - limit.down;
    const float most = smaller(on_lid - floor.height, limit.on_box - lowest);
    const bool cannot = too_low(node, ball, limit.d2, lowest, i);
    height[i] = cannot ? 0.0f : most;
  }
  return bits_above(height, 0.0f);
}

}  // namespace

float drop_floor(const DropTree& tree, double z) {
  return below(z - tree.middle().z());
}

DropBall drop_ball_over(const DropTree& tree, double x, double y, double radius) {
  const Vec2 c = Vec2(x, y) - tree.middle().head<2>();
  return ball_between(c, c, radius);
}

DropFloor drop_floor_over(const DropTree& tree, const Vec2& lo, const Vec2& hi, const Vec2& slope,
                          double height, double radius) {
  const Vec2 from = lo - tree.middle().head<2>(), to = hi - tree.middle().head<2>();
  const Vec2 middle = 0.5 * (from + to), half = 0.5 * (to - from);
  const double more = kFloatError * (tree.extent() + radius) * (1.0 + slope.lpNorm<1>());
  return {ball_between(from, to, radius), static_cast<float>(middle.x()),
          static_cast<float>(middle.y()), above(half.x() + more),
          above(half.y() + more),         static_cast<float>(slope.x()),
          static_cast<float>(slope.y()),  below(height - tree.middle().z() - more)};
}

PATCHMILL_VECTOR_CLONES
unsigned drop_bounds(const DropNode& node, const DropBall& of, float best, DropNode::Row& bound) {
  const DropBall ball = of;
  return bounds(node, ball, best, bound, [](const Ahead&, int) { return 0.0f; });
}

PATCHMILL_VECTOR_CLONES
unsigned drop_bounds(const DropLeaf& leaf, const DropBall& of, float best, DropNode::Row& bound) {
  const DropBall ball = of;
  return bounds(leaf.node, ball, best, bound, [&](const Ahead& q, int i) {
    return from_sides(leaf, ball, q, ball.low_x, ball.low_y, 0.0f, 0.0f, i);
  });
}

PATCHMILL_VECTOR_CLONES
unsigned drop_above(const DropNode& node, const DropFloor& over) {
  const DropFloor floor = over;
  return above_floor(node, floor, [](const Ahead&, int) { return 0.0f; });
}

PATCHMILL_VECTOR_CLONES
unsigned drop_above(const DropLeaf& leaf, const DropFloor& over) {
  const DropFloor floor = over;
  return above_floor(leaf.node, floor, [&](const Ahead& q, int i) {
    return from_sides(leaf, floor.ball, q, floor.middle_x, floor.middle_y, floor.half_x,
                      floor.half_y, i);
  });
}

}  // namespace patchmill::mesh

// Newton's method for a chunk of cells at a time; see flute_kernel.h. Written in the vector types
// that GCC and Clang share, and compiled once per instruction set: by flute_lanes_*.cpp, which say
// how many lanes a register has (PATCHMILL_LANES) and give the namespace (PATCHMILL_ISA).
// Contraction to fused multiply-add is off (-ffp-contract=off) and a lane's operations do not
// depend on the number of lanes, so all of them give the same bits.
// No include guard: one inclusion per translation unit.
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "patchmill/marks/flute_kernel.h"

#define PATCHMILL_INLINE inline __attribute__((always_inline))

namespace patchmill::marks::PATCHMILL_ISA {
namespace {

constexpr int kWidth = PATCHMILL_LANES;
static_assert(kLanes % kWidth == 0);

using Lanes = float __attribute__((vector_size(4 * kWidth), aligned(4)));
using Mask = int __attribute__((vector_size(4 * kWidth)));

struct Lanes3 {
  Lanes x, y, z;
};

constexpr int kSurelyNewton = 2;      // steps that every chunk takes
constexpr float kNearAxis = 1.2f;     // above 1: a margin for what is curved
constexpr float kFarSide = 0.4f;      // the azimuth runs against the spindle: Newton may miss it
constexpr float kTipDisc = 0.015f;    // the way of the point is a little curved
constexpr float kTimeSlack = 0.25f;   // [rad] about the time at which the ball reaches a cell
constexpr float kWindowSlack = 0.8f;  // [rad] about the time at which the azimuth may be as fast
constexpr float kTipWidth = 1e-4f;    // [mm]; so near to the tip all azimuths are one
constexpr int kMostCrossings = 3;
constexpr int kSecants = 7;
constexpr int kGroup = 4;                // registers that take turns
constexpr int kMostNewton = 10;          // steps for a chunk that has not converged by then
constexpr float kStepConverged = 1e-3f;  // [rad]; the error after such a step is of its square
constexpr float kLongestStep = 0.5f;     // [rad]

PATCHMILL_INLINE Lanes all(float v) {
  return Lanes{} + v;
}
PATCHMILL_INLINE Lanes smaller(const Lanes& a, const Lanes& b) {
  return a < b ? a : b;
}
PATCHMILL_INLINE Lanes larger(const Lanes& a, const Lanes& b) {
  return a > b ? a : b;
}
PATCHMILL_INLINE Lanes clamped(const Lanes& v, float low, float high) {
  return smaller(larger(v, all(low)), all(high));
}

PATCHMILL_INLINE void root(Lanes& v) {
  for (int i = 0; i < kWidth; ++i) v[i] = __builtin_sqrtf(v[i]);
}

PATCHMILL_INLINE bool any(const Mask& m) {
  long long parts[sizeof m / sizeof(long long)], bits = 0;
  __builtin_memcpy(parts, &m, sizeof m);
  for (const long long part : parts) bits |= part;
  return bits != 0;
}

PATCHMILL_INLINE Lanes dot(const Lanes3& d, const Lanes3& v) {
  return d.x * v.x + d.y * v.y + d.z * v.z;
}

/// Angle of (x, y) for x > 0; 0 .. pi/2 by magnitude. Odd polynomial, minimax on 0..1 to 2.5e-7
/// rad.
PATCHMILL_INLINE Lanes angle_of(const Lanes& x, const Lanes& y) {
  const Lanes ay = larger(y, -y);
  const Mask steep = ay > x;
  const Lanes u = smaller(ay, x) / larger(larger(ay, x), all(1e-30f));
  const Lanes z = u * u;
  Lanes p = all(6.811781786e-3f);
  p = p * z - 3.3604186028e-2f;
  p = p * z + 7.9623632133e-2f;
  p = p * z - 1.32333397865e-1f;
  p = p * z + 1.98078155518e-1f;
  p = p * z - 3.33173692226e-1f;
  p = p * z + 9.99996125698e-1f;
  p = p * u;
  p = steep ? 1.57079632679f - p : p;
  return y < 0.0f ? -p : p;
}

/// Motion of the tool at each lane's delta.
struct ToolState {
  Lanes3 shift, velocity;  // of the ball centre since the middle of the pass
  Lanes3 a, b, t;          // housing directions
  Lanes3 a_rate, b_rate, t_rate;
};

PATCHMILL_INLINE void set(const float v[3], Lanes3& out) {
  out = {all(v[0]), all(v[1]), all(v[2])};
}
PATCHMILL_INLINE void add(const Lanes& k, const float v[3], Lanes3& out) {
  out.x += k * v[0];
  out.y += k * v[1];
  out.z += k * v[2];
}

template <bool kTurning>
PATCHMILL_INLINE void move_tool(const PassFrame& pass, const Lanes& delta, ToolState& tool) {
  set(pass.velocity, tool.velocity);
  tool.shift = {delta * pass.velocity[0], delta * pass.velocity[1], delta * pass.velocity[2]};
  set(pass.a, tool.a);
  set(pass.b, tool.b);
  set(pass.t, tool.t);
  if (kTurning) {
    set(pass.a_rate, tool.a_rate);
    set(pass.b_rate, tool.b_rate);
    set(pass.t_rate, tool.t_rate);
    add(delta, pass.a_rate, tool.a);
    add(delta, pass.b_rate, tool.b);
    add(delta, pass.t_rate, tool.t);
  }
  for (const PassKink& kink : pass.kinks) {
    const Lanes past = delta - kink.at;
    const Mask beyond = kink.at > 0.0f ? past > 0.0f : past < 0.0f;
    const Lanes by = beyond ? past : all(0.0f), on = beyond ? all(1.0f) : all(0.0f);
    add(by, kink.velocity, tool.shift);
    add(on, kink.velocity, tool.velocity);
    if (kTurning) {
      add(by, kink.a, tool.a);
      add(by, kink.b, tool.b);
      add(by, kink.t, tool.t);
      add(on, kink.a, tool.a_rate);
      add(on, kink.b, tool.b_rate);
      add(on, kink.t, tool.t_rate);
    }
  }
}

/// The point of the ball that is under a cell: offset from the ball centre, its derivative by
/// delta, and its height over the base. `open` is R² less the squared distance of the line from the
/// centre.
struct BallPoint {
  Lanes3 offset, rate;
  Lanes height, height_rate, open;
};

/// Cells of a plane at (x, y).
struct FlatCells {
  Lanes x, y;
  float centre_height;

  PATCHMILL_INLINE void take(int lane, const FlatCells& from, int other) {
    x[lane] = from.x[other];
    y[lane] = from.y[other];
  }
  PATCHMILL_INLINE Lanes3 normal() const { return {all(0.0f), all(0.0f), all(1.0f)}; }
  PATCHMILL_INLINE Lanes guess(const PassFrame& pass) const {
    return pass.guess + x * pass.guess_gradient[0] + y * pass.guess_gradient[1];
  }
  PATCHMILL_INLINE void under(const PassFrame& pass, const ToolState& tool, BallPoint& ball) const {
    const Lanes qx = x - tool.shift.x, qy = y - tool.shift.y;
    ball.open = pass.radius * pass.radius - (qx * qx + qy * qy);
    Lanes h = larger(ball.open, all(1e-12f));
    root(h);
    const Lanes h_rate = (qx * tool.velocity.x + qy * tool.velocity.y) / h;
    ball.offset = {qx, qy, -h};
    ball.rate = {-tool.velocity.x, -tool.velocity.y, -h_rate};
    ball.height = centre_height + tool.shift.z - h;
    ball.height_rate = tool.velocity.z - h_rate;
  }
};

/// Cells of a curved surface: base points p with unit normals n.
struct CurvedCells {
  Lanes3 p, n;

  PATCHMILL_INLINE void take(int lane, const CurvedCells& from, int other) {
    p.x[lane] = from.p.x[other];
    p.y[lane] = from.p.y[other];
    p.z[lane] = from.p.z[other];
    n.x[lane] = from.n.x[other];
    n.y[lane] = from.n.y[other];
    n.z[lane] = from.n.z[other];
  }
  PATCHMILL_INLINE Lanes3 normal() const { return n; }
  PATCHMILL_INLINE Lanes guess(const PassFrame& pass) const {
    return pass.guess + p.x * pass.guess_gradient[0] + p.y * pass.guess_gradient[1] +
           p.z * pass.guess_gradient[2];
  }
  PATCHMILL_INLINE void under(const PassFrame& pass, const ToolState& tool, BallPoint& ball) const {
    const Lanes3 to_base = {p.x - tool.shift.x, p.y - tool.shift.y, p.z - tool.shift.z};
    const Lanes along = -dot(to_base, n), v_along = dot(tool.velocity, n);
    const Lanes3 q = {to_base.x + along * n.x, to_base.y + along * n.y, to_base.z + along * n.z};
    ball.open = pass.radius * pass.radius - dot(q, q);
    Lanes h = larger(ball.open, all(1e-12f));
    root(h);
    const Lanes h_rate = dot(q, tool.velocity) / h;
    ball.height = along - h;
    ball.height_rate = v_along - h_rate;
    ball.offset = {q.x - h * n.x, q.y - h * n.y, q.z - h * n.z};
    const Lanes& rate = ball.height_rate;
    ball.rate = {rate * n.x - tool.velocity.x, rate * n.y - tool.velocity.y,
                 rate * n.z - tool.velocity.z};
  }
};

}  // namespace
}  // namespace patchmill::marks::PATCHMILL_ISA

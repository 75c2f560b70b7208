// Newton's method for a chunk of cells at a time; see flute_kernel.h. Written in the vector types
// that GCC and Clang share, and compiled once per instruction set: by flute_lanes_*.cpp, which say
// how many lanes a register has (PATCHMILL_LANES) and give the namespace (PATCHMILL_ISA).
// Contraction to fused multiply-add is off (-ffp-contract=off) and a lane's operations do not
// depend on the number of lanes, so all of them give the same bits.
// No include guard: one inclusion per translation unit.
// SPDX-License-Identifier: LGPL-2.1-or-later

#include "core/marks/flute_kernel.h"

#define PATCHMILL_INLINE inline __attribute__((always_inline))

namespace patchmill::PATCHMILL_ISA {
namespace {

constexpr int kWidth = PATCHMILL_LANES;
static_assert(kLanes % kWidth == 0);

using Lanes = float __attribute__((vector_size(4 * kWidth), aligned(4)));
using Mask = int __attribute__((vector_size(4 * kWidth)));

struct Lanes3 {
  Lanes x, y, z;
};

constexpr int kSurelyNewton = 2;    // steps that every chunk takes
constexpr float kNearAxis = 1.2f;   // above 1: a margin for what is curved
constexpr float kFarSide = 0.4f;    // the azimuth runs against the spindle: Newton may miss it
constexpr float kTipDisc = 0.015f;  // the way of the point is a little curved
constexpr float kTipWidth = 1e-4f;  // [mm]; so near to the tip all azimuths are one
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

/// One Newton step of r(delta) = 0; returns its length.
template <bool kTurning, class Cells>
PATCHMILL_INLINE Lanes newton(const PassFrame& pass, const Cells& cells, Lanes& delta) {
  ToolState tool;
  BallPoint ball;
  move_tool<kTurning>(pass, delta, tool);
  cells.under(pass, tool, ball);
  const Lanes across = dot(ball.offset, tool.a), ahead = dot(ball.offset, tool.b);
  const Lanes up = dot(ball.offset, tool.t);
  Lanes across_rate = dot(ball.rate, tool.a), ahead_rate = dot(ball.rate, tool.b);
  Lanes up_rate = dot(ball.rate, tool.t);
  if (kTurning) {
    across_rate += dot(ball.offset, tool.a_rate);
    ahead_rate += dot(ball.offset, tool.b_rate);
    up_rate += dot(ball.offset, tool.t_rate);
  }
  const Lanes in_front = larger(across, all(1e-6f));
  const Lanes r = delta - angle_of(in_front, ahead) - pass.helix_rate * (up - pass.helix_height);
  const Lanes square = in_front * in_front + ahead * ahead;
  const Lanes slope =
      square * (1.0f - pass.helix_rate * up_rate) - (in_front * ahead_rate - ahead * across_rate);
  const Lanes least = 0.05f * square;
  const Lanes safe = slope < 0.0f ? smaller(slope, -least) : larger(slope, least);
  const Lanes step = clamped(r * square / safe, -kLongestStep, kLongestStep);
  delta = clamped(delta - step, pass.low - kLongestStep, pass.high + kLongestStep);
  return step;
}

/// Height of the edge over each cell at delta, and whether it cuts there. `reached`: the ball does
/// at least, with the edge not too far away.
template <bool kTurning, class Cells>
PATCHMILL_INLINE Mask cuts(const PassFrame& pass, const Cells& cells, const Lanes& delta,
                           const Lanes& before, const Lanes& step, Lanes& height, Mask& reached) {
  ToolState tool;
  BallPoint ball;
  move_tool<kTurning>(pass, delta, tool);
  cells.under(pass, tool, ball);
  height = ball.height;
  const Lanes across = dot(ball.offset, tool.a), up = dot(ball.offset, tool.t);
  const Lanes still = step * ball.height_rate;
  const Lanes slack = larger(still, -still) * 2.0f;
  reached = (ball.open > 0.0f) & (height - slack < before) & (across > 0.0f) & (up <= 0.0f);
  return reached & (height < before) & (delta >= pass.low) & (delta < pass.high);
}

PATCHMILL_INLINE Mask rough(const Lanes& step) {
  return (step > kStepConverged) | (step < -kStepConverged);
}

/// Lanes over which the edge may pass more than once: where, some time in the pass, the feed
/// carries the azimuth of the point of the ball on with the spindle and as fast. The point's way
/// (x, y) across the tool axis is taken as straight, so that x y' - y x' is constant and the
/// azimuth turns at that over x² + y². Only lanes that the ball may reach below `before`.
template <bool kTurning, class Cells>
PATCHMILL_INLINE Mask near_axis(const PassFrame& pass, const Cells& cells, const Lanes& before) {
  const float middle = 0.5f * (pass.low + pass.high), half = 0.5f * (pass.high - pass.low);
  ToolState tool;
  BallPoint ball;
  move_tool<kTurning>(pass, all(middle), tool);
  cells.under(pass, tool, ball);
  const Lanes across = dot(ball.offset, tool.a), ahead = dot(ball.offset, tool.b);
  const Lanes across_rate = dot(ball.rate, tool.a), ahead_rate = dot(ball.rate, tool.b);
  const Lanes rate = across_rate * across_rate + ahead_rate * ahead_rate + 1e-12f;
  const Lanes nearest = clamped(-(across * across_rate + ahead * ahead_rate) / rate, -half, half);
  const Lanes x = across + nearest * across_rate, y = ahead + nearest * ahead_rate;
  const Lanes fall = larger(ball.height_rate, -ball.height_rate) * half +
                     dot(tool.velocity, tool.velocity) * (half * half / pass.radius);
  const Lanes moment = across * ahead_rate - ahead * across_rate;
  const Lanes inner = larger(kNearAxis * moment, -kFarSide * moment) + kTipDisc * rate;
  return (x * x + y * y < inner) & (ball.height - fall < before);
}

/// sin and cos for |v| < 1.7, to 1e-6.
PATCHMILL_INLINE void sin_cos(const Lanes& v, Lanes& sine, Lanes& cosine) {
  const Lanes z = v * v;
  sine = v * (1.0f -
              z * (1.0f / 6) *
                  (1.0f - z * (1.0f / 20) *
                              (1.0f - z * (1.0f / 42) *
                                          (1.0f - z * (1.0f / 72) * (1.0f - z * (1.0f / 110))))));
  cosine = 1.0f - z * 0.5f *
                      (1.0f - z * (1.0f / 12) *
                                  (1.0f - z * (1.0f / 30) *
                                              (1.0f - z * (1.0f / 56) * (1.0f - z * (1.0f / 90)))));
}

/// Signed distance of the point of the ball that is under a cell from the half-plane of the edge
/// [mm], at delta = at + off. Unlike the azimuth it is smooth at the tool axis. `valid`: the cell
/// is on the ball's lower side and on the edge's side of the axis.
template <bool kTurning, class Cells>
PATCHMILL_INLINE Lanes distance_to_edge(const PassFrame& pass, const Cells& cells,
                                        const Lanes& delta, Mask& valid, Lanes& height) {
  ToolState tool;
  BallPoint ball;
  move_tool<kTurning>(pass, delta, tool);
  cells.under(pass, tool, ball);
  const Lanes across = dot(ball.offset, tool.a), ahead = dot(ball.offset, tool.b);
  const Lanes up = dot(ball.offset, tool.t);
  Lanes sine, cosine;
  sin_cos(clamped(delta - pass.helix_rate * (up - pass.helix_height), -1.7f, 1.7f), sine, cosine);
  valid = (ball.open > 0.0f) & (up <= 0.0f) & (across * cosine + ahead * sine > -kTipWidth);
  height = ball.height;
  return ahead * cosine - across * sine;
}

PATCHMILL_INLINE Mask crossed(const Lanes& a, const Lanes& b) {
  return ((a <= 0.0f) & (b > 0.0f)) | ((a > 0.0f) & (b <= 0.0f));
}

/// For each lane a stretch of the pass in which the edge crosses the cell: its ends, and the
/// distances from the edge there. Equal distances: no crossing.
struct Stretch {
  Lanes left, right, at_left, at_right;
};

/// The crossings of each lane: one, but near the tool axis up to three.
struct Crossings {
  Stretch stretch[kMostCrossings];
  Mask taken[kMostCrossings] = {};

  PATCHMILL_INLINE void add(const Stretch& s, Mask lanes) {
    lanes &= crossed(s.at_left, s.at_right);
    if (!any(lanes)) return;
    for (int k = 0; k < kMostCrossings; ++k) {
      const Mask here = lanes & ~taken[k];
      stretch[k].left = here ? s.left : stretch[k].left;
      stretch[k].right = here ? s.right : stretch[k].right;
      stretch[k].at_left = here ? s.at_left : stretch[k].at_left;
      stretch[k].at_right = here ? s.at_right : stretch[k].at_right;
      lanes &= taken[k];
      taken[k] |= here;
    }
  }
};

/// Lowers the lanes to where the edge crosses them in a stretch; regula falsi.
template <bool kTurning, class Cells>
PATCHMILL_INLINE void lower(const PassFrame& pass, const Cells& cells, Stretch in,
                            const Mask& lanes, Lanes& lowest) {
  if (!any(lanes)) return;
  Mask valid;
  Lanes height;
  for (int k = 0; k < kSecants; ++k) {
    const Lanes apart = in.at_right - in.at_left;
    const Lanes back = apart == 0.0f ? all(0.0f) : in.at_right * (in.right - in.left) / apart;
    const Lanes delta = in.right - back;
    const Lanes now = distance_to_edge<kTurning>(pass, cells, delta, valid, height);
    const Mask right_of_it = crossed(now, in.at_right);
    in.left = right_of_it ? delta : in.left;
    in.at_left = right_of_it ? now : in.at_left;
    in.right = right_of_it ? in.right : delta;
    in.at_right = right_of_it ? in.at_right : now;
  }
  lowest = (lanes & valid & (height < lowest)) ? height : lowest;
}

/// Lowers the cells to every crossing of the edge in the pass. It is stepped through; where the
/// distance has an extremum between three steps without a change of sign, a parabola says whether
/// the edge came and went in between.
template <bool kTurning, class Cells>
PATCHMILL_INLINE void search(const PassFrame& pass, const Cells& cells, Lanes& lowest) {
  const int steps = 2 + static_cast<int>((pass.high - pass.low) / pass.search_step);
  const float width = (pass.high - pass.low) / static_cast<float>(steps);
  Crossings found;
  for (Stretch& s : found.stretch) s = {all(0.0f), all(0.0f), all(0.0f), all(0.0f)};
  Mask valid;
  Lanes height, oldest = all(0.0f), old = oldest;
  for (int i = 0; i <= steps; ++i) {
    const Lanes here = all(pass.low + width * static_cast<float>(i));
    const Lanes now = distance_to_edge<kTurning>(pass, cells, here, valid, height);
    if (i > 0) found.add({here - width, here, old, now}, Mask{} - 1);
    const Lanes bend = now - 2.0f * old + oldest;
    const Lanes half = 0.5f * (now - oldest);
    const Lanes turn = bend == 0.0f ? all(9.0f) : -half / bend;  // in steps, from the middle one
    const Lanes extreme = old + 0.5f * half * turn;
    const Mask between = (turn > -1.0f) & (turn < 1.0f) & ~crossed(oldest, old) &
                         ~crossed(old, now) & crossed(extreme, old);
    if (i > 1 && any(between)) {
      const Lanes at = here + (turn - 1.0f) * width;
      const Lanes there = distance_to_edge<kTurning>(pass, cells, at, valid, height);
      found.add({here - 2.0f * width, at, oldest, there}, between);
      found.add({at, here, there, now}, between);
    }
    oldest = old;
    old = now;
  }
  for (int k = 0; k < kMostCrossings; ++k)
    lower<kTurning>(pass, cells, found.stretch[k], found.taken[k], lowest);
}

/// Mills `count` <= kGroup registers of cells. Their Newton steps take turns: one step is a long
/// chain of dependent operations, and the processor fills it with the steps of the others.
template <bool kTurning, class Cells>
PATCHMILL_INLINE void mill_group(const PassFrame& pass, const Cells* cells, int count,
                                 float* height) {
  Lanes delta[kGroup], step[kGroup];
  for (int k = 0; k < count; ++k) delta[k] = clamped(cells[k].guess(pass), pass.low, pass.high);
  for (int i = 0; i < kSurelyNewton; ++i)
    for (int k = 0; k < count; ++k) step[k] = newton<kTurning>(pass, cells[k], delta[k]);
  for (int k = 0; k < count; ++k) {
    Lanes& before = *reinterpret_cast<Lanes*>(height + k * kWidth);
    Lanes now;
    Mask reached, cut = cuts<kTurning>(pass, cells[k], delta[k], before, step[k], now, reached);
    // lanes that have converged stay as they are, whoever is beside them
    for (int i = kSurelyNewton; i < kMostNewton && any(reached & rough(step[k])); ++i) {
      const Mask going_on = reached & rough(step[k]);
      Lanes further = delta[k];
      const Lanes next = newton<kTurning>(pass, cells[k], further);
      delta[k] = going_on ? further : delta[k];
      step[k] = going_on ? next : step[k];
      cut = cuts<kTurning>(pass, cells[k], delta[k], before, step[k], now, reached);
    }
    before = (cut & ~rough(step[k])) ? now : before;
  }
}

PATCHMILL_INLINE Lanes load(const float* from) {
  Lanes v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}

/// The second look at the cells near the tool axis: they are few, so they are gathered into full
/// registers.
template <bool kTurning, class Cells>
PATCHMILL_INLINE void search_group(const PassFrame& pass, const Cells* cells, int count,
                                   float* height) {
  Cells gathered = cells[0];
  Lanes lowest = all(0.0f);
  int from[kWidth], taken = 0;
  for (int k = 0; k < count; ++k) {
    const Mask near =
        near_axis<kTurning>(pass, cells[k], *reinterpret_cast<Lanes*>(height + k * kWidth));
    const bool last = k + 1 == count;
    if (!any(near) && !(last && taken > 0)) continue;
    for (int lane = 0; lane < kWidth; ++lane) {
      if (near[lane] != 0) {
        gathered.take(taken, cells[k], lane);
        from[taken] = k * kWidth + lane;
        lowest[taken] = height[from[taken]];
        ++taken;
      }
      if (taken < kWidth && !(last && lane + 1 == kWidth)) continue;
      search<kTurning>(pass, gathered, lowest);
      for (int g = 0; g < taken; ++g) height[from[g]] = lowest[g];
      taken = 0;
    }
  }
}

template <bool kTurning, class Cells>
PATCHMILL_INLINE void treat_group(bool near_axis_only, const PassFrame& pass, const Cells* cells,
                                  int count, float* height) {
  if (near_axis_only)
    search_group<kTurning>(pass, cells, count, height);
  else
    mill_group<kTurning>(pass, cells, count, height);
}

template <bool kTurning>
PATCHMILL_INLINE void mill_flat_row(bool near_axis_only, const PassFrame& pass, float x, float y,
                                    float step, int chunks, float* height) {
  Lanes column;
  for (int i = 0; i < kWidth; ++i) column[i] = static_cast<float>(i);
  FlatCells cells[kGroup];
  for (int c = 0; c < chunks; c += kGroup) {
    const int count = chunks - c < kGroup ? chunks - c : kGroup;
    for (int k = 0; k < count; ++k)
      cells[k] = {x + (column + static_cast<float>((c + k) * kWidth)) * step, all(y),
                  pass.centre_height};
    treat_group<kTurning>(near_axis_only, pass, cells, count, height + c * kWidth);
  }
}

template <bool kTurning>
PATCHMILL_INLINE void mill_curved_row(bool near_axis_only, const PassFrame& pass,
                                      const CurvedRow& row, const float shift[3], int chunks,
                                      float* height) {
  CurvedCells cells[kGroup];
  for (int c = 0; c < chunks; c += kGroup) {
    const int count = chunks - c < kGroup ? chunks - c : kGroup;
    for (int k = 0; k < count; ++k) {
      const int at = (c + k) * kWidth;
      cells[k] = {
          {load(row.x + at) + shift[0], load(row.y + at) + shift[1], load(row.z + at) + shift[2]},
          {load(row.nx + at), load(row.ny + at), load(row.nz + at)}};
    }
    treat_group<kTurning>(near_axis_only, pass, cells, count, height + c * kWidth);
  }
}

}  // namespace

void mill_flat(bool near_axis_only, const PassFrame& pass, float x, float y, float step, int chunks,
               float* height) {
  const int registers = chunks * (kLanes / kWidth);
  if (pass.turning)
    mill_flat_row<true>(near_axis_only, pass, x, y, step, registers, height);
  else
    mill_flat_row<false>(near_axis_only, pass, x, y, step, registers, height);
}

void mill_curved(bool near_axis_only, const PassFrame& pass, const CurvedRow& row,
                 const float shift[3], int chunks, float* height) {
  const int registers = chunks * (kLanes / kWidth);
  if (pass.turning)
    mill_curved_row<true>(near_axis_only, pass, row, shift, registers, height);
  else
    mill_curved_row<false>(near_axis_only, pass, row, shift, registers, height);
}

}  // namespace patchmill::PATCHMILL_ISA

// The one moment at which an edge is over each cell: Newton's method on r(delta) of flute_kernel.h.
// Part of flute_rows.h, which see.
// SPDX-License-Identifier: LGPL-2.1-or-later

namespace patchmill::marks::PATCHMILL_ISA {
namespace {

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

}  // namespace
}  // namespace patchmill::marks::PATCHMILL_ISA

// Every moment at which an edge is over a cell near the tool axis: stepping through the pass.
// Part of flute_rows.h, which see.
// SPDX-License-Identifier: LGPL-2.1-or-later

namespace patchmill::marks::PATCHMILL_ISA {
namespace {

/// Lanes over which the edge may pass more than once: where, some time in the pass, the feed
/// carries the azimuth of the point of the ball on with the spindle and as fast. The point's way
/// (x, y) across the tool axis is taken as straight, so that x y' - y x' is constant and the
/// azimuth turns at that over x² + y². Only lanes that the ball may reach below `before`; while it moves
/// straight on, only those that it reaches near such a time. `from`, `to`: where to look for crossings.
template <bool kTurning, class Cells>
PATCHMILL_INLINE Mask near_axis(const PassFrame& pass, const Cells& cells, const Lanes& before,
                                Lanes& from, Lanes& to) {
  const float middle = 0.5f * (pass.low + pass.high), half = 0.5f * (pass.high - pass.low);
  ToolState tool;
  BallPoint ball;
  move_tool<kTurning>(pass, all(middle), tool);
  cells.under(pass, tool, ball);
  const Lanes across = dot(ball.offset, tool.a), ahead = dot(ball.offset, tool.b);
  const Lanes across_rate = dot(ball.rate, tool.a), ahead_rate = dot(ball.rate, tool.b);
  const Lanes rate = across_rate * across_rate + ahead_rate * ahead_rate + 1e-12f;
  const Lanes passing = -(across * across_rate + ahead * ahead_rate) / rate;
  const Lanes nearest = clamped(passing, -half, half);
  const Lanes x = across + nearest * across_rate, y = ahead + nearest * ahead_rate;
  const Lanes fall = larger(ball.height_rate, -ball.height_rate) * half +
                     dot(tool.velocity, tool.velocity) * (half * half / pass.radius);
  const Lanes moment = across * ahead_rate - ahead * across_rate;
  const Lanes inner = larger(kNearAxis * moment, -kFarSide * moment) + kTipDisc * rate;
  from = all(pass.low);
  to = all(pass.high);
  const Mask near = (x * x + y * y < inner) & (ball.height - fall < before);
  if (kTurning || !pass.kinks.empty() || !any(near)) return near;
  // the time at which the place at `before` is in the ball: |D - v s| < R, s from the middle on
  const Lanes3 n = cells.normal();
  const Lanes over = before - ball.height;
  const Lanes3 d = {ball.offset.x + over * n.x, ball.offset.y + over * n.y,
                    ball.offset.z + over * n.z};
  const Lanes vv = dot(tool.velocity, tool.velocity) + 1e-12f, dv = dot(d, tool.velocity);
  const Lanes room = dv * dv - vv * (dot(d, d) - pass.radius * pass.radius);
  Lanes reach = larger(room, all(0.0f));
  root(reach);
  from = larger(from, (dv - reach) / vv + (middle - kTimeSlack));
  to = smaller(to, (dv + reach) / vv + (middle + kTimeSlack));
  // the time at which the azimuth may be as fast: (x, y) within `inner`
  const Lanes px = across + passing * across_rate, py = ahead + passing * ahead_rate;
  Lanes window = larger(inner - (px * px + py * py), all(0.0f)) / rate;
  root(window);
  return near & (room > 0.0f) & (from < to) &
         (from < passing + 1.2f * window + (middle + kWindowSlack)) &
         (to > passing - 1.2f * window + (middle - kWindowSlack));
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

/// Lowers the cells to every crossing of the edge from `from` to `to`. That is stepped through; where the
/// distance has an extremum between three steps without a change of sign, a parabola says whether
/// the edge came and went in between.
template <bool kTurning, class Cells>
PATCHMILL_INLINE void search(const PassFrame& pass, const Cells& cells, const Lanes& from,
                             const Lanes& to, Lanes& lowest) {
  // every lane has steps of its own, so that it does not matter who is beside it
  Lanes count;
  int most = 0;
  for (int lane = 0; lane < kWidth; ++lane) {
    const int steps = 2 + static_cast<int>((to[lane] - from[lane]) / pass.search_step);
    count[lane] = static_cast<float>(steps);
    most = steps > most ? steps : most;
  }
  const Lanes width = (to - from) / count;
  Crossings found;
  for (Stretch& s : found.stretch) s = {all(0.0f), all(0.0f), all(0.0f), all(0.0f)};
  Mask valid;
  Lanes height, oldest = all(0.0f), old = oldest;
  for (int i = 0; i <= most; ++i) {
    const Mask going = count >= static_cast<float>(i);
    const Lanes here = from + width * static_cast<float>(i);
    const Lanes now = distance_to_edge<kTurning>(pass, cells, here, valid, height);
    if (i > 0) found.add({here - width, here, old, now}, going);
    const Lanes bend = now - 2.0f * old + oldest;
    const Lanes half = 0.5f * (now - oldest);
    const Lanes turn = bend == 0.0f ? all(9.0f) : -half / bend;  // in steps, from the middle one
    const Lanes extreme = old + 0.5f * half * turn;
    const Mask between = (turn > -1.0f) & (turn < 1.0f) & ~crossed(oldest, old) &
                         ~crossed(old, now) & crossed(extreme, old) & going;
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

/// The second look at the cells near the tool axis: they are few, so they are gathered into full
/// registers.
template <bool kTurning, class Cells>
PATCHMILL_INLINE void search_group(const PassFrame& pass, const Cells* cells, int count,
                                   float* height) {
  Cells gathered = cells[0];
  Lanes lowest = all(0.0f), from = lowest, to = lowest;
  int cell[kWidth], taken = 0;
  for (int k = 0; k < count; ++k) {
    Lanes begin, end;
    const Mask near = near_axis<kTurning>(
        pass, cells[k], *reinterpret_cast<Lanes*>(height + k * kWidth), begin, end);
    const bool last = k + 1 == count;
    if (!any(near) && !(last && taken > 0)) continue;
    for (int lane = 0; lane < kWidth; ++lane) {
      if (near[lane] != 0) {
        gathered.take(taken, cells[k], lane);
        cell[taken] = k * kWidth + lane;
        lowest[taken] = height[cell[taken]];
        from[taken] = begin[lane];
        to[taken] = end[lane];
        ++taken;
      }
      if (taken < kWidth && !(last && lane + 1 == kWidth)) continue;
      for (int g = taken; g < kWidth; ++g) from[g] = to[g] = from[0];  // nobody's lanes
      search<kTurning>(pass, gathered, from, to, lowest);
      for (int g = 0; g < taken; ++g) height[cell[g]] = lowest[g];
      taken = 0;
    }
  }
}

}  // namespace
}  // namespace patchmill::marks::PATCHMILL_ISA

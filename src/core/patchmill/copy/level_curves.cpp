// Marching squares; see level_curves.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/copy/level_curves.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace patchmill::copy {
namespace {

// Edges are numbered 2 * node for the one along +u, 2 * node + 1 for the one along +v.
struct Marcher {
  const PlanarGrid& grid;
  std::vector<double> value;
  std::vector<std::int64_t> next;  // per edge: the edge that the curve goes on to
  std::vector<std::uint8_t> entered;

  std::size_t node(int i, int j) const { return std::size_t(j) * grid.columns + i; }
  Vec2 at(std::size_t n) const {
    return grid.origin + grid.pitch * Vec2(double(n % grid.columns), double(n / grid.columns));
  }

  // Around a cell anticlockwise, an edge from inside to outside is where a curve with the inside on
  // its left begins, and one from outside to inside where it ends.
  void march(int i, int j) {
    const std::array<std::size_t, 4> corner{node(i, j), node(i + 1, j), node(i + 1, j + 1),
                                            node(i, j + 1)};
    const std::array<std::size_t, 4> edge{2 * corner[0], 2 * corner[1] + 1, 2 * corner[3],
                                          2 * corner[0] + 1};
    std::array<bool, 4> in;
    double sum = 0.0;
    for (int k = 0; k < 4; ++k) {
      in[k] = value[corner[k]] < 0.0;
      sum += std::max(-1e9, std::min(1e9, value[corner[k]]));
    }
    const bool saddle = in[0] == in[2] && in[1] == in[3] && in[0] != in[1];
    for (int k = 0; k < 4; ++k) {
      if (!in[k] || in[(k + 1) % 4]) continue;
      int to = (k + 3) % 4;                       // round the inner corner k
      if (saddle && sum < 0.0) to = (k + 1) % 4;  // the inside joins up: round the outer corner
      while (!saddle && !(in[(to + 1) % 4] && !in[to])) to = (to + 3) % 4;
      next[edge[k]] = static_cast<std::int64_t>(edge[to]);
      entered[edge[to]] = 1;
    }
  }

  Vec2 crossing(std::int64_t edge, const PlanarFunction& f, double tolerance) const {
    const std::size_t a = std::size_t(edge) / 2, b = edge % 2 == 0 ? a + 1 : a + grid.columns;
    Vec2 in = value[a] < 0.0 ? at(a) : at(b), out = value[a] < 0.0 ? at(b) : at(a);
    double f_in = std::min(value[a], value[b]), f_out = std::max(value[a], value[b]);
    for (int i = 0; i < 60 && (out - in).norm() > tolerance; ++i) {
      // regula falsi kept away from the ends, halving every other time
      double s = f_in / (f_in - f_out);
      if (i % 2 == 1 || !std::isfinite(s)) s = 0.5;
      s = std::min(0.95, std::max(0.05, s));
      const Vec2 mid = in + s * (out - in);
      const double value_mid = f(mid);
      (value_mid < 0.0 ? in : out) = mid;
      (value_mid < 0.0 ? f_in : f_out) = value_mid;
    }
    return out;
  }
};

}  // namespace

PlanarGrid planar_grid(const Vec2& lo, const Vec2& hi, double pitch) {
  require_positive("sampling distance", pitch, "mm");
  const Vec2 count = ((hi - lo) / pitch).array().ceil() + 2.0;
  if (!(count.prod() <= 5e7))
    throw InputError("sampling distance",
                     fmt::format("{} mm, {} points a level", pitch, count.prod()),
                     "enlarge the tolerance.");
  return {lo - Vec2::Constant(0.5 * pitch), pitch, int(count.x()), int(count.y())};
}

std::vector<Polyline> level_curves(const PlanarGrid& grid, const PlanarFunction& f,
                                   double tolerance) {
  const std::size_t nodes = std::size_t(grid.columns) * grid.rows;
  Marcher marcher{grid, std::vector<double>(nodes), std::vector<std::int64_t>(2 * nodes, -1),
                  std::vector<std::uint8_t>(2 * nodes, 0)};
  patchmill::parallel_for(std::size_t{0}, nodes,
                          [&](std::size_t n) { marcher.value[n] = f(marcher.at(n)); });
  for (int j = 0; j + 1 < grid.rows; ++j)
    for (int i = 0; i + 1 < grid.columns; ++i) marcher.march(i, j);

  std::vector<Polyline> curves;
  std::vector<std::vector<std::int64_t>> chains;
  const auto follow = [&](std::size_t start) {
    std::vector<std::int64_t> chain{static_cast<std::int64_t>(start)};
    std::int64_t edge = marcher.next[start];
    marcher.next[start] = -1;
    while (edge >= 0 && edge != chain.front()) {
      chain.push_back(edge);
      const std::int64_t following = marcher.next[edge];
      marcher.next[edge] = -1;
      edge = following;
    }
    curves.push_back({std::vector<Vec2>(chain.size()), edge >= 0});
    chains.push_back(std::move(chain));
  };
  for (std::size_t e = 0; e < 2 * nodes; ++e)  // those that begin at the border first
    if (marcher.next[e] >= 0 && !marcher.entered[e]) follow(e);
  for (std::size_t e = 0; e < 2 * nodes; ++e)
    if (marcher.next[e] >= 0) follow(e);
  for (std::size_t c = 0; c < curves.size(); ++c)
    patchmill::parallel_for(std::size_t{0}, chains[c].size(), [&](std::size_t i) {
      curves[c].points[i] = marcher.crossing(chains[c][i], f, tolerance);
    });
  return curves;
}

}  // namespace patchmill::copy

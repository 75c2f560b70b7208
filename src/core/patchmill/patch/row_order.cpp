// Dimples in the order of rows; see row_order.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/row_order.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>
#include <tbb/parallel_sort.h>

namespace patchmill::patch {
namespace {

constexpr std::int64_t kSparse = 4;  // lines for each place, beyond which they are not counted

// Where a dimple is in the order. `line` counts the rows across, `at` goes along them.
struct Place {
  std::int32_t patch, line, at;
  std::uint32_t index;
  bool operator<(const Place& o) const {
    if (patch != o.patch) return patch < o.patch;
    if (line != o.line) return line < o.line;
    if (at != o.at) return at < o.at;
    return index < o.index;
  }
};

// Steps that a lattice point is away from a row through (0, 0) along `step`, and along that row: neighbour steps are
// (1, 0), (0, 1) and (-1, 1).
Place place_of(const LatticePoint& p, const LatticePoint& step) {
  return {0, p[1] * step[0] - p[0] * step[1], step[1] ? p[1] * step[1] : p[0] * step[0], 0};
}

// Turns every other row round, counted inside its patch.
void go_to_and_fro(std::vector<Place>& places) {
  bool back = false;
  for (std::size_t first = 0, last = 0; first < places.size(); first = last) {
    const Place& row = places[first];
    while (last < places.size() && places[last].patch == row.patch && places[last].line == row.line)
      ++last;
    if (first > 0) back = places[first - 1].patch == row.patch && !back;
    if (back)
      std::reverse(places.begin() + std::ptrdiff_t(first), places.begin() + std::ptrdiff_t(last));
  }
}

// Sorts places of one patch: lines are numbers without gaps, but for holes, so that each place can be put to its line
// at once; what is left to sort is each line.
void sort_by_line(std::vector<Place>& places) {
  const auto [low, high] = std::minmax_element(
      places.begin(), places.end(), [](const Place& a, const Place& b) { return a.line < b.line; });
  const std::int64_t first = low->line, lines = high->line - first + 1;
  if (lines > kSparse * std::int64_t(places.size())) {
    tbb::parallel_sort(places.begin(), places.end());
    return;
  }
  std::vector<std::size_t> begin(std::size_t(lines) + 1, 0);
  for (const Place& place : places) ++begin[std::size_t(place.line - first) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  std::vector<Place> by_line(places.size());
  for (const Place& place : places) by_line[next[std::size_t(place.line - first)]++] = place;
  patchmill::parallel_for(std::size_t{0}, next.size(), [&](std::size_t line) {
    std::sort(by_line.begin() + std::ptrdiff_t(begin[line]),
              by_line.begin() + std::ptrdiff_t(begin[line + 1]));
  });
  places = std::move(by_line);
}

// The dimples to be cut, sorted along and across the rows; patch by patch unless `whole`.
std::vector<Place> sorted(const Dimples& dimples, const LatticePoint& step, bool whole) {
  std::vector<Place> places;
  places.reserve(dimples.size());
  for (std::size_t k = 0; k < dimples.size(); ++k) {
    if (dimples[k].state != DimpleState::Cut) continue;
    places.push_back(place_of(dimples[k].lattice, step));
    places.back().patch = whole ? 0 : dimples[k].patch;
    places.back().index = static_cast<std::uint32_t>(k);
  }
  if (whole && !places.empty())
    sort_by_line(places);
  else
    tbb::parallel_sort(places.begin(), places.end());
  return places;
}

}  // namespace

Dimples in_rows(const Dimples& dimples, LatticeKind kind, const RowOrder& order) {
  const auto& steps = neighbour_steps(kind);
  if (order.direction >= steps.size())
    throw InputError("RowDirection", fmt::format("step {}", order.direction),
                     fmt::format("give one of the lattice's {} steps.", steps.size()));
  const bool whole = order.extent == RowExtent::WholeFace;
  std::vector<Place> places = sorted(dimples, steps[order.direction], whole);
  if (!order.one_way) go_to_and_fro(places);
  Dimples ordered;
  ordered.reserve(dimples.size());
  std::int32_t row = -1, line = 0;
  for (const Place& place : places) {
    if (row < 0 || place.line != line) ++row;
    line = place.line;
    ordered.push_back(dimples[place.index]);
    if (whole) ordered.back().patch = row;
  }
  for (const Dimple& dimple : dimples)
    if (dimple.state != DimpleState::Cut) ordered.push_back(dimple);
  return ordered;
}

std::size_t nearest_step(LatticeKind kind, const Vec2& direction) {
  const auto& steps = neighbour_steps(kind);
  std::size_t best = 0;
  double most = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double along = std::abs(direction.dot(lattice_place(kind, 1.0, to_vec(steps[i]))));
    if (along <= most * (1.0 + 1e-9)) continue;
    most = along;
    best = i;
  }
  return best;
}

std::size_t flattest_step(const Dimples& dimples, LatticeKind kind) {
  const auto& steps = neighbour_steps(kind);
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::vector<Place> places = sorted(dimples, steps[i], true);
    double sum = 0.0;
    std::int64_t count = 0;
    for (std::size_t k = 1; k < places.size(); ++k) {
      if (places[k].line != places[k - 1].line || places[k].at != places[k - 1].at + 1) continue;
      const SurfacePoint &a = dimples[places[k - 1].index].surface,
                         &b = dimples[places[k].index].surface;
      const Vec3 way = b.position - a.position;
      sum += std::abs((b.normal - a.normal).dot(way)) / way.squaredNorm();
      ++count;
    }
    if (count == 0 || sum / double(count) >= least * (1.0 - 1e-9)) continue;
    least = sum / double(count);
    best = i;
  }
  return best;
}

}  // namespace patchmill::patch

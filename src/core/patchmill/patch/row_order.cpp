// Dimples in the order of rows; see row_order.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/row_order.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/large_vector.h"
#include "patchmill/geometry/stop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_invoke.h>
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

// Sorts by a whole number and leaves equals in their order. Numbers without gaps, but for holes, are counted, so that
// each place can be put where it belongs at once. False, and nothing done, where they are too sparse for that.
template <class Number>
bool sort_by_counting(Place* first, Place* last, const Number& number,
                      std::vector<std::size_t>& begin) {
  const auto less = [&](const Place& a, const Place& b) { return number(a) < number(b); };
  const auto [least, most] = std::minmax_element(first, last, less);
  const std::int64_t low = number(*least), span = number(*most) - low + 1;
  if (span > kSparse * (last - first)) return false;
  begin.assign(std::size_t(span) + 1, 0);
  for (const Place* p = first; p != last; ++p) ++begin[std::size_t(number(*p) - low) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  std::vector<Place> sorted(static_cast<std::size_t>(last - first));
  for (const Place* p = first; p != last; ++p) sorted[next[std::size_t(number(*p) - low)]++] = *p;
  std::copy(sorted.begin(), sorted.end(), first);
  return true;
}

// Sorts places of one patch, which come in the order of their indices: to their lines, then along each.
void sort_by_line(std::vector<Place>& places) {
  std::vector<std::size_t> begin;
  Place* const all = places.data();
  if (!sort_by_counting(
          all, all + places.size(), [](const Place& p) { return std::int64_t{p.line}; }, begin)) {
    tbb::parallel_sort(places.begin(), places.end());
    return;
  }
  patchmill::parallel_for(std::size_t{0}, begin.size() - 1, [&](std::size_t line) {
    Place *const first = all + begin[line], *const last = all + begin[line + 1];
    std::vector<std::size_t> slots;
    const auto at = [](const Place& p) { return std::int64_t{p.at}; };
    if (first != last && !sort_by_counting(first, last, at, slots)) std::sort(first, last);
  });
}

// Sorted places of one patch: its rows become patches.
void number_rows(std::vector<Place>& places) {
  std::int32_t row = -1, line = 0;
  for (Place& place : places) {
    if (row < 0 || place.line != line) ++row;
    line = place.line;
    place.patch = row;
  }
}

// How many dimples before each block of so many are to be cut, and last, how many of all.
constexpr std::size_t kBlock = 1U << 14;
std::vector<std::size_t> cut_before_blocks(const Dimples& dimples) {
  std::vector<std::size_t> cut((dimples.size() + kBlock - 1) / kBlock + 1, 0);
  patchmill::parallel_for(std::size_t{1}, cut.size(), [&](std::size_t b) {
    const std::size_t last = std::min(dimples.size(), b * kBlock);
    for (std::size_t k = (b - 1) * kBlock; k < last; ++k)
      cut[b] += dimples[k].state == DimpleState::Cut;
  });
  std::partial_sum(cut.begin(), cut.end(), cut.begin());
  return cut;
}

// visit(k, i, c) for each dimple k: it is the i-th of those that are to be cut (c), or the i-th of the others.
template <class Visit>
void each_by_state(const Dimples& dimples, const std::vector<std::size_t>& cut_before,
                   const Visit& visit) {
  patchmill::parallel_for(std::size_t{0}, cut_before.size() - 1, [&](std::size_t b) {
    const std::size_t last = std::min(dimples.size(), (b + 1) * kBlock);
    std::size_t cut = cut_before[b];
    for (std::size_t k = b * kBlock; k < last; ++k) {
      const bool is_cut = dimples[k].state == DimpleState::Cut;
      visit(k, is_cut ? cut : k - cut, is_cut);
      cut += is_cut;
    }
  });
}

// The dimples to be cut, sorted along and across the rows; patch by patch unless `whole`.
std::vector<Place> sorted(const Dimples& dimples, const std::vector<std::size_t>& cut_before,
                          const LatticePoint& step, bool whole) {
  std::vector<Place> places(cut_before.back());
  each_by_state(dimples, cut_before, [&](std::size_t k, std::size_t i, bool is_cut) {
    if (!is_cut) return;
    places[i] = place_of(dimples[k].lattice, step);
    places[i].patch = whole ? 0 : dimples[k].patch;
    places[i].index = static_cast<std::uint32_t>(k);
  });
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
  const std::vector<std::size_t> cut_before = cut_before_blocks(dimples);
  std::vector<Place> places;
  Dimples ordered;
  tbb::parallel_invoke(
      [&] {
        places = sorted(dimples, cut_before, steps[order.direction], whole);
        if (!order.one_way) go_to_and_fro(places);
        if (whole) number_rows(places);
      },
      [&] {  // one thread makes it, and takes as long as what is serial in sorting
        ordered.reserve(dimples.size());
        make_large_pages(ordered.data(), dimples.size() * sizeof(Dimple));
        ordered.resize(dimples.size());
      });
  stop_point();
  patchmill::parallel_for(tbb::blocked_range<std::size_t>(0, places.size(), kBlock),
                          [&](const tbb::blocked_range<std::size_t>& range) {
                            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                              ordered[i] = dimples[places[i].index];
                              if (whole) ordered[i].patch = places[i].patch;
                            }
                          });
  each_by_state(dimples, cut_before, [&](std::size_t k, std::size_t i, bool is_cut) {
    if (!is_cut) ordered[places.size() + i] = dimples[k];
  });
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
  const std::vector<std::size_t> cut_before = cut_before_blocks(dimples);
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::vector<Place> places = sorted(dimples, cut_before, steps[i], true);
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

// Matsuda's condition, predicted and measured; see phase_difference.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/phase_difference.h"

#include "patchmill/geometry/angle.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace patchmill::patch {
namespace {

double fraction(double x) {
  const double f = x - std::floor(x);
  return f >= 1.0 ? 0.0 : f;
}

double signed_fraction(double x) {
  return x - std::floor(x + 0.5);
}

double tangent(const FreePatch& patch) {
  return std::tan(kPi / patch.corners);
}

}  // namespace

double facing_length(const FreePatch& p, int lap, int sector) {
  const double steps = 2.0 * p.corners * lap + 2.0 * sector + 1.0;
  return p.corners * p.side - steps * p.cross_feed * tangent(p);
}

double phase_difference(const FreePatch& patch, int lap, int sector) {
  return fraction(facing_length(patch, lap, sector) / patch.feed_per_tooth);
}

const char* name(MarkArray array) {
  switch (array) {
    case MarkArray::Square:
      return "square";
    case MarkArray::Staggered:
      return "staggered";
    case MarkArray::Oblique:
      return "oblique";
    case MarkArray::Drifting:
      return "drifting";
  }
  return "?";
}

MarkArrayState mark_array(const FreePatch& p, double tolerance) {
  require_valid(p);
  MarkArrayState state;
  const double per_side = 2.0 * tangent(p) * p.cross_feed / p.feed_per_tooth;
  state.first = phase_difference(p, 0, 0);
  state.drift_per_side = signed_fraction(-per_side);
  state.drift_per_lap = signed_fraction(-per_side * p.corners);
  state.laps = std::max(1, static_cast<int>(std::ceil(apothem(p) / p.cross_feed)));
  if (std::abs(state.drift_per_lap) * state.laps > tolerance) return state;
  state.sides_alike = std::abs(state.drift_per_side) * p.corners <= tolerance;
  if (std::abs(signed_fraction(state.first)) <= tolerance)
    state.array = MarkArray::Square;
  else if (std::abs(state.first - 0.5) <= tolerance)
    state.array = MarkArray::Staggered;
  else
    state.array = MarkArray::Oblique;
  return state;
}

std::string describe(const MarkArrayState& s) {
  if (s.array == MarkArray::Drifting)
    return fmt::format("drifting by {:.3g} teeth a pass, {:.2g} over the patch", s.drift_per_lap,
                       s.drift_per_lap * s.laps);
  std::string text = name(s.array);
  if (s.array == MarkArray::Oblique) text += fmt::format(" (leaning {:.3g} teeth a pass)", s.first);
  return text + (s.sides_alike
                     ? " on all sides"
                     : fmt::format(", turning {:.3g} teeth from side to side", s.drift_per_side));
}

std::vector<MeasuredPhase> measure_phase(const std::vector<HelixSide>& path,
                                         const std::vector<HelixMark>& marks,
                                         double feed_per_tooth) {
  constexpr int kNone = -1;
  std::vector<int> first(path.size(), kNone);  // first mark on each side of the path
  for (int n = static_cast<int>(marks.size()) - 1; n >= 0; --n) first[marks[n].side] = n;
  std::vector<MeasuredPhase> phases;
  std::vector<int> pass;  // by sector, the pass before
  for (int k = 0; k < static_cast<int>(path.size()); ++k) {
    const HelixSide& side = path[k];
    pass.resize(std::max(pass.size(), side.sector + std::size_t{1}), kNone);
    const int before = std::exchange(pass[side.sector], k);
    if (before == kNone || first[before] == kNone || first[k] == kNone) continue;
    const Vec2 along = (side.end - side.start).normalized();
    const Vec2 across = marks[first[k]].place - marks[first[before]].place;
    phases.push_back({std::min(path[before].lap, side.lap), side.sector,
                      fraction(-across.dot(along) / feed_per_tooth)});
  }
  return phases;
}

}  // namespace patchmill::patch

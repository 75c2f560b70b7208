// Matching found dimples with planned ones; see plan_comparison.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/marks/plan_comparison.h"

#include "patchmill/geometry/error.h"
#include "patchmill/marks/base_lookup.h"
#include "patchmill/marks/place_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace patchmill::marks {
namespace {

void add_statistics(const std::vector<DimpleMark>& found, double spacing, PlanComparison& out) {
  double count = 0, squares = 0, depth = 0, depth_squares = 0, score = 0;
  for (const DimpleMatch& match : out.matches) {
    if (match.found < 0) {
      ++out.missing;
      continue;
    }
    const double move = match.moved.norm(), share = 4.0 * move / spacing;
    const double d = found[static_cast<std::size_t>(match.found)].depth;
    ++count;
    squares += move * move;
    depth += d;
    depth_squares += d * d;
    out.mean_move += match.moved;
    out.largest_move = std::max(out.largest_move, move);
    score += std::max(0.0, 1.0 - share * share);
  }
  out.mean_move = count > 0 ? Vec2(out.mean_move / count) : Vec2::Zero();
  out.rms_move = count > 0 ? std::sqrt(squares / count) : std::numeric_limits<double>::quiet_NaN();
  out.rms_share = out.rms_move / spacing;
  out.mean_depth = depth / count;
  out.depth_deviation =
      std::sqrt(std::max(depth_squares / count - out.mean_depth * out.mean_depth, 0.0));
  const auto all = static_cast<double>(out.matches.size() + out.extra.size());
  out.quality = all > 0.0 ? score / all : 0.0;
}

}  // namespace

std::vector<PlannedPlace> planned_places(const patch::Dimples& dimples,
                                         const patch::TexturePlane& plane) {
  std::vector<PlannedPlace> places;
  for (std::size_t k = 0; k < dimples.size(); ++k)
    if (dimples[k].state == patch::DimpleState::Cut)
      places.push_back({static_cast<std::int32_t>(k), project(plane, dimples[k].surface.position)});
  return places;
}

PlanComparison compare_with_plan(const std::vector<DimpleMark>& found,
                                 const std::vector<PlannedPlace>& planned, double spacing) {
  require_positive("Spacing", spacing, "mm");
  std::vector<Vec2> found_places, planned_at;
  for (const DimpleMark& mark : found) found_places.push_back(mark.place);
  for (const PlannedPlace& plan : planned) planned_at.push_back(plan.place);
  const PlaceIndex found_index(found_places), planned_index(planned_at);
  PlanComparison out;
  std::vector<bool> taken(found.size(), false);
  for (std::size_t k = 0; k < planned.size(); ++k) {
    DimpleMatch match;
    match.dimple = planned[k].dimple;
    const std::size_t f = found_index.nearest(planned_at[k]);
    if (f != PlaceIndex::kNobody && !taken[f] && planned_index.nearest(found_places[f]) == k &&
        (found_places[f] - planned_at[k]).norm() <= 0.5 * spacing) {
      taken[f] = true;
      match.found = static_cast<std::int32_t>(f);
      match.moved = found_places[f] - planned_at[k];
    }
    out.matches.push_back(match);
  }
  for (std::size_t f = 0; f < found.size(); ++f)
    if (!taken[f]) out.extra.push_back(static_cast<std::int32_t>(f));
  add_statistics(found, spacing, out);
  return out;
}

}  // namespace patchmill::marks

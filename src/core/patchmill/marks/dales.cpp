// Watershed and Wolf pruning of a measured surface; see dales.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/marks/dales.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"
#include "patchmill/marks/hollows.h"

#include <cmath>
#include <limits>
#include <string>

namespace patchmill::marks {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

void require_valid(const HeightGrid& surface) {
  const auto points = static_cast<std::int64_t>(surface.rows) * surface.columns;
  if (surface.rows < 2 || surface.columns < 2 ||
      static_cast<std::int64_t>(surface.height.size()) != points)
    throw InputError("Heights",
                     std::to_string(surface.height.size()) + " for " +
                         std::to_string(surface.columns) + " x " + std::to_string(surface.rows),
                     "give a grid of at least 2 x 2 heights.");
  for (const double step : surface.step) require_in_range("GridStep", step, 1e-9, 1e6, "mm");
}

// The surface as a relief that was cut everywhere.
Relief as_relief(const HeightGrid& surface) {
  Relief relief;
  relief.grid.rows = surface.rows;
  relief.grid.columns = surface.columns;
  relief.grid.step = surface.step.x();
  relief.stock = kInfinite;
  relief.height = surface.height;
  return relief;
}

bool is_at_edge(const Relief& relief, std::int64_t cell) {
  int around = 0;
  for_neighbours(relief.grid, cell, [&](std::int64_t other, bool) {
    around += std::isnan(relief.height[static_cast<std::size_t>(other)]) ? 0 : 1;
  });
  return around < 8;
}

}  // namespace

std::vector<Dale> dales(const HeightGrid& surface, double least_depth) {
  require_valid(surface);
  require_in_range("LeastDepth", least_depth, 0.0, 1e9, "mm");
  const Relief relief = as_relief(surface);
  const Hollows hollows = label_hollows(relief);
  HollowMerger merger(relief, hollows);
  merger.merge(least_depth);
  stop_point();
  std::vector<std::int32_t> number(hollows.lowest.size(), kNoHollow);
  std::vector<Dale> found;
  for (std::size_t k = 0; k < number.size(); ++k) {
    const auto hollow = static_cast<std::int32_t>(k);
    if (merger.root(hollow) != hollow) continue;
    number[k] = static_cast<std::int32_t>(found.size());
    Dale dale;
    dale.pit = hollows.lowest[k];
    dale.bottom = double{relief.height[static_cast<std::size_t>(dale.pit)]};
    dale.depth = merger.depth(hollow);
    found.push_back(dale);
  }
  for (std::size_t k = 0; k < number.size(); ++k)
    number[k] = number[static_cast<std::size_t>(merger.root(static_cast<std::int32_t>(k)))];
  const double each = surface.step.prod();
  for (std::int64_t cell = 0; cell < relief.grid.cells(); ++cell) {
    const std::int32_t label = hollows.label[static_cast<std::size_t>(cell)];
    if (label == kNoHollow) continue;
    Dale& dale = found[static_cast<std::size_t>(number[static_cast<std::size_t>(label)])];
    const double below =
        dale.bottom + dale.depth - double{relief.height[static_cast<std::size_t>(cell)]};
    dale.area += each;
    if (below > 0.0) {
      dale.closed_area += each;
      dale.volume += std::isfinite(below) ? below * each : 0.0;
      if (!dale.at_edge) dale.at_edge = is_at_edge(relief, cell);
    }
    if (cell % relief.grid.columns == 0) stop_point();
  }
  return found;
}

}  // namespace patchmill::marks

// The hollows of a relief: each cut cell belongs to the one into which water would run from it, and dents are
// merged with the hollow over their lowest ridge, shallowest first.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/marks/relief.h"

#include <map>
#include <utility>
#include <vector>

namespace patchmill::marks {

inline constexpr std::int32_t kNoHollow = -1;

/// The hollow of each cell of a relief.
struct Hollows {
  std::vector<std::int32_t> label;   ///< hollow of each cell; kNoHollow for uncut and missing cells
  std::vector<std::int64_t> lowest;  ///< cell of each hollow
};

/// By steepest descent from every cell; equal heights go to the lower cell number.
Hollows label_hollows(const Relief& relief);

/// Calls visit(cell number, whether diagonally) for the up to eight neighbours of a cell.
template <class Visit>
void for_neighbours(const SurfaceGrid& grid, std::int64_t cell, Visit&& visit) {
  const int i = static_cast<int>(cell % grid.columns), j = static_cast<int>(cell / grid.columns);
  for (int dj = -1; dj <= 1; ++dj)
    for (int di = -1; di <= 1; ++di) {
      if (di == 0 && dj == 0) continue;
      if (i + di < 0 || i + di >= grid.columns || j + dj < 0 || j + dj >= grid.rows) continue;
      visit(grid.number(i + di, j + dj), di != 0 && dj != 0);
    }
}

/// Merges dents into their neighbours, over what is left of the ridges between hollows.
class HollowMerger {
 public:
  /// Both must outlive it.
  HollowMerger(const Relief& relief, const Hollows& hollows);

  /// Until every hollow is at least `least` deep [mm]; shallowest first. Those that are not, and are open to
  /// uncut ground only, are dropped.
  void merge(double least);
  std::int32_t root(std::int32_t k) const;  ///< the hollow that hollow k has become part of
  /// Whether hollow k was dropped by merge().
  bool dropped(std::int32_t k) const { return dropped_[static_cast<std::size_t>(k)]; }
  /// From the bottom of hollow k, a root, to the lowest point of its rim [mm].
  double depth(std::int32_t k) const;

 private:
  void take(std::int64_t cell, std::int64_t other);
  double bottom(std::int32_t k) const;
  std::pair<std::int32_t, double> lowest_ridge(std::int32_t k) const;
  std::int32_t join(std::int32_t a, std::int32_t b);

  const Relief& relief_;
  const Hollows& hollows_;
  std::vector<std::int32_t> parent_;
  std::vector<bool> dropped_;
  std::vector<std::map<std::int32_t, double>> ridges_;  // ordered: the same merges every time
};

}  // namespace patchmill::marks

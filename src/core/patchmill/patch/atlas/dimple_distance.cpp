// Distances between dimples, whatever lattice, patch or face they belong to; see laid_lattice.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"
#include "patchmill/patch/atlas/laid_lattice.h"
#include "patchmill/patch/atlas/near_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace patchmill::patch {

std::int64_t keep_apart(Dimples& dimples, double least) {
  require_in_range("LeastDistance", least, 0.0, 1e6, "mm");
  if (least == 0.0) return 0;
  NearPoints kept(least);
  std::int64_t count = 0;
  for (std::size_t k = 0; k < dimples.size(); ++k) {
    Dimple& d = dimples[k];
    if (d.state != DimpleState::Cut) continue;
    bool room = true;
    kept.around(d.surface.position,
                [&](std::size_t, double squared) { room = room && squared >= least * least; });
    if (room) {
      kept.add(d.surface.position, k);
    } else {
      d.state = DimpleState::Crowded;
      ++count;
    }
  }
  return count;
}

std::vector<double> nearest_distances(const Dimples& dimples) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  std::vector<const Vec3*> points;
  Eigen::AlignedBox3d box;
  for (const Dimple& d : dimples)
    if (d.state == DimpleState::Cut) {
      points.push_back(&d.surface.position);
      box.extend(d.surface.position);
    }
  std::vector<double> nearest(points.size(), kNone);
  if (points.size() < 2) return nearest;
  // cubes that would hold a few points of a surface; those that see none ask again in cubes twice as large
  const double size = std::max(box.diagonal().norm(), 1e-9);
  std::vector<std::size_t> open(points.size());
  for (std::size_t k = 0; k < open.size(); ++k) open[k] = k;
  for (double cube = size / std::sqrt(double(points.size())); !open.empty(); cube *= 2.0) {
    NearPoints all(cube);
    for (std::size_t k = 0; k < points.size(); ++k) all.add(*points[k], k);
    patchmill::parallel_for(std::size_t{0}, open.size(), [&](std::size_t i) {
      const std::size_t k = open[i];
      double squared = cube * cube;
      all.around(*points[k], [&](std::size_t n, double s) {
        if (n == k || s > squared) return;
        squared = s;
        nearest[k] = std::sqrt(s);
      });
    });
    std::vector<std::size_t> still;
    for (std::size_t k : open)
      if (nearest[k] == kNone) still.push_back(k);
    open.swap(still);
    if (cube > size) break;
  }
  return nearest;
}

}  // namespace patchmill::patch

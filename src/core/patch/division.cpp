// Square patch division; see division.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/patch/division.h"

#include "core/geometry/error.h"

#include <cmath>

#include <fmt/format.h>

namespace patchmill {
namespace {

struct PatchPlace {
  int ix, iy;
};

// Row by row, to and fro, so that links between patches stay short.
std::vector<PatchPlace> milling_order(const SquareDivision& d) {
  std::vector<PatchPlace> places;
  places.reserve(static_cast<std::size_t>(d.patches_x) * static_cast<std::size_t>(d.patches_y));
  for (int iy = 0; iy < d.patches_y; ++iy)
    for (int i = 0; i < d.patches_x; ++i) places.push_back({iy % 2 ? d.patches_x - 1 - i : i, iy});
  return places;
}

}  // namespace

void require_valid(const SquareDivision& d, std::int64_t max_dimples) {
  require_positive("Spacing", d.spacing, "mm");
  require_in_range("PatchSide", d.side, 1, 10000, "dimples");
  require_in_range("PatchesX", d.patches_x, 1, 100000, "patches");
  require_in_range("PatchesY", d.patches_y, 1, 100000, "patches");
  const double count = double(d.side) * d.side * d.patches_x * d.patches_y;
  if (count > double(max_dimples))
    throw InputError("Spacing", fmt::format("{} mm", d.spacing),
                     fmt::format("{:.0f} dimples are more than the limit of {}: choose a larger "
                                 "spacing or fewer patches.",
                                 count, max_dimples));
}

std::array<int, 2> patches_to_cover(const SquareDivision& division, double width, double height) {
  SquareDivision one = division;
  one.patches_x = one.patches_y = 1;
  require_valid(one);
  const double size = one.side * one.spacing;
  if (size > width || size > height)
    throw InputError(
        "PatchSide", fmt::format("{} dimples of {} mm", one.side, one.spacing),
        fmt::format("a patch of {:.3f} mm is larger than the faces ({:.3f} x {:.3f} mm "
                    "seen along the projection direction): choose a smaller side.",
                    size, width, height));
  return {static_cast<int>(std::ceil(width / size - 1e-9)),
          static_cast<int>(std::ceil(height / size - 1e-9))};
}

Vec2 place(const SquareDivision& d, const LatticePoint& lattice) {
  const double middle_x = 0.5 * (double(d.side) * d.patches_x - 1.0);
  const double middle_y = 0.5 * (double(d.side) * d.patches_y - 1.0);
  return d.spacing * Vec2(lattice[0] - middle_x, lattice[1] - middle_y);
}

Dimples lattice_points(const SquareDivision& d) {
  require_valid(d);
  const std::vector<LatticePoint> helix = square_helix(d.side, d.order);
  Dimples dimples;
  dimples.reserve(helix.size() * static_cast<std::size_t>(d.patches_x * d.patches_y));
  std::int32_t patch = 0;
  for (const PatchPlace& p : milling_order(d)) {
    for (const LatticePoint& step : helix) {
      Dimple dimple;
      dimple.lattice = {p.ix * d.side + step[0], p.iy * d.side + step[1]};
      dimple.patch = patch;
      dimples.push_back(dimple);
    }
    ++patch;
  }
  return dimples;
}

std::vector<std::array<Vec2, 4>> outlines(const SquareDivision& d) {
  require_valid(d);
  std::vector<std::array<Vec2, 4>> all;
  const double h = 0.5 * d.spacing, size = d.side * d.spacing;
  for (const PatchPlace& p : milling_order(d)) {
    const Vec2 a = place(d, {p.ix * d.side, p.iy * d.side}) - Vec2(h, h);
    all.push_back({a, a + Vec2(size, 0), a + Vec2(size, size), a + Vec2(0, size)});
  }
  return all;
}

}  // namespace patchmill

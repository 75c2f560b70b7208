// Tiling vectors, outlines and lattice points of patch divisions; see division.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/division.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/large_vector.h"

#include <cmath>

#include <fmt/format.h>

namespace patchmill::patch {
namespace {

// helices[down][turn], empty where not needed
using Helices = std::array<std::vector<std::vector<LatticePoint>>, 2>;

Helices helices_of(const PatchDivision& division) {
  Helices helices;
  const PatchPattern& p = division.pattern;
  for (auto& of_turn : helices) of_turn.resize(std::size_t(traits(p.shape).turns));
  for (const PatchCell& cell : division.cells) {
    auto& helix = helices[cell.down][static_cast<std::size_t>(cell.turn)];
    if (helix.empty()) helix = patch_helix(p.shape, p.size, p.order, cell.down, cell.turn);
  }
  return helices;
}

}  // namespace

void require_valid(const PatchPattern& p) {
  require_positive("Spacing", p.spacing, "mm");
  require_valid(p.shape, p.size);
}

std::array<LatticePoint, 2> tiling_vectors(PatchShape shape, PatchSize size) {
  return traits(shape).tiling_vectors(size);
}

LatticePoint cell_origin(const PatchPattern& pattern, const PatchCell& cell) {
  const auto v = tiling_vectors(pattern.shape, pattern.size);
  return {cell.a * v[0][0] + cell.b * v[1][0], cell.a * v[0][1] + cell.b * v[1][1]};
}

Vec2 place(const PatchDivision& d, const Vec2& lattice) {
  return d.anchor + lattice_place(lattice_of(d.pattern.shape), d.pattern.spacing, lattice);
}

Polygon outline_in_lattice(const PatchPattern& pattern, const PatchCell& cell) {
  Polygon outline = traits(pattern.shape).outline(pattern.size, cell.down);
  const Vec2 origin = to_vec(cell_origin(pattern, cell));
  for (Vec2& corner : outline) corner += origin;
  return outline;
}

std::vector<Polygon> outlines(const PatchDivision& d) {
  require_valid(d.pattern);
  std::vector<Polygon> all;
  all.reserve(d.cells.size());
  for (const PatchCell& cell : d.cells) {
    all.push_back(outline_in_lattice(d.pattern, cell));
    for (Vec2& corner : all.back()) corner = place(d, corner);
  }
  return all;
}

Dimples lattice_points(const PatchDivision& d, std::int64_t max_dimples) {
  require_valid(d.pattern);
  const double count =
      double(point_count(d.pattern.shape, d.pattern.size)) * double(d.cells.size());
  if (count > double(max_dimples))
    throw InputError("Spacing", fmt::format("{} mm", d.pattern.spacing),
                     fmt::format("{:.0f} dimples are more than the limit of {}: choose a larger "
                                 "spacing or fewer patches.",
                                 count, max_dimples));
  const Helices helices = helices_of(d);
  Dimples dimples;
  dimples.reserve(static_cast<std::size_t>(count));
  make_large_pages(dimples.data(), dimples.capacity() * sizeof(Dimple));
  Dimple dimple;
  for (const PatchCell& cell : d.cells) {
    const LatticePoint origin = cell_origin(d.pattern, cell);
    for (const LatticePoint& step : helices[cell.down][static_cast<std::size_t>(cell.turn)]) {
      dimple.lattice = {origin[0] + step[0], origin[1] + step[1]};
      dimples.push_back(dimple);
    }
    ++dimple.patch;
  }
  return dimples;
}

double link_length(const PatchDivision& d) {
  const Helices helices = helices_of(d);
  double sum = 0.0;
  Vec2 before = Vec2::Zero();
  for (std::size_t k = 0; k < d.cells.size(); ++k) {
    const PatchCell& cell = d.cells[k];
    const auto& helix = helices[cell.down][static_cast<std::size_t>(cell.turn)];
    const Vec2 origin = to_vec(cell_origin(d.pattern, cell));
    if (k > 0) sum += (place(d, origin + to_vec(helix.front())) - before).norm();
    before = place(d, origin + to_vec(helix.back()));
  }
  return sum;
}

}  // namespace patchmill::patch

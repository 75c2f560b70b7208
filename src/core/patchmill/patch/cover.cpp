// Blocks and covers of patches; see cover.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/cover.h"

#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>
#include <fmt/format.h>

namespace patchmill::patch {
namespace {

void require_count(const PatchPattern& p, double patches, std::int64_t max_dimples) {
  const double count = double(point_count(p.shape, p.size)) * patches;
  if (count > double(max_dimples))
    throw InputError("Spacing", fmt::format("{} mm", p.spacing),
                     fmt::format("about {:.0f} dimples are more than the limit of {}: choose a "
                                 "larger spacing or a smaller area.",
                                 count, max_dimples));
}

using HelixEnds = std::array<LatticePoint, 2>;  // first and last dimple

// [down][turn]; of inverted patches none where the shape has none.
std::array<std::vector<HelixEnds>, 2> helix_ends(const PatchPattern& p) {
  const ShapeTraits& t = traits(p.shape);
  const auto helix = patch_helix(p.shape, p.size, p.order);
  HelixEnds ends{helix.front(), helix.back()};
  std::array<std::vector<HelixEnds>, 2> found;
  for (int turn = 0; turn < t.turns; ++turn) {
    found[0].push_back(ends);
    if (t.has_inverted)
      found[1].push_back({t.inverted(p.size, ends[0]), t.inverted(p.size, ends[1])});
    for (LatticePoint& end : ends) end = t.turned(p.size, end);
  }
  return found;
}

// Turns each helix so that it starts at the corner next to the end of the one before.
void turn_to_nearest(PatchDivision& d) {
  const PatchPattern& p = d.pattern;
  const int n = traits(p.shape).turns;
  const std::array<std::vector<HelixEnds>, 2> ends = helix_ends(p);
  Vec2 before = Vec2::Zero();
  for (std::size_t k = 0; k < d.cells.size(); ++k) {
    PatchCell& cell = d.cells[k];
    const Vec2 origin = to_vec(cell_origin(p, cell));
    auto gap = [&](int turn) {
      return (place(d, origin + to_vec(ends[cell.down][std::size_t(turn)][0])) - before).norm();
    };
    for (int turn = 1; k > 0 && turn < n; ++turn)
      if (gap(turn) < gap(cell.turn) - 1e-9 * p.spacing) cell.turn = turn;
    before = place(d, origin + to_vec(ends[cell.down][std::size_t(cell.turn)][1]));
  }
}

// Sorts cells into rows or columns, to and fro.
void order_cells(PatchDivision& d) {
  const bool columns = traits(d.pattern.shape).in_columns;
  auto row = [&](const PatchCell& c) { return columns ? c.a : c.b; };
  auto along = [&](const PatchCell& c) { return columns ? c.b : 2 * c.a + (c.down ? 1 : 0); };
  std::sort(d.cells.begin(), d.cells.end(), [&](const PatchCell& l, const PatchCell& r) {
    return row(l) != row(r) ? row(l) < row(r) : along(l) < along(r);
  });
  bool fro = false;
  for (auto first = d.cells.begin(); first != d.cells.end(); fro = !fro) {
    const auto last = std::find_if(first, d.cells.end(),
                                   [&](const PatchCell& c) { return row(c) != row(*first); });
    if (fro) std::reverse(first, last);
    first = last;
  }
  if (d.pattern.start == HelixStart::NearestCorner) turn_to_nearest(d);
}

// Separating axes: the box's two and the polygon's edge normals. Touching is not overlapping.
bool overlap(const Polygon& polygon, const Box2& box, double tolerance) {
  Box2 around;
  for (const Vec2& p : polygon) around.extend(p);
  for (int k = 0; k < 2; ++k)
    if (around.min()[k] > box.max()[k] - tolerance || around.max()[k] < box.min()[k] + tolerance)
      return false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& p = polygon[i];
    const Vec2 edge = (polygon[(i + 1) % polygon.size()] - p).normalized();
    const Vec2 inward(-edge.y(), edge.x());
    double furthest = -std::numeric_limits<double>::infinity();
    for (int c = 0; c < 4; ++c)
      furthest = std::max(furthest, inward.dot(box.corner(Box2::CornerType(c)) - p));
    if (furthest < tolerance) return false;
  }
  return true;
}

// The cell indices whose patches may overlap the area.
std::array<int, 4> cell_range(const PatchDivision& d, const Box2& area) {
  const auto v = tiling_vectors(d.pattern.shape, d.pattern.size);
  Eigen::Matrix2d cells;
  cells.col(0) = place(d, v[0]) - d.anchor;
  cells.col(1) = place(d, v[1]) - d.anchor;
  const Eigen::Matrix2d inverse = cells.inverse();
  Eigen::AlignedBox2d range;
  for (int c = 0; c < 4; ++c)
    range.extend(Vec2(inverse * (area.corner(Box2::CornerType(c)) - d.anchor)));
  auto whole = [](double x) { return static_cast<int>(std::clamp(std::floor(x), -1e8, 1e8)); };
  return {whole(range.min().x()) - 2, whole(range.max().x()) + 2, whole(range.min().y()) - 2,
          whole(range.max().y()) + 2};
}

Vec2 centred_anchor(const PatchPattern& p, const Box2& area) {
  return area.center() + p.spacing * traits(p.shape).anchor(p.size, Vec2(area.sizes() / p.spacing));
}

}  // namespace

PatchDivision patch_block(const PatchPattern& pattern, int patches_x, int patches_y,
                          std::int64_t max_dimples) {
  require_valid(pattern);
  require_in_range("PatchesX", patches_x, 1, 100000, "patches");
  require_in_range("PatchesY", patches_y, 1, 100000, "patches");
  require_count(pattern, double(patches_x) * patches_y, max_dimples);
  PatchDivision d;
  d.pattern = pattern;
  for (int x = 0; x < patches_x; ++x)
    for (int y = 0; y < patches_y; ++y) {
      const auto [cell, inverted] = traits(pattern.shape).in_block(pattern.size, x, y);
      d.cells.push_back({cell[0], cell[1], inverted, 0});
    }
  Box2 around;
  for (const Polygon& outline : outlines(d))
    for (const Vec2& corner : outline) around.extend(corner);
  d.anchor = -around.center();
  order_cells(d);
  return d;
}

PatchDivision cover(const PatchPattern& pattern, const Box2& area, std::int64_t max_dimples) {
  require_valid(pattern);
  return cover(pattern, area, centred_anchor(pattern, area), max_dimples);
}

PatchDivision cover(const PatchPattern& pattern, const Box2& area, const Vec2& anchor,
                    std::int64_t max_dimples) {
  require_valid(pattern);
  if (area.isEmpty() || !area.min().allFinite() || !area.max().allFinite())
    throw InputError("Area", "empty", "give an area with finite corners.");
  require_count(
      pattern,
      area.volume() / (cell_area(lattice_of(pattern.shape)) * pattern.spacing * pattern.spacing *
                       double(point_count(pattern.shape, pattern.size))),
      max_dimples);
  PatchDivision d;
  d.pattern = pattern;
  d.anchor = anchor;
  const auto range = cell_range(d, area);
  require_count(pattern, 0.25 * (range[1] - range[0] - 3.0) * (range[3] - range[2] - 3.0),
                max_dimples);
  for (int a = range[0]; a <= range[1]; ++a)
    for (int b = range[2]; b <= range[3]; ++b)
      for (bool down : {false, true}) {
        if (down && !traits(pattern.shape).has_inverted) continue;
        const PatchCell cell{a, b, down, 0};
        Polygon outline = outline_in_lattice(pattern, cell);
        for (Vec2& corner : outline) corner = place(d, corner);
        if (overlap(outline, area, 1e-9 * pattern.spacing)) d.cells.push_back(cell);
      }
  require_count(pattern, double(d.cells.size()), max_dimples);
  order_cells(d);
  return d;
}

PatchDivision keep_patches(PatchDivision d, const std::function<bool(const LatticePoint&)>& keep) {
  const PatchPattern& p = d.pattern;
  const std::vector<LatticePoint> points[2] = {
      patch_helix(p.shape, p.size, p.order, false),
      patch_helix(p.shape, p.size, p.order, traits(p.shape).has_inverted)};
  auto unwanted = [&](const PatchCell& cell) {
    const LatticePoint origin = cell_origin(p, cell);
    return std::none_of(points[cell.down].begin(), points[cell.down].end(),
                        [&](const LatticePoint& step) {
                          return keep({origin[0] + step[0], origin[1] + step[1]});
                        });
  };
  d.cells.erase(std::remove_if(d.cells.begin(), d.cells.end(), unwanted), d.cells.end());
  for (PatchCell& cell : d.cells) cell.turn = 0;
  order_cells(d);
  return d;
}

}  // namespace patchmill::patch

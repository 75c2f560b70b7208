// What each hollow of a relief measures; see dimple_marks.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/marks/dimple_marks.h"

#include "patchmill/geometry/angle.h"
#include "patchmill/geometry/error.h"
#include "patchmill/marks/hollows.h"
#include "patchmill/marks/place_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace patchmill::marks {
namespace {

/// Centre of what is low among 5 x 5 cells around (i, j): mean of the places, weighted by how far each is
/// below half of the mean height over `bottom`. In cells from (i, j).
Vec2 low_centre_around(const Relief& relief, double bottom, int i, int j) {
  constexpr int kReach = 2;
  const SurfaceGrid& grid = relief.grid;
  double sum = 0.0, weights = 0.0;
  int count = 0;
  Vec2 centre = Vec2::Zero();
  for (const bool weighing : {false, true}) {
    const double level = 0.5 * sum / std::max(count, 1);
    for (int dj = -kReach; dj <= kReach; ++dj)
      for (int di = -kReach; di <= kReach; ++di) {
        if (i + di < 0 || j + dj < 0 || i + di >= grid.columns || j + dj >= grid.rows) continue;
        const double over = double{relief.at(i + di, j + dj)} - bottom;
        if (!std::isfinite(over)) continue;
        if (!weighing) {
          sum += over;
          ++count;
        } else if (over < level) {
          centre += (level - over) * Vec2(di, dj);
          weights += level - over;
        }
      }
  }
  return weights > 0.0 ? Vec2(centre / weights) : Vec2::Zero();
}

/// Centre of what is low around the lowest cell. For marks that are cut with a moving tool: they have a
/// crease along their bottom, to which no paraboloid fits, and their lowest cell may be some cells along
/// it from their middle: the cells that are looked at follow the centre until they stay.
Vec2 low_centre(const Relief& relief, int i, int j) {
  constexpr int kRounds = 4;
  const double bottom = relief.at(i, j);
  int di = 0, dj = 0;
  Vec2 centre = Vec2::Zero();
  for (int round = 0; round < kRounds; ++round) {
    centre = Vec2(di, dj) + low_centre_around(relief, bottom, i + di, j + dj);
    const int to_i = static_cast<int>(std::lround(centre.x()));
    const int to_j = static_cast<int>(std::lround(centre.y()));
    if (to_i == di && to_j == dj) break;
    di = to_i, dj = to_j;
  }
  return centre;
}

/// How far, in cells, the bottom of a smooth mark may be from the centre of what is low in it.
constexpr double kAgreement = 0.4;

/// Lowest point of a paraboloid through a cell and its neighbours, least squares over 3 x 3 cells:
/// offset in cells and its height. Where there is no such paraboloid, or it does not agree with the
/// centre of what is low, that centre and the cell's height.
void refine(const Relief& relief, std::int64_t cell, Vec2& offset, double& height) {
  offset.setZero();
  height = relief.height[static_cast<std::size_t>(cell)];
  const SurfaceGrid& grid = relief.grid;
  const int i = static_cast<int>(cell % grid.columns), j = static_cast<int>(cell / grid.columns);
  if (i < 1 || j < 1 || i + 1 >= grid.columns || j + 1 >= grid.rows) return;
  double sum = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
  for (int dj = -1; dj <= 1; ++dj)
    for (int di = -1; di <= 1; ++di) {
      const double h = double{relief.at(i + di, j + dj)} - height;
      sum += h, x += di * h, y += dj * h, xx += di * di * h, yy += dj * dj * h, xy += di * dj * h;
    }
  // z = c + bx x + by y + a x² + b y² + d x y over the nine cells
  const double bx = x / 6, by = y / 6, d = xy / 4;
  const double a = xx / 2 - sum / 3, b = yy / 2 - sum / 3;
  const double c = 5 * sum / 9 - (xx + yy) / 3;
  const double det = 4 * a * b - d * d;
  const Vec2 at((d * by - 2 * b * bx) / det, (d * bx - 2 * a * by) / det);
  const Vec2 centre = low_centre(relief, i, j);
  if (!(a > 0.0) || !(det > 0.0) || !((at - centre).norm() <= kAgreement)) {
    offset = centre;
    return;
  }
  offset = at;
  height += c + 0.5 * (bx * at.x() + by * at.y());
}

DimpleMark measure(const Relief& relief, std::int64_t cell) {
  const SurfaceGrid& grid = relief.grid;
  const int i = static_cast<int>(cell % grid.columns), j = static_cast<int>(cell / grid.columns);
  DimpleMark mark;
  Vec2 offset;
  refine(relief, cell, offset, mark.bottom);
  mark.place = grid.plane_point(i, j) + grid.step * offset;
  const Vec3 along = grid.step * (offset.x() * grid.plane.x_axis + offset.y() * grid.plane.y_axis);
  const Vec3 n = base_normal(grid, i, j), d = grid.plane.direction;
  const Vec3 on_base = along - d * (along.dot(n) / d.dot(n));
  mark.point = base_point(grid, i, j) + on_base + mark.bottom * n;
  return mark;
}

}  // namespace

std::vector<DimpleMark> find_dimples(const Relief& relief, const FindOptions& options) {
  require_in_range("LeastDepth", options.least_depth, 0.0, 1e9, "mm");
  const Hollows hollows = label_hollows(relief);
  HollowMerger merger(relief, hollows);
  merger.merge(options.least_depth);
  std::vector<std::int32_t> number(hollows.lowest.size(), kNoHollow);
  std::vector<DimpleMark> marks;
  for (std::size_t k = 0; k < hollows.lowest.size(); ++k) {
    const auto hollow = static_cast<std::int32_t>(k);
    if (merger.root(hollow) != hollow || merger.dropped(hollow)) continue;
    number[k] = static_cast<std::int32_t>(marks.size());
    marks.push_back(measure(relief, hollows.lowest[k]));
    marks.back().depth = merger.depth(hollow) +
                         relief.height[static_cast<std::size_t>(hollows.lowest[k])] -
                         marks.back().bottom;
  }
  std::vector<std::int64_t> cells(marks.size(), 0);
  for (std::int64_t cell = 0; cell < relief.grid.cells(); ++cell) {
    const std::int32_t label = hollows.label[static_cast<std::size_t>(cell)];
    if (label == kNoHollow) continue;
    const std::int32_t mark = number[static_cast<std::size_t>(merger.root(label))];
    if (mark == kNoHollow) continue;
    ++cells[static_cast<std::size_t>(mark)];
    int around = 0;
    for_neighbours(relief.grid, cell, [&](std::int64_t other, bool) {
      around += std::isnan(relief.height[static_cast<std::size_t>(other)]) ? 0 : 1;
    });
    if (around < 8) marks[static_cast<std::size_t>(mark)].at_edge = true;
  }
  for (std::size_t k = 0; k < marks.size(); ++k)
    marks[k].diameter = 2.0 * relief.grid.step * std::sqrt(static_cast<double>(cells[k]) / kPi);
  return marks;
}

double mean_spacing(const std::vector<DimpleMark>& dimples) {
  std::vector<Vec2> places;
  for (const DimpleMark& d : dimples) places.push_back(d.place);
  const PlaceIndex index(places);
  double sum = 0.0;
  for (std::size_t k = 0; k < places.size(); ++k)
    sum += (places[index.nearest(places[k], k)] - places[k]).norm();
  return places.size() < 2 ? std::numeric_limits<double>::quiet_NaN()
                           : sum / static_cast<double>(places.size());
}

}  // namespace patchmill::marks

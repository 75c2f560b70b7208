// A k-d tree over surface points; see point_distance.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/collision/point_distance.h"

#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace patchmill::collision {
namespace {

constexpr std::size_t kLeaf = 8;

/// The points in the order of an implicit tree: the median of each range splits it, along an axis
/// that changes with the depth.
class PointTree {
 public:
  explicit PointTree(std::vector<patch::SurfacePoint> points) : points_(std::move(points)) {
    split(0, points_.size(), 0);
  }

  const patch::SurfacePoint& nearest(const Vec3& at) const {
    std::size_t best = 0;
    double square = std::numeric_limits<double>::infinity();
    look(0, points_.size(), 0, at, best, square);
    return points_[best];
  }

 private:
  void split(std::size_t from, std::size_t to, int axis) {
    if (to - from <= kLeaf) return;
    const std::size_t middle = (from + to) / 2;
    const auto begin = points_.begin();
    std::nth_element(begin + from, begin + middle, begin + to,
                     [axis](const patch::SurfacePoint& a, const patch::SurfacePoint& b) {
                       return a.position[axis] < b.position[axis];
                     });
    split(from, middle, (axis + 1) % 3);
    split(middle + 1, to, (axis + 1) % 3);
  }

  void take(std::size_t k, const Vec3& at, std::size_t& best, double& square) const {
    const double s = (points_[k].position - at).squaredNorm();
    if (s > square || (s == square && k > best)) return;
    square = s;
    best = k;
  }

  void look(std::size_t from, std::size_t to, int axis, const Vec3& at, std::size_t& best,
            double& square) const {
    if (to - from <= kLeaf) {
      for (std::size_t k = from; k < to; ++k) take(k, at, best, square);
      return;
    }
    const std::size_t middle = (from + to) / 2;
    take(middle, at, best, square);
    const double beyond = at[axis] - points_[middle].position[axis];
    const int next = (axis + 1) % 3;
    if (beyond < 0.0) {
      look(from, middle, next, at, best, square);
      if (beyond * beyond <= square) look(middle + 1, to, next, at, best, square);
    } else {
      look(middle + 1, to, next, at, best, square);
      if (beyond * beyond <= square) look(from, middle, next, at, best, square);
    }
  }

  std::vector<patch::SurfacePoint> points_;
};

}  // namespace

PartDistance distance_from_points(std::vector<patch::SurfacePoint> points, double spacing,
                                  double reach) {
  require_positive("Spacing", spacing, "mm");
  if (points.empty()) return {};
  const auto tree = std::make_shared<const PointTree>(std::move(points));
  return [tree, spacing, reach](const Vec3& at) {
    const patch::SurfacePoint& p = tree->nearest(at);
    const Vec3 from = at - p.position;
    const double away = from.norm(), height = from.dot(p.normal);
    if (!(away <= reach)) return std::numeric_limits<double>::quiet_NaN();
    const double size = std::max(std::abs(height), away - 0.5 * spacing);
    return height < 0.0 ? -size : size;
  };
}

std::vector<patch::SurfacePoint> surface_points(const marks::Relief& relief, int stride) {
  std::vector<patch::SurfacePoint> points;
  for (int j = 0; j < relief.grid.rows; j += stride)
    for (int i = 0; i < relief.grid.columns; i += stride)
      if (std::isfinite(relief.at(i, j)))
        points.push_back(
            {marks::relief_point(relief, i, j), marks::base_normal(relief.grid, i, j)});
  return points;
}

}  // namespace patchmill::collision

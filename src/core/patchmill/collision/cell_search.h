// The least distance of a frustum from a part of which only the distance of points is known: the frustum is cut into
// cells, and cells that cannot hold the nearest point are left out (branch and bound).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/collision/clearance.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace patchmill::collision {

/// A cell of a frustum in its own coordinates.
struct FrustumCell {
  double low[3], high[3];  // height, share of the radius, azimuth
};

/// The search for the nearest place of one section.
class CellSearch {
 public:
  /// The section and the distance must outlive it; `resolution` [mm, > 0].
  CellSearch(const ToolSection& section, const PartDistance& distance, double resolution)
      : section_(section), distance_(distance), resolution_(resolution) {}

  /// Least distance of the frustum. Where it is above `limit` a lower bound will do: above
  /// `enough`, or half of what there is over the limit. Below `limit` it is found to a fiftieth of
  /// the shortfall; never finer than the resolution. NaN distance if it is unknown anywhere that
  /// matters.
  SectionDistance find(const ToolPose& pose, double limit, double enough) {
    pose_ = pose;
    x_ = any_normal_to(pose.axis);
    y_ = pose.axis.cross(x_);
    best_ = {};
    queue_ = {};
    push({{section_.from, 0.0, 0.0}, {section_.to, 1.0, 2.0 * kPi}});
    while (!queue_.empty() && !std::isnan(best_.distance)) {
      const Entry entry = queue_.top();
      const double over = best_.distance - limit;
      const double fine = std::max(resolution_, over < 0.0 ? -0.02 * over : 0.5 * over);
      if (entry.bound > enough || best_.distance - entry.bound <= fine) {
        if (entry.bound > limit) return {entry.bound, best_.place};
        break;
      }
      queue_.pop();
      halve(entry.cell);
    }
    return best_;
  }

 private:
  struct Entry {
    double bound;
    FrustumCell cell;
    bool operator<(const Entry& other) const { return bound > other.bound; }
  };

  double radius_at(double height) const {
    const double share = (height - section_.from) / (section_.to - section_.from);
    return section_.radius_from + share * (section_.radius_to - section_.radius_from);
  }

  /// Radius of a ball around the cell's middle that holds the cell.
  double size(const FrustumCell& c) const {
    const double r = std::max(radius_at(c.low[0]), radius_at(c.high[0])) * c.high[1];
    const double dr =
        0.5 * (c.high[1] - c.low[1]) * std::max(section_.radius_from, section_.radius_to) +
        0.5 * std::abs(radius_at(c.high[0]) - radius_at(c.low[0]));
    const double round = std::min(0.5 * (c.high[2] - c.low[2]), 2.0) * r;
    return std::hypot(0.5 * (c.high[0] - c.low[0]), std::min(dr + round, 2.0 * r));
  }

  void push(const FrustumCell& c) {
    const double height = 0.5 * (c.low[0] + c.high[0]), azimuth = 0.5 * (c.low[2] + c.high[2]);
    const double r = 0.5 * (c.low[1] + c.high[1]) * radius_at(height);
    const Vec3 place =
        pose_.tip + height * pose_.axis + r * (std::cos(azimuth) * x_ + std::sin(azimuth) * y_);
    const double d = distance_(place);
    if (d < best_.distance || std::isnan(d)) best_ = {d, place};
    queue_.push({d - size(c), c});
  }

  /// Halves a cell where it is longest.
  void halve(const FrustumCell& cell) {
    const double r = std::max(radius_at(cell.low[0]), radius_at(cell.high[0]));
    const double length[3] = {cell.high[0] - cell.low[0], (cell.high[1] - cell.low[1]) * r,
                              (cell.high[2] - cell.low[2]) * r * cell.high[1]};
    const auto axis = std::max_element(length, length + 3) - length;
    const double middle = 0.5 * (cell.low[axis] + cell.high[axis]);
    FrustumCell lower = cell, upper = cell;
    lower.high[axis] = upper.low[axis] = middle;
    push(lower);
    push(upper);
  }

  const ToolSection& section_;
  const PartDistance& distance_;
  double resolution_;
  ToolPose pose_;
  Vec3 x_, y_;
  SectionDistance best_;
  std::priority_queue<Entry> queue_;
};

}  // namespace patchmill::collision

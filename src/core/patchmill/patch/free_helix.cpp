// The continuous helix of a regular polygon; see free_helix.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/free_helix.h"

#include "patchmill/geometry/angle.h"
#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace patchmill::patch {

double apothem(const FreePatch& patch) {
  return 0.5 * patch.side / std::tan(kPi / patch.corners);
}

void require_valid(const FreePatch& p, double max_marks) {
  require_in_range("Corners", p.corners, 3, 360, "corners");
  require_positive("PatchSide", p.side, "mm");
  require_positive("CrossFeed", p.cross_feed, "mm");
  require_positive("FeedPerTooth", p.feed_per_tooth, "mm");
  const double laps = apothem(p) / p.cross_feed;
  const double marks = (laps + 1.0) * p.corners * p.side / p.feed_per_tooth;
  if (laps * p.corners > max_marks)
    throw InputError("CrossFeed", fmt::format("{} mm", p.cross_feed),
                     fmt::format("a patch of side {} mm would have {:.0f} laps: choose a larger "
                                 "cross-feed.",
                                 p.side, laps));
  if (marks > 2.0 * max_marks)
    throw InputError("FeedPerTooth", fmt::format("{} mm", p.feed_per_tooth),
                     fmt::format("a patch would have {:.0f} marks: choose a larger feed per tooth.",
                                 0.5 * marks));
}

namespace {

void turn_round(std::vector<HelixSide>& path) {
  const double length = path_length(path);
  for (HelixSide& side : path) {
    side.at = length - side.at - (side.end - side.start).norm();
    std::swap(side.start, side.end);
  }
  std::reverse(path.begin(), path.end());
}

}  // namespace

std::vector<HelixSide> helix_path(const FreePatch& patch, HelixOrder order) {
  require_valid(patch);
  const int m = patch.corners;
  const double phi = 2.0 * kPi / m, cos_phi = std::cos(phi), sin_phi = std::sin(phi);
  const double outer = apothem(patch), least = 1e-9 * std::min(patch.side, patch.cross_feed);
  std::vector<HelixSide> path;
  double at = 0.0;
  for (int n = 0;; ++n) {
    const int lap = n / m, sector = n % m;
    // distances from the centre of this line and of those before and after; the path's first
    // corner is the outline's own
    const double p = outer - lap * patch.cross_feed;
    const double before = sector > 0 || lap == 0 ? p : p + patch.cross_feed;
    const double after = sector < m - 1 ? p : p - patch.cross_feed;
    const double from = (p * cos_phi - before) / sin_phi, to = (after - p * cos_phi) / sin_phi;
    if (to - from < -least) break;
    if (to - from <= least) continue;  // where the centre is met exactly
    const double angle = -0.5 * kPi + sector * phi;
    const Vec2 outward(std::cos(angle), std::sin(angle)), along(-outward.y(), outward.x());
    path.push_back({p * outward + from * along, p * outward + to * along, at, lap, sector});
    at += to - from;
  }
  if (order == HelixOrder::Outward) turn_round(path);
  return path;
}

double path_length(const std::vector<HelixSide>& path) {
  return path.empty() ? 0.0 : path.back().at + (path.back().end - path.back().start).norm();
}

std::vector<HelixMark> helix_marks(const std::vector<HelixSide>& path, double feed_per_tooth) {
  require_positive("FeedPerTooth", feed_per_tooth, "mm");
  std::vector<HelixMark> marks;
  const double length = path_length(path), slack = 1e-9 * feed_per_tooth;
  std::size_t side = 0;
  for (std::int64_t n = 0;; ++n) {
    const double s = static_cast<double>(n) * feed_per_tooth;
    if (s > length + slack) break;
    while (side + 1 < path.size() && s >= path[side + 1].at - slack) ++side;
    const HelixSide& on = path[side];
    const Vec2 along = (on.end - on.start).normalized();
    marks.push_back({on.start + (s - on.at) * along, static_cast<int>(side)});
  }
  return marks;
}

}  // namespace patchmill::patch

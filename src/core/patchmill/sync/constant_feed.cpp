// Constant-feed polygons and links; see constant_feed.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/constant_feed.h"

#include "patchmill/geometry/stop.h"
#include "patchmill/sync/fit_length.h"
#include "patchmill/sync/path_account.h"
#include "patchmill/sync/planned_dimples.h"

#include <algorithm>

#include <fmt/format.h>

namespace patchmill::sync {
namespace {

constexpr double kGoodFit = 2e-5;  // mm of length: 0.017 degrees at the paper's F and S

// The next place of the helix; over places left out the tool goes at a safe height.
bool follows(const PlannedDimple& a, const PlannedDimple& b) {
  return a.patch == b.patch && b.number == a.number + 1;
}

void require_valid(const ConstantFeed& rule, const Tool& tool, const Spindle& spindle) {
  require_positive("Feed", rule.feed * 60.0, "mm/min");
  require_turning_tool(tool, spindle);
  require_valid(rule.phase, tool.flutes);
  require_heights(rule.safe_height, rule.clearance_height);
}

void step(PathAccount& build, const PlannedDimple& a, const PlannedDimple& b, double turns,
          double feed, double turns_per_mm, const Decimals& decimals) {
  const double length = build.length_for(turns), distance = (b.tip - a.tip).norm();
  if (length < distance)
    throw InputError(
        "Feed", fmt::format("{:.3f} mm/min", feed * 60.0),
        fmt::format(
            "{:.3f} turns take the tool {:.4f} mm, and dimple {} is {:.4f} mm away: give at "
            "least {:.3f} mm/min, or more extra turns.",
            turns, turns / turns_per_mm, b.number, distance, 60.0 * feed * distance / length));
  const Vec3 ideal = apex(a.tip, b.tip, a.normal + b.normal, length);
  build.require_turns(turns);
  build.timed(fit_corner(a.tip, ideal, b.tip, length, decimals, kGoodFit), MoveKind::Cut);
  build.timed(b.tip, MoveKind::Cut, b.number);
}

}  // namespace

double posted_feed(double feed, const Decimals& decimals) {
  require_positive("Feed", feed * 60.0, "mm/min");
  return decimals.round(feed * 60.0) / 60.0;
}

Vec3 apex(const Vec3& a, const Vec3& b, const Vec3& up, double length) {
  const Vec3 across = b - a;
  const double d2 = across.squaredNorm();
  const Vec3 lift = d2 > 0.0 ? Vec3(up - up.dot(across) / d2 * across) : up;
  const double h = 0.5 * std::sqrt(std::max(0.0, length * length - d2));
  return a + 0.5 * across + h * lift.normalized();
}

ToolPath constant_feed_path(const patch::Dimples& dimples, const Tool& tool, const Spindle& spindle,
                            const ConstantFeed& rule, const Decimals& decimals) {
  require_valid(rule, tool, spindle);
  const std::vector<PlannedDimple> planned =
      planned_dimples(dimples, tool.radius, rule.phase, decimals);
  if (planned.empty())
    throw InputError("Dimples", "0",
                     "every lattice point was left out: see the counts by reason, and change the "
                     "faces, the limits or the tool axis.");
  const double feed = posted_feed(rule.feed, decimals);
  require_positive("Feed", feed * 60.0, "mm/min after rounding");
  const double turns_per_mm = spindle.speed / feed;
  const double period = phase_period(tool.flutes, rule.phase.flutes).turns();
  require_below(rule.safe_height, planned, 0.0);

  ToolPath path{tool, spindle, {}, {}};
  std::size_t links = 0;  // of three moves each; others have two
  for (std::size_t i = 1; i < planned.size(); ++i) links += !follows(planned[i - 1], planned[i]);
  path.moves.reserve(2 * planned.size() + links + 16);
  PathAccount build(path, turns_per_mm, rule.safe_height);
  build.begin(planned.front().tip, planned.front().number, rule.clearance_height, decimals);
  for (std::size_t i = 1; i < planned.size(); ++i) {
    stop_point();
    const PlannedDimple &a = planned[i - 1], &b = planned[i];
    const double turns = spindle_advance(a.azimuth, b.azimuth, rule.phase, tool, spindle).turns();
    if (follows(a, b))
      step(build, a, b, turns, feed, turns_per_mm, decimals);
    else
      build.link(b.tip, b.number, turns, period, decimals);
  }
  build.end(rule.clearance_height, decimals);
  return path;
}

}  // namespace patchmill::sync

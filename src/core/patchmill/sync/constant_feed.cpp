// Constant-feed polygons and links; see constant_feed.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/constant_feed.h"

#include "patchmill/geometry/large_vector.h"
#include "patchmill/geometry/stop.h"
#include "patchmill/sync/fit_length.h"
#include "patchmill/sync/path_account.h"
#include "patchmill/sync/planned_dimples.h"

#include <algorithm>
#include <cmath>
#include <optional>

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

// Does what can be done ahead for the corners of a batch's steps.
void look_ahead(PlannedBatch& batch, double turns_per_mm, const Decimals& decimals) {
  batch.corners.reserve(batch.planned.size());
  const PlannedDimple* a = batch.before ? &*batch.before : nullptr;
  for (std::size_t i = 0; i < batch.planned.size(); ++i) {
    const PlannedDimple& b = batch.planned[i];
    const double length = batch.turns[i] / turns_per_mm;
    if (a && follows(*a, b))
      batch.corners.emplace_back(a->tip, b.tip, a->normal + b.normal, length, decimals);
    else
      batch.corners.emplace_back();
    a = &b;
  }
}

// The path as it grows: each step makes up for the rounding of those before it, so they are made one by one.
class Polygons {
 public:
  Polygons(ToolPath& path, const ConstantFeed& rule, double turns_per_mm, double feed,
           const Decimals& decimals)
      : build_(path, turns_per_mm, rule.safe_height),
        rule_(rule),
        turns_per_mm_(turns_per_mm),
        feed_(feed),
        period_(phase_period(path.tool.flutes, rule.phase.flutes).turns()),
        decimals_(decimals) {}

  void add(const PlannedBatch& batch) {
    stop_point();
    for (std::size_t i = 0; i < batch.planned.size(); ++i) {
      const PlannedDimple& b = batch.planned[i];
      if (!begun_)
        build_.begin(b.tip, b.number, rule_.clearance_height, decimals_);
      else if (follows(last_, b))
        step(last_, b, batch, i);
      else
        build_.link(b.tip, b.number, batch.turns[i], period_, decimals_);
      begun_ = true;
      last_ = b;
    }
  }
  void end() {
    if (short_) refuse_short();
    build_.end(rule_.clearance_height, decimals_);
  }

 private:
  static constexpr double kSpared = 1e-3;  // of the way: what rounding may take away

  // The first dimple that is further away than the tool gets.
  struct Short {
    double turns, distance;
    std::int64_t number;
  };

  /// With the extra turns at which every dimple is in reach.
  [[noreturn]] void refuse_short() const {
    const double extra =
        rule_.phase.extra_turns + std::ceil(std::max(missing_, 0.0) / period_) * period_;
    throw InputError(
        "Feed", fmt::format("{:.3f} mm/min", feed_ * 60.0),
        fmt::format("{:.3f} turns take the tool {:.4f} mm, and dimple {} is {:.4f} mm away: give "
                    "at least {:g} ExtraTurns.",
                    short_->turns, short_->turns / turns_per_mm_, short_->number, short_->distance,
                    extra));
  }

  void step(const PlannedDimple& a, const PlannedDimple& b, const PlannedBatch& batch,
            std::size_t i) {
    const double turns = batch.turns[i], length = build_.length_for(turns);
    if (!short_)
      if (const auto corner = batch.corners[i].fit(length, decimals_, kGoodFit))
        return go(turns, *corner, b);
    const double distance = (b.tip - a.tip).norm();
    if (length < distance && !short_) short_ = Short{turns, distance, b.number};
    if (short_) {  // what follows is looked at for what all of them need
      const double needed = distance * turns_per_mm_ * (1.0 + kSpared);
      missing_ = std::max(missing_, needed - turns);
      return;
    }
    const Vec3 ideal = apex(a.tip, b.tip, a.normal + b.normal, length);
    go(turns, fit_corner(a.tip, ideal, b.tip, length, decimals_, kGoodFit), b);
  }
  void go(double turns, const Vec3& corner, const PlannedDimple& b) {
    build_.require_turns(turns);
    build_.timed(corner, MoveKind::Cut);
    build_.timed(b.tip, MoveKind::Cut, b.number);
  }

  PathAccount build_;
  const ConstantFeed& rule_;
  double turns_per_mm_, feed_, period_;
  const Decimals& decimals_;
  PlannedDimple last_{};
  bool begun_ = false;
  std::optional<Short> short_;
  double missing_ = 0.0;
};

}  // namespace

double posted_feed(double feed, const Decimals& decimals) {
  require_positive("Feed", feed * 60.0, "mm/min");
  return decimals.round(feed * 60.0) / 60.0;
}

Vec3 apex(const Vec3& a, const Vec3& b, const Vec3& up, double length) {
  return Apexes(a, b, up).at(length);
}

ToolPath constant_feed_path(const patch::Dimples& dimples, const Tool& tool, const Spindle& spindle,
                            const ConstantFeed& rule, const Decimals& decimals) {
  require_valid(rule, tool, spindle);
  const PlannedExtent extent = planned_extent(dimples, tool.radius, decimals, rule.safe_height);
  if (extent.dimples == 0)
    throw InputError("Dimples", "0",
                     "every lattice point was left out: see the counts by reason, and change the "
                     "faces, the limits or the tool axis.");
  const double feed = posted_feed(rule.feed, decimals);
  require_positive("Feed", feed * 60.0, "mm/min after rounding");
  require_below(rule.safe_height, extent);

  ToolPath path{tool, spindle, {}, {}};
  path.moves.reserve(2 * extent.dimples + extent.gaps + 16);  // a link has three moves, others two
  make_large_pages(path.moves.data(), path.moves.capacity() * sizeof(Move));
  Polygons polygons(path, rule, spindle.speed / feed, feed, decimals);
  in_batches(
      dimples, tool, spindle, rule.phase, decimals,
      [&](PlannedBatch& batch) { look_ahead(batch, spindle.speed / feed, decimals); },
      [&](const PlannedBatch& batch) { polygons.add(batch); });
  polygons.end();
  return path;
}

}  // namespace patchmill::sync

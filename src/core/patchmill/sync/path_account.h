// PathAccount: appends timed moves at a constant feed and keeps the account of turns, between what the
// phase asks for and what the rounded path has really taken, so that no error is carried on.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/error.h"
#include "patchmill/path/tool_path.h"
#include "patchmill/sync/link.h"

#include <cmath>

#include <fmt/format.h>

namespace patchmill::sync {

/// A path as it grows, and the turns of the spindle that are still to be spent.
class PathAccount {
 public:
  /// Moves are added to `path`, which must outlive it; `turns_per_mm` > 0, `safe_height` [mm].
  PathAccount(ToolPath& path, double turns_per_mm, double safe_height)
      : path_(path), turns_per_mm_(turns_per_mm), safe_height_(safe_height) {}

  /// Where the tool is [mm].
  const Vec3& at() const { return at_; }
  /// Length that the next step must have so that no error is carried on [mm].
  double length_for(double turns) const { return (required_ + turns) / turns_per_mm_; }
  /// Adds turns that the next moves have to spend.
  void require_turns(double turns) { required_ += turns; }
  /// Takes whole periods off the turns still to be spent.
  void drop_whole_periods(double period) { required_ -= std::round(required_ / period) * period; }

  /// A move without a time, to `tip` [mm].
  void rapid(const Vec3& tip) {
    path_.moves.push_back({pose(tip), kUnknownTurns, kNoDimple, MoveKind::Rapid});
    at_ = tip;
  }
  /// Errors: InputError naming SafeHeight if a cut goes above it.
  void timed(const Vec3& tip, MoveKind kind, std::int32_t dimple = kNoDimple) {
    if (kind == MoveKind::Cut && tip.z() > safe_height_)
      throw InputError("SafeHeight", fmt::format("{} mm", safe_height_),
                       fmt::format("the tool reaches Z {:.3f} mm between dimples: give a greater "
                                   "safe height.",
                                   tip.z()));
    const double turns = (tip - at_).norm() * turns_per_mm_;
    path_.moves.push_back({pose(tip), turns, dimple, kind});
    required_ -= turns;
    at_ = tip;
  }
  /// Rapids and a plunge to the first dimple, which is phase zero; from `clearance` over it.
  void begin(const Vec3& first, std::int32_t dimple, double clearance, const Decimals& decimals) {
    const double safe = decimals.round(safe_height_);
    const Vec3 above(first.x(), first.y(), decimals.round(clearance));
    path_.start = {above, Vec3::UnitZ()};
    rapid(above);
    rapid({first.x(), first.y(), safe});
    timed(first, MoveKind::Link, dimple);
    required_ = 0.0;
  }
  /// A link (Eq. 3) to a dimple that wants so many turns but for whole periods.
  void link(const Vec3& to, std::int32_t dimple, double turns, double period,
            const Decimals& decimals) {
    const LinkRequest request{at_, to, safe_height_, length_for(turns), period / turns_per_mm_};
    const auto corners = link_corners(request, decimals);
    require_turns(turns);
    timed(corners[0], MoveKind::Link);
    timed(corners[1], MoveKind::Link);
    timed(to, MoveKind::Link, dimple);
    drop_whole_periods(period);
  }
  /// Up to the safe height and, as a rapid, to the clearance height.
  void end(double clearance, const Decimals& decimals) {
    const Vec3 last = at_;
    timed({last.x(), last.y(), decimals.round(safe_height_)}, MoveKind::Link);
    rapid({last.x(), last.y(), decimals.round(clearance)});
  }

 private:
  static ToolPose pose(const Vec3& tip) { return {tip, Vec3::UnitZ()}; }
  ToolPath& path_;
  double turns_per_mm_, safe_height_;
  Vec3 at_ = Vec3::Zero();
  double required_ = 0.0;
};

}  // namespace patchmill::sync

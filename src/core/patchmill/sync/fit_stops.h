// Fitting a feed-paced path to a machine that stops at every vertex. The paper's zigzag (Xu & Sasahara
// 2016, section 3.2) gives each dimple the time L / F; the stops take F / a more for each leg, and then
// whole interpolation periods. With the machine's acceleration known the detours between dimples are
// made shorter instead, so that each dimple comes within half a period of its time, and what is left
// is carried into the next one. Deviation: the paper knows no acceleration. It is open loop all the
// same: 1 % of spindle speed is lost in a few dimples.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/machine/motion_model.h"
#include "patchmill/path/rounding.h"
#include "patchmill/path/tool_path.h"

namespace patchmill::sync {

/// A path whose legs are fitted to the machine's stops.
struct StopFit {
  ToolPath path;             ///< `turns` are length / feed, as posted: predict() knows the stops
  double largest_off = 0.0;  ///< from a dimple's time, after whole periods [s]
  std::int64_t added = 0;    ///< phase periods added because a detour cannot be that short
};

/// `path`: feed-paced, stopping everywhere (tolerances and `model.tolerance` 0), with vertices between
/// its dimples: each group of them is drawn towards or away from the chord of its two dimples, links
/// only away. `feed` is every timed move's feed [mm/s]; `period`: of the phase [turns]. The posted feed
/// does not change. Errors: InputError naming PathTolerance (the model rounds corners), MaxJerk
/// (finite), Pace (a locked move), Feed (not positive, or so small that the path takes over 1e8 interpolation
/// periods), or the model's own.
StopFit fit_to_stops(const ToolPath& path, const machine::MotionModel& model, double feed,
                     double period, const Decimals& decimals);

}  // namespace patchmill::sync

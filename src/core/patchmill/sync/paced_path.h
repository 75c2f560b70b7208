// Paced paths: the tool goes straight from dimple to dimple and a tooth passes at each. Two ways
// to keep the pace,
//     feed per move   F_k = d_k / T_k
//     spindle-locked  K_k = d_k / Lambda_k   (mm per turn, G33: the encoder keeps the phase)
// T_k = Lambda_k / (2 pi S). In a row Lambda is nearest to one tooth, the fewest turns that there
// can be; anywhere else the tool leaves the surface and comes back whole teeth later
// (turnaround.h), so that no second tooth marks. Deviation: Xu & Sasahara 2016 keep a constant feed
// and lengthen the way (section 3.2) to 5 to 6 turns per dimple.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/machine/motion_model.h"
#include "patchmill/path/rounding.h"
#include "patchmill/sync/phase_rule.h"

namespace patchmill::sync {

/// What paced paths are made by.
struct PacedRule {
  Pace pace = Pace::SpindleLocked;
  PhaseRule phase;          ///< extra_turns must be 0; flutes must be Any
  bool turnarounds = true;  ///< false: straight on over every corner inside a patch
  double lift = 0.10;  ///< clearance between rows along the normal: above ridges and stock [mm]
  double seed = 2.0;   ///< way in the air before the first dimple that takes up the lock [mm]
  double safe_height = 0.0;       ///< detours and links travel at or above this Z of the tip [mm]
  double clearance_height = 0.0;  ///< rapids before the first and after the last dimple [mm]
  /// By dimple number: what the rotary axes need to get to its posture from that of the dimple before,
  /// from rest to rest [s]; 0: they stand. A row ends where they turn: a controller that rounds corners
  /// of three axes stops at those of five. Empty: no rotary axes.
  std::vector<double> turning = {};
  bool rows = false;  ///< patches are rows (row_order.h): no link over the safe height between them
                      ///< unless the way there needs one
};

/// A path that keeps the phase by the times of its moves.
struct PacedPath {
  ToolPath path;
  std::int64_t turnarounds = 0;  ///< corners, gaps and links
  std::vector<std::size_t>
      arrivals;                ///< dimples, counted in milling order, that each of them ends on
  double row_tolerance = 0.0;  ///< corner rounding in the rows [mm]
  double clearance =
      0.0;  ///< least height of the ball over the surface when a tooth passes between
            ///< rows [mm]; less than the ridges' height means marks nobody asked for
};

/// The path of a fixed vertical tool over all Cut dimples in their order. Positions lie on
/// `decimals`; `turns` are what each move takes on a machine that can follow. Errors: InputError
/// naming SpindleLock (the model's controller cannot), MaxVelocity (one tooth per dimple is too
/// fast for an axis), ExtraTurns, Flutes, Lift, Turning (0 .. 1e6 s), ToolAxis (a wrong number), SafeHeight,
/// ClearanceHeight, Dimples, or the model's own.
PacedPath paced_path(const patch::Dimples& dimples, const Tool& tool, const Spindle& spindle,
                     const PacedRule& rule, const machine::MotionModel& model,
                     const Decimals& decimals);

}  // namespace patchmill::sync

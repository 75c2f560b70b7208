// With which corner rounding a row's kink at a dimple is passed at speed. A controller runs over a small kink as it
// is, and rounds a larger one if the tolerance gives it an arc long and wide enough. But the coarser the tolerance the
// faster is the arc that it plans, and the sooner it leaves out the straight between two of them, and the dimple with
// it. So every kink has tolerances of its own (corner_blend.h).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/machine/corner_blend.h"

#include <optional>

namespace patchmill::sync {

constexpr double kCoarsestRow = 5e-4;  ///< that a row may have on a dimple [mm]

/// Whether the controller passes the corner at `speed` [mm/s], with headroom for a lock to catch up, and leaves no
/// straight out.
bool passes(const machine::CornerSide& before, const machine::CornerSide& after, double tolerance,
            double speed, const machine::MotionModel& model);

/// A tolerance that passes the corner, in whole millionths [mm]: `tolerance` if that does, else the finest found;
/// nothing if none does.
std::optional<double> rounding_for(const machine::CornerSide& before,
                                   const machine::CornerSide& after, double tolerance, double speed,
                                   const machine::MotionModel& model);

/// Gives the moves that end on dimples the corner rounding with which the tool goes on at speed, as seldom another
/// one as can be; returns the coarsest [mm]. `rate`: of the spindle [turns/s].
double round_rows(ToolPath& path, double rate, const machine::MotionModel& model);

}  // namespace patchmill::sync

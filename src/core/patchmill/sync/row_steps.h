// The steps of a paced path from dimple to dimple, and which of them the tool goes straight on along: those in which
// one tooth passes and that the machine can follow. At all others it leaves the surface and comes back whole teeth
// later (turnaround.h): at corners, over missing dimples, where rotary axes turn, where a step would be too fast for an
// axis, and where the contact azimuth runs away because normal and tool nearly meet, so that neighbouring steps would
// need speeds too unlike for the machine to change between them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/sync/paced_path.h"
#include "patchmill/sync/planned_dimples.h"

namespace patchmill::sync {

/// From a dimple to the next one.
struct RowStep {
  Vec3 direction;
  double length, turns;   ///< turns: if it is in a row
  bool near = false;      ///< one step of the lattice, in one patch if links part them
  bool possible = false;  ///< near, and not too fast for an axis
  bool turning = false;   ///< a rotary axis turns meanwhile
  bool joined = false;    ///< it is: the tool goes straight on
  /// Length for each turn of the spindle [mm].
  double pitch() const { return length / turns; }
};

/// The steps of all rows.
struct RowSteps {
  std::vector<RowStep> steps;  ///< one less than dimples
  double fastest = 0.0;        ///< speed in a possible step [mm/s]; of the first if none is
  double mean = 0.0;           ///< length of a possible step [mm]; of the first if none is
  double shortest = 0.0;       ///< of all steps [mm]
};

/// Errors: InputError naming Spacing (two dimples at one place), MaxVelocity (no step is slow enough for the axes).
RowSteps row_steps(const patch::Dimples& dimples, const std::vector<PlannedDimple>& planned,
                   const PacedRule& rule, const Tool& tool, const Spindle& spindle,
                   const machine::MotionModel& model);

}  // namespace patchmill::sync

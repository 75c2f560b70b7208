// How well a path keeps the phase, measured from the path alone: spindle turns counted along its
// moves against the contact azimuth that each dimple wants. Works on a planned path and on one read
// back from posted G-code.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/path/tool_path.h"

#include <vector>

namespace patchmill::sync {

/// By how much the spindle is off at a dimple.
struct PhaseError {
  std::int32_t dimple = kNoDimple;
  Angle error;         ///< spindle - wanted, in [-M/2, M/2), from the run's first dimple on
  double turns = 0.0;  ///< spindle turns since the run's first dimple
  std::int32_t run =
      0;  ///< moves of unknown duration (rapids) begin a new run with a phase of its own
};

/// One entry per dimple of the path, in order. `wanted`: see wanted_phases; `period`: M.
/// The first dimple of each run has error 0 by definition: the start phase is the machine's.
/// Errors: InputError naming Dimple if a number is out of range or its wanted phase is NaN.
std::vector<PhaseError> phase_errors(const ToolPath& path, const std::vector<Angle>& wanted,
                                     Angle period);

/// Errors of a path in numbers.
struct PhaseErrorSummary {
  Angle largest;  ///< by magnitude, >= 0
  Angle rms;
  /// Slope of the error over dimple number, least squares [rad per dimple]: a path that carries its
  /// rounding on has none.
  double drift_per_dimple = 0.0;
  std::int32_t runs = 0;
};
/// Of no errors: all zero.
PhaseErrorSummary summary(const std::vector<PhaseError>& errors);

}  // namespace patchmill::sync

// Whether a machine can hold a plan, said before anything is posted: the phase at each dimple as
// the motion model predicts it, and the spindle speed up to which the plan would hold. A slower
// spindle asks for slower moves, and an acceleration a costs v / a of each stop.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/machine/predict_motion.h"
#include "patchmill/sync/phase_error.h"

#include <functional>

namespace patchmill::sync {

/// The phase that a machine would make of a path.
struct PredictedPhase {
  bool known = false;
  std::string reason;  ///< why not
  std::vector<PhaseError>
      errors;  ///< one for each dimple; the runs' constant offsets are taken away
  Angle rms, largest;
};

/// Spindle angle when the tool passes each dimple, against `wanted` (see wanted_phases) modulo
/// `period`. The start phase is one unknown constant for the whole path (Xu & Sasahara 2016,
/// section 3.3): its best value is taken away. Errors: as predict; InputError naming Dimple as
/// phase_errors.
PredictedPhase predicted_phase(const ToolPath& path, const machine::MotionModel& model,
                               const std::vector<Angle>& wanted, Angle period,
                               double speed_ratio = 1.0);

/// What counts as holding the phase.
struct PhaseLimits {
  Angle rms = Angle::degrees(3.0);
  Angle largest = Angle::degrees(9.0);  ///< 9 of 180 degrees: a twentieth of a dimple
};

enum class Holding : std::uint8_t {
  Holds,      ///< at the planned spindle speed
  HoldsUpTo,  ///< only at a lower one
  Cannot,     ///< at none that was tried
  Unknown     ///< the model cannot say
};

/// Whether a machine can hold a plan.
struct Verdict {
  Holding holding = Holding::Unknown;
  double speed = 0.0;    ///< up to which it holds [revolutions per second]
  Angle rms, largest;    ///< at the planned speed
  std::string sentence;  ///< for the user
};

/// `plan` makes the path for a spindle; it may throw InputError, which counts as not holding at
/// that speed (and is the sentence if it does so at all of them). Speeds down to a hundredth are
/// tried, and from the first that holds up in steps of 3 % until one does not. `slack`: the spindle's true speed may
/// be off by this share either way. `slower`: false where it is enough to know whether the planned speed holds.
Verdict judge(const std::function<ToolPath(const Spindle&)>& plan, const Spindle& spindle,
              const machine::MotionModel& model, const std::vector<Angle>& wanted, Angle period,
              const PhaseLimits& limits = {}, double slack = 0.0, bool slower = true);

}  // namespace patchmill::sync

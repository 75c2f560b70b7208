// The start phase: where the flutes stand when a program's first dimple comes (Xu & Sasahara 2016,
// section 3.3). Nobody knows it, so one patch is milled in which every dimple is asked for a step,
// 1 degree, later than the one before. Over 360/N dimples all phases occur, and at one of them the
// unknown phase x and the steps cancel: that dimple is cut at its place and full depth. Its number
// gives x, which is stored with the machine and taken off all later paths.
//
// x is the machine's and the tool's only if it is counted from the spindle's index, at which a lock begins. A path
// has a start phase of its own beside it: the turns from there to its first dimple, those that the axes lose in
// getting to speed, and the azimuth of that dimple. It is known, and taken off as well.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/machine/motion_model.h"
#include "patchmill/path/rounding.h"
#include "patchmill/path/tool_path.h"
#include "patchmill/sync/phase_rule.h"

namespace patchmill::sync {

/// Points along the side of the smallest square patch on which every phase occurs once and `spare`
/// times more: side² >= (1 + spare) period / step. Errors: InputError naming PhasePeriod if
/// the period is not in (0, 1 turn] (as all here), PhaseStep if the step is not in (0, period/8].
int calibration_side(Angle period, Angle step, double spare = 0.05);

/// The start phase from the best dimple, counted from 0 in milling order: x = -best step, modulo
/// `period`, in [0, period). Errors: InputError naming BestDimple if it is negative, PhaseStep
/// if the step is not in (0, period/8].
Angle start_phase(std::int64_t best_dimple, Angle step, Angle period);

/// From what a controller counts the turns of a lock.
enum class LockOrigin : std::uint8_t {
  AtSpeed,  ///< from where the axes have come to speed (LinuxCNC)
  Index     ///< from the spindle's index itself
};

/// The start phase that a locked path has of itself where flute 0 is at azimuth 0 at the index: the mean over its
/// dimples of how far the spindle is before the phase that is `wanted` there (wanted_phases), in [0, period). By the
/// motion model; by the planned turns where that does not know or the turns are counted from the index. Errors:
/// InputError naming PhasePeriod, Dimple (the path ends a move on one that is not wanted), or the model's own.
Angle own_start_phase(const ToolPath& path, const std::vector<Angle>& wanted, Angle period,
                      const machine::MotionModel& model, LockOrigin origin);

/// `path` with the spindle turned on by the missing period - x before the first dimple: it is begun so much further
/// back (on `decimals`) at the pace of its first timed move, so that dimples are where they were planned, and a lock
/// is at the speed that it was planned for. A correction of 0 changes nothing.
/// Errors: InputError naming StartPhase if not in [0, period); Path if it has no timed move of a
/// known length and turns before its first dimple.
ToolPath with_start_phase(ToolPath path, Angle start_phase, Angle period, const Decimals& decimals);

}  // namespace patchmill::sync

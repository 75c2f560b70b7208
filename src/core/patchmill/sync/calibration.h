// The start phase: where the flutes stand when a program's first dimple comes (Xu & Sasahara 2016,
// section 3.3). Nobody knows it, so one patch is milled in which every dimple is asked for a step,
// 1 degree, later than the one before. Over 360/N dimples all phases occur, and at one of them the
// unknown phase x and the steps cancel: that dimple is cut at its place and full depth. Its number
// gives x, which is stored with the machine and taken off all later paths.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

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

/// `path` with the spindle turned on by the missing period - x before the first dimple: a locked
/// path gets the turns in its first timed move, a feed-paced one is begun so much further back (on
/// `decimals`), so that dimples are where they were planned. A correction of 0 changes nothing.
/// Errors: InputError naming StartPhase if not in [0, period); Path if it has no timed move of a
/// known length and turns before its first dimple.
ToolPath with_start_phase(ToolPath path, Angle start_phase, Angle period, const Decimals& decimals);

}  // namespace patchmill::sync

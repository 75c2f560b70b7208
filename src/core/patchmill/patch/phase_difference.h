// Matsuda's condition (Matsuda 2008, section 2.2): the phase difference of the tool's rotation
// between a pass and the next one inside it decides whether cutter marks stand in rows.
//
// Facing points, c apart on lap k and lap k+1 of side i of a patch of m sides, are
//     l(k, i) = m a - (2 m k + 2 i + 1) c tan(π/m)
// apart along the path. Between them the tool turns l/f_z teeth, so the phase difference is
//     ω(k, i) = 2π/N · frac(l(k, i) / f_z).
// From lap to lap it changes by 2 m tan(π/m) c/f_z teeth, from side to side by 2 tan(π/m) c/f_z.
// Marks stand in straight rows within each side when the first is an integer, and alike on all
// sides when the second is; otherwise they drift and line up on curves. All phases are in teeth
// here: turns of the tool are 1/N of them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/free_helix.h"

#include <string>

namespace patchmill::patch {

/// Length of the path between facing points of laps k and k+1 on side i [mm].
double facing_length(const FreePatch& patch, int lap, int sector);

/// Phase difference between those points, in teeth, in [0, 1).
double phase_difference(const FreePatch& patch, int lap, int sector);

/// How the marks of a patch stand to one another.
enum class MarkArray : std::uint8_t {
  Square,     ///< ω = 0: each mark faces one on the next pass (rectangular if c is not f_z)
  Staggered,  ///< ω = half a tooth: each mark faces a gap
  Oblique,    ///< ω constant, neither of the two: straight rows that lean
  Drifting    ///< ω changes from pass to pass: the marks line up on curves
};
const char* name(MarkArray array);

/// What Matsuda's condition says of a patch. Phases in teeth.
struct MarkArrayState {
  MarkArray array = MarkArray::Drifting;
  double first = 0.0;           ///< ω between the first two passes of side 0, in [0, 1)
  double drift_per_lap = 0.0;   ///< change of ω from a pass to the next inside it, in [-1/2, 1/2)
  double drift_per_side = 0.0;  ///< change of ω from a side to the next, in [-1/2, 1/2)
  int laps = 0;                 ///< over how many passes it adds up
  bool sides_alike = false;     ///< all sides have the same array
};

/// `tolerance`: the change of ω over all laps, and its distance from 0 or 1/2, that still counts as
/// none [teeth].
/// Errors: as require_valid(patch).
MarkArrayState mark_array(const FreePatch& patch, double tolerance = 0.02);

/// One sentence for a panel, such as "staggered on all sides" or "drifting by 0.031 teeth a pass".
std::string describe(const MarkArrayState& state);

/// Phase difference found on the marks as they lie.
struct MeasuredPhase {
  int lap = 0, sector = 0;  ///< of the outer one of the two passes
  double teeth = 0.0;       ///< in [0, 1)
};

/// For every two neighbouring passes of a side that both have marks, how far the marks of the later
/// one lie behind those of the earlier one along the feed, in units of f_z and but for whole ones:
/// that is ω. It knows nothing of the closed form above: it takes the marks' places and which side
/// of the path each was made on. The path may run inward or outward.
std::vector<MeasuredPhase> measure_phase(const std::vector<HelixSide>& path,
                                         const std::vector<HelixMark>& marks,
                                         double feed_per_tooth);

}  // namespace patchmill::patch

// Tooth passes: the stretches of spindle angle in which one flute is near the surface. Each turn
// brings every flute once over the contact point, when its azimuth is that of -n (Xu & Sasahara
// 2016, section 3.1); a pass is kept only if the edge then reaches below the stock, so that the
// simulator's cost goes with the marks and not with the turns.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/progress.h"
#include "patchmill/marks/motion.h"
#include "patchmill/marks/relief.h"

namespace patchmill::marks {

/// One flute over the surface once. A flute that reaches the stock over a long way (the tool's tip)
/// is split into several passes.
struct ToothPass {
  double middle = 0.0;            ///< `turned` of the motion where delta = 0 [rad]
  float low = 0.0f, high = 0.0f;  ///< first and last delta [rad]
  std::int32_t run = 0;
  std::int32_t node = 0;  ///< of the run: the piece in which `middle` is
  std::int32_t flute = 0;
  float reach = 0.0f;                 ///< of the ball below the stock, about its centre's way [mm]
  float least[2] = {}, most[2] = {};  ///< box of the cells in reach, plane coordinates [mm]
};

/// All passes of a motion that reach below `stock` [mm] over the base of `grid`, in order of run,
/// flute and spindle angle; passes outside the grid are left out. On a concave base the radius of
/// curvature should be three times the ball's at least, or the rim of its marks is missed. Errors:
/// InputError of require_valid(cutter) and require_valid(grid).
std::vector<ToothPass> find_passes(const ToolMotion& motion, const Cutter& cutter,
                                   const SurfaceGrid& grid, double stock);

/// -1 for M3, +1 for M4.
inline double sign_of(SpindleSense sense) {
  return static_cast<double>(static_cast<int>(sense));
}

/// Radius of the edge of a flute, runout included [mm].
double edge_radius(const Cutter& cutter, int flute);

/// Lag of the edge per height above the tip [rad/mm].
double helix_rate(const Cutter& cutter);

/// Unit direction from the axis to the edge of a flute at height `z` above the tip.
Vec3 edge_direction(const MotionNode& node, SpindleSense sense, const Cutter& cutter, int flute,
                    double z);

/// The motion at `turned` in piece `piece` of a run, linear between its two nodes.
MotionNode node_at(const MotionRun& run, std::size_t piece, double turned);

/// The piece of a run in which `turned` is, searched from `near`; the first or last one outside the
/// run.
std::size_t piece_at(const MotionRun& run, std::size_t near, double turned);

}  // namespace patchmill::marks

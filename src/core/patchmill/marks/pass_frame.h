// From a tooth pass to the numbers of the innermost loop: everything relative to the ball centre in
// the middle of the pass, so that single precision is enough.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/marks/flute_kernel.h"
#include "patchmill/marks/tooth_pass.h"

namespace patchmill::marks {

/// The way of the ball centre through a pass, relative to its place in the middle; in the frame of
/// PassFrame [mm].
struct PassWay {
  Vec3 centre =
      Vec3::Zero();  ///< where it is in the middle: plane coordinates and height, or work frame
  std::vector<Vec3> corners;  ///< of the polyline from first to last delta
  Vec3 tip = Vec3::Zero();    ///< of the tool, seen from the ball centre
  double near_tip =
      0.0;  ///< cells that need a search lie within this distance of the tip's way [mm]
};

/// Fills `frame` and `way` for a pass. For a flat grid the frame is (plane x, plane y, normal), for
/// a curved one the work frame.
void prepare(const ToothPass& pass, const ToolMotion& motion, const Cutter& cutter,
             const SurfaceGrid& grid, PassFrame& frame, PassWay& way);

}  // namespace patchmill::marks

// Copy milling: tool paths from a virtual ball probe slid over the model, layer by layer from the
// stock. Kobayashi & Shirase 2014, section 2 and Tables 1 and 2: scanning lines in x-z planes and
// contour lines at z levels, with radial and axial depth of cut.
//
// Scanning: in each plane y = const the probe gives the height z(x); layer k is cut where z(x) lies
// below the previous layer, at max(z(x), level k); so the layers together leave the surface
// finished. With undercuts the curve is the section of the part's offset surface (all points at
// distance R), on which the probe also runs below an overhang; the layers are then the free parts
// of the horizontal lines, and the section is cut last. Contour: at each level the curve on which
// the resting ball has that height, and outside it the curves at multiples of the radial depth,
// from the stock inwards.
//
// The probe is the tool itself, thicker by the allowance: a ball, or any other cutter of tool.h; what is said of the
// ball's centre here then holds for the tool's. The offset surface is that of a ball, and undercuts need one.
//
// Between two points of the path the ball runs straight. Points are close enough that this leaves
// the curve by at most the tolerance.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/progress.h"
#include "patchmill/mesh/triangle_bvh.h"
#include "patchmill/path/tool_path.h"

namespace patchmill::copy {

enum class CopyMode {
  Scanning,          ///< planes y = const, the tool upright and clear of every overhang
  ScanningUndercut,  ///< the same planes along the offset surface; needs a tilted tool (apply_dcm)
  Contour            ///< z levels
};

/// What copy milling is asked for.
struct CopyOptions {
  CopyMode mode = CopyMode::Scanning;
  Tool tool;
  Spindle spindle;
  double feed = 0.0;          ///< of the tool's centre [mm/s], > 0
  double radial_depth = 0.0;  ///< cross-feed between planes or curves [mm], > 0
  double axial_depth = 0.0;   ///< between levels [mm], > 0
  double tolerance = 0.01;    ///< of the path from the exact curve [mm], in [1e-4, R]
  double allowance = 0.0;     ///< left on the part [mm], >= 0
  mesh::Box stock;            ///< what there is to cut [mm]
  double clearance = 5.0;     ///< rapids run this far above the stock [mm], > 0
  /// How far scanning lines go on beyond the stock in y [mm], in [0, R]: a slope that falls towards that edge
  /// by the angle a is finished by a ball centre R sin(a) beyond it.
  double overlap = 0.0;
};

/// Throws InputError for an option out of range, a stock of no volume, or undercuts without a ball end mill.
void require_valid(const CopyOptions& options);

/// A path over the part, and what of it had to be left out.
struct CopiedPath {
  ToolPath path;
  int out_of_reach = 0;  ///< lines of which no point can be reached from above: in a cavity
};

/// The path over the part. Errors: InputError for an option out of range or a stock of no volume.
/// If `progress` asks for a stop, the path is what was done so far.
CopiedPath copy_mill(const mesh::TriangleBvh& part, const CopyOptions& options,
                     const Progress& progress = {});

}  // namespace patchmill::copy

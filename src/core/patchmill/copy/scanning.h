// Scanning-line mode of copy milling: the curves of one plane y = const. See copy_milling.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/copy/copy_milling.h"
#include "patchmill/copy/level_curves.h"

#include <vector>

namespace patchmill::copy {

/// Height of the ball centre along x in the plane y, from x0 to x1: points (x, z), never lower than
/// `floor`. Between points the straight line is within the tolerance of the probe's height; where
/// that jumps (a wall) the points are closer than half the tolerance in x.
std::vector<Vec2> probe_profile(const mesh::TriangleBvh& part, double y, double x0, double x1,
                                double floor, const CopyOptions& options);

/// The parts of a profile that lie below `above`, raised to `level` where they are lower: one
/// layer.
std::vector<std::vector<Vec2>> layer_of(const std::vector<Vec2>& profile, double above,
                                        double level);

/// Section of the offset surface with the plane y: curves (x, z) at distance R + allowance from the
/// part.
std::vector<Polyline> offset_section(const mesh::TriangleBvh& part, double y,
                                     const CopyOptions& options);

/// The parts of the line z = height from x0 to x1 outside the section curves.
std::vector<std::vector<Vec2>> free_intervals(const std::vector<Polyline>& section, double height,
                                              double x0, double x1);

}  // namespace patchmill::copy

// A texture as the panel shows it before it is milled: every lattice point that was tried, coloured by
// what became of it; the order in which they are milled; the outlines of the patches.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "core/patch/dimple.h"
#include "core/patch/division.h"
#include "core/patch/texture_plane.h"

#include <vector>

class SoSeparator;

namespace patchmill::scene {

/// Discs of `radius` [mm] lying on the surface, points where they would be a few pixels wide only.
/// Dimples that are OffFace or OffNet have no place on a face and are not shown.
SoSeparator* dimple_node(const Dimples& dimples, double radius);

/// Lines from dimple to dimple inside each patch, with an arrowhead every few steps of length
/// `spacing` [mm] (1 for the first step); neighbouring patches have different shades.
SoSeparator* order_node(const Dimples& dimples, double spacing);

/// Closed polylines, points as rows [mm]; a row that is not finite interrupts its line.
SoSeparator* outline_node(const std::vector<std::vector<Vec3>>& outlines);

/// Lines of `length` [mm] from the dimples along their tool axes, at most `most` of them, evenly
/// chosen. `axes` are unit vectors, one to a dimple.
SoSeparator* axis_node(const Dimples& dimples, const std::vector<Vec3>& axes, double length,
                       std::size_t most);

}  // namespace patchmill::scene

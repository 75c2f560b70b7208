// A texture as the panel shows it before it is milled: every lattice point that was tried, coloured by
// what became of it; the order in which they are milled; the outlines of the patches.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/dimple.h"
#include "patchmill/patch/division.h"
#include "patchmill/patch/texture_plane.h"
#include "scene/display.h"

#include <vector>

namespace patchmill::scene {

/// Discs of `radius` [mm] just over the surface; points where they would be a few pixels wide only, and
/// some of them where even points would touch.
/// Dimples that are OffFace or OffNet have no place on a face and are not shown.
Display dimple_display(const patch::Dimples& dimples, double radius);

/// Lines from dimple to dimple inside each patch, with an arrowhead every few steps of length
/// `spacing` [mm] (1 for the first step); neighbouring patches have different shades.
Display order_display(const patch::Dimples& dimples, double spacing);

/// Closed polylines, points as rows [mm]; a row that is not finite interrupts its line.
Display outline_display(const std::vector<std::vector<Vec3>>& outlines);

}  // namespace patchmill::scene

// The Bezier surface of Xu & Sasahara 2016, Table 1, and dimples on it: rows of the table are u,
// columns are v; points are found along Z.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "core/patch/dimple.h"

namespace patchmill {

/// The surface point above (x, y) [mm], by Newton's method; the normal points up (+Z).
SurfacePoint bezier_point(double x, double y);

/// Helical square patches of side x side dimples, spaced f [mm], the first dimple of the first
/// patch at (x, y); patches_x by patches_y of them, row by row to and fro.
Dimples bezier_patches(double x, double y, int side, double spacing, int patches_x, int patches_y);

}  // namespace patchmill

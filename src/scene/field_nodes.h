// Fields on voxels: coloured squares of a slice, and arrows.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"
#include "scene/display.h"

#include <vector>

namespace patchmill::scene {

/// A slice through voxels: squares of `side` [mm] around `centres`, at right angles to axis 0, 1 or 2,
/// coloured by `values` from `low` to `high`.
Display slice_display(const std::vector<Vec3>& centres, const std::vector<double>& values,
                      double side, int axis, double low, double high);

/// Arrows from `places` along `vectors`, as long as the vectors times `scale`; coloured by `values`.
Display arrow_display(const std::vector<Vec3>& places, const std::vector<Vec3>& vectors,
                      double scale, const std::vector<double>& values, double low, double high);

}  // namespace patchmill::scene

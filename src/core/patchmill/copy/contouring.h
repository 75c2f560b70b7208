// Contour-line mode of copy milling: the curves of one z level. See copy_milling.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/copy/copy_milling.h"
#include "patchmill/copy/level_curves.h"

#include <vector>

namespace patchmill::copy {

/// Curves on which the resting ball's centre has height `z`: the part lies on their right.
std::vector<Polyline> ball_contours(const mesh::TriangleBvh& part, double z,
                                    const CopyOptions& options);

/// Curves at `distance` [mm, > 0] from the contours, on their free side, within the stock.
std::vector<Polyline> around_contours(const std::vector<Polyline>& contours,
                                      const mesh::TriangleBvh& part, double z, double distance,
                                      const CopyOptions& options);

}  // namespace patchmill::copy

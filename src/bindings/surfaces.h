// Projected surfaces as the core's functions take them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/projected_surface.h"

namespace patchmill {

/// What samples the surface, which outlives it.
patch::SurfaceSampler sampler_of(const patch::ProjectedSurface& on);

}  // namespace patchmill

// The feed with which a tool goes down into the material: its end cuts worse than its side, so that tool
// controllers have a feed of their own for it. On a slope it counts for the vertical part of the velocity,
//   F <= F_v / |sin a|   where the move falls by the angle a,
// so that a plunge has the vertical feed, a level move its own, and nothing jumps in between.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/path/tool_path.h"

namespace patchmill::copy {

/// `path` with no timed move going down faster than `vertical` [mm/s], > 0; places stay as they are, and what
/// is slower already. Errors: InputError naming VertFeed.
ToolPath with_plunge_feed(ToolPath path, double vertical);

}  // namespace patchmill::copy

// What a display is made of: scene graphs as the bytes of Open Inventor files, computed in any thread and read by the
// GUI a few chunks at a time. Coin is not to be used from several threads, and a GUI must not wait.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace patchmill::scene {

/// Chunks are independent of each other; to be shown side by side. Each is a file by itself (inventor.h).
using Display = std::vector<std::string>;

}  // namespace patchmill::scene

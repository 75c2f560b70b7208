// What a display is made of, computed in any thread, and turned into Coin nodes in the GUI's, a few chunks
// at a time: Coin is not to be used from several threads, and a GUI must not wait.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <vector>

class SoSeparator;

namespace patchmill::scene {

/// Makes the nodes of one chunk, from arrays that it owns. To be called in the GUI's thread.
using Chunk = std::function<SoSeparator*()>;

/// Chunks are independent of each other; to be shown side by side.
using Display = std::vector<Chunk>;

}  // namespace patchmill::scene

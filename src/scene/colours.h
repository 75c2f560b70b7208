// Colours of the display, packed as Coin wants them (0xRRGGBBAA). A linear scale and a set of distinct
// colours, both chosen to be told apart by the colour-blind.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/dimple.h"
#include "patchmill/path/tool_path.h"

#include <cstdint>

namespace patchmill::scene {

using Rgba = std::uint32_t;

/// `share` in [0, 1] on a dark blue - green - yellow scale of even lightness steps; values outside
/// are clamped, NaN is a light grey.
Rgba scale_colour(double share);

/// Colour of a dimple: cut, or the reason why it is left out.
Rgba state_colour(patch::DimpleState state);

/// Colour of a move of this kind.
Rgba move_colour(MoveKind kind);

}  // namespace patchmill::scene

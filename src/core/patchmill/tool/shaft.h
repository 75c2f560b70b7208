// What is above a cutter's end: edges, shank and holder, as frusta about the tool axis. Part of a Tool (tool.h).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace patchmill {

/// A frustum about an axis.
struct Frustum {
  double from = 0.0, to = 0.0;  ///< heights along the axis [mm], from < to, <= 1e4 long
  double radius_from = 0.0, radius_to = 0.0;  ///< [mm], 0 .. 1e4
};
bool operator==(const Frustum& a, const Frustum& b);

enum class ToolPart : std::uint8_t {
  Ball,
  End,    ///< of a cutter that is no ball end mill: cuts as a ball does
  Flute,  ///< the cutting cylinder or cone above ball or end: cuts as they do
  Shank,
  Holder
};

/// "ball", "cutting end", "flute", "shank", "holder".
const char* name(ToolPart part);

/// Whether a part of the tool has edges, so that it may touch what is milled.
bool cuts(ToolPart part);

/// A piece of the tool above its end: a frustum about the tool axis.
struct ToolSection {
  ToolPart part = ToolPart::Shank;
  double from = 0.0, to = 0.0;                ///< heights above the tip [mm], 0 <= from < to <= 1e6
  double radius_from = 0.0, radius_to = 0.0;  ///< [mm], 0 .. 1e6

  /// Its frustum, heights above the tip [mm].
  Frustum frustum() const { return {from, to, radius_from, radius_to}; }
};

/// Shank and holder of a tool, heights above its tip [mm, 0 .. 1e6]. What is 0 or empty is not known, or not there.
struct Shaft {
  double cutting_length = 0.0;  ///< up to which the edges go
  double shank_radius = 0.0;    ///< of the shank between the edges and the holder
  double stick_out = 0.0;       ///< from the tip to the holder
  std::vector<Frustum> holder;  ///< in any order
};
bool operator==(const Shaft& a, const Shaft& b);

/// Errors: InputError naming CuttingLength, ShankRadius, StickOut or ToolSection (out of their ranges).
void require_valid(const Shaft& shaft);

/// Errors: InputError naming ToolSection.
void require_valid(const ToolSection& section);

}  // namespace patchmill

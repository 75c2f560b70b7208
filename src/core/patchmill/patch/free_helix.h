// Matsuda's own helical path (Matsuda 2008, section 2.2, Fig. 3): the side a of the patch, the
// cross-feed c and the feed per tooth f_z are independent, and marks fall every f_z along the path,
// wherever that is. The path is that of a regular polygon of m sides: the first lap on the outline
// a, and each side of the next lap c further in.
//
// Sides lie on lines at right angles to directions 2π/m apart. With φ = 2π/m and the distances o,
// p, q from the centre of the line before, the line itself and the line after, a side runs from
// (p cos φ - o)/sin φ to (q - p cos φ)/sin φ along its line, so it is (o + q - 2 p cos φ)/sin φ
// long.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/helix.h"

namespace patchmill::patch {

/// The parameters of one patch in free form.
struct FreePatch {
  int corners = 4;    ///< m, at least 3
  double side = 0.0;  ///< a: length of the outline's sides, along which the first lap goes [mm]
  double cross_feed = 0.0;      ///< c: distance of neighbouring passes [mm]
  double feed_per_tooth = 0.0;  ///< f_z: distance of marks along the path [mm]
};

/// One straight side of the path.
struct HelixSide {
  Vec2 start, end;  ///< in the patch's plane, the centre of the polygon at the origin [mm]
  double at = 0.0;  ///< length of the path up to `start` [mm]
  int lap = 0;      ///< k, 0 on the outline
  int sector = 0;   ///< i in 0..m-1: which of the polygon's sides it runs along
};

/// A mark: the place that a tooth cuts.
struct HelixMark {
  Vec2 place;
  int side = 0;  ///< index of the HelixSide that it lies on
};

/// Distance of the outline from the centre: a / (2 tan(π/m)) [mm].
double apothem(const FreePatch& patch);

/// Errors: InputError naming PatchSide, CrossFeed, FeedPerTooth or Corners (3..360); also if the
/// path would have more than `max_marks` marks or laps.
void require_valid(const FreePatch& patch, double max_marks = 2e7);

/// The path, until it has wound up. Inward: first side along +x at the bottom, counter-clockwise.
/// Outward: the same path backwards.
/// Errors: as require_valid().
std::vector<HelixSide> helix_path(const FreePatch& patch, HelixOrder order = HelixOrder::Inward);

/// Length of a path [mm].
double path_length(const std::vector<HelixSide>& path);

/// The marks from the path's start on: at n f_z, n = 0, 1, 2 ... up to the end (and a rounding
/// error beyond, so that a mark on the end itself is there).
std::vector<HelixMark> helix_marks(const std::vector<HelixSide>& path, double feed_per_tooth);

}  // namespace patchmill::patch

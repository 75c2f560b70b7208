// The advisor: for a tool, a spindle speed and a wanted spacing or ridge height, the nearest feed
// per tooth, cross-feed, side and feed with which cutter marks stand in rows on all sides of a
// patch.
//
// Matsuda's condition (phase_difference.h) leaves families of patches, one for each pair of whole
// numbers q (teeth of drift from side to side) and n (whole teeth around the outline), in which
// everything scales with f_z:
//     c = q f_z / (2 tan(π/m)),    a = (n + q/2 + u) f_z / m
// with u = 0 for the square array and 1/2 for the staggered one. The proposals are members of the
// families next to the wish.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/phase_difference.h"
#include "patchmill/path/tool_path.h"

#include <optional>

namespace patchmill::patch {

/// What the user wants. Give either `feed_per_tooth` or `ridge_height`.
struct MarkWish {
  Tool tool;
  double spindle_speed = 0.0;            ///< S [revolutions per second]
  int corners = 4;                       ///< m
  double side = 0.0;                     ///< a [mm]
  MarkArray array = MarkArray::Square;   ///< Square or Staggered
  std::optional<double> feed_per_tooth;  ///< f_z: spacing of the marks [mm]
  std::optional<double> ridge_height;    ///< highest point that may stay between marks [mm]
  std::optional<double> cross_feed;      ///< c [mm]; else f_z, or f_z √3/2 if staggered
};

/// What a proposal leaves as it was wished.
enum class Kept : std::uint8_t { FeedPerTooth, CrossFeed, Side, RidgeHeight, Nothing };
const char* name(Kept kept);

/// Values that are proposed for the free form.
struct MarkProposal {
  Kept kept = Kept::Nothing;
  FreePatch patch;
  double feed = 0.0;          ///< F = f_z N S [mm/s]
  double ridge_height = 0.0;  ///< highest point between marks, by the cusp formula [mm]
  MarkArrayState state;
  double change = 0.0;  ///< the largest relative change of f_z, c and a
};

/// The patch as wished, with the defaults filled in.
/// Errors: InputError naming the wrong or missing one of BallRadius, Flutes, SpindleSpeed, Corners,
/// PatchSide, MarkArray, FeedPerTooth, CrossFeed, RidgeHeight.
FreePatch wished_patch(const MarkWish& wish);

/// Proposals by increasing change, one for each thing that can be kept. The first keeps nothing and
/// so changes least. If the wish itself is aligned, that is what all of them say. Left out are
/// proposals in which the ball would not reach between the marks.
/// Errors: as wished_patch(), and PatchSide if the side is too short for two passes.
std::vector<MarkProposal> advise(const MarkWish& wish);

/// What changes, in one sentence: "cross-feed 0.5 → 0.4330 mm (−13.4 %), side 7 → 7.036 mm (+0.5
/// %)".
std::string describe_changes(const FreePatch& wished, const MarkProposal& proposal);

}  // namespace patchmill::patch

// How cutter marks line up: Matsuda, Sasahara & Tsutsumi 2008, section 2.2, Fig. 2. On adjoining
// passes the marks are shifted along the feed by the phase difference omega: by omega N / (2 pi) of
// the feed per tooth. Constant, it makes a square (0), a staggered (1/2) or a skewed array;
// changing from pass to pass, the marks drift and line up on curves.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"

#include <vector>

namespace patchmill::marks {

enum class Alignment {
  Square,
  Staggered,
  Skewed,     ///< a constant shift that is neither 0 nor 1/2
  Drifting,   ///< one shift for a pair of rows, another for the next pair
  Irregular,  ///< not even the marks of two rows agree on a shift
  Unknown     ///< too few marks in adjoining rows
};
const char* name(Alignment alignment);

/// Straight rows of marks; of a helical patch, those of one sector.
struct RowLayout {
  Vec2 feed = Vec2::UnitX();    ///< along the rows, of any length
  double feed_per_tooth = 0.0;  ///< f_z, distance of marks in a row [mm]
  double cross_feed = 0.0;      ///< distance of rows [mm]
};

/// How one row of marks stands against the next.
struct RowShift {
  int row = 0;             ///< of the lower row, counted in cross-feeds from the lowest one
  double shift = 0.0;      ///< of the next row's marks, share of f_z, 0 .. 1
  double agreement = 0.0;  ///< 1: all marks have the same shift; 0: all shifts
  int pairs = 0;           ///< of marks looked at
};

/// The array that marks stand in.
struct AlignmentResult {
  Alignment state = Alignment::Unknown;
  double shift = 0.0;          ///< mean over all pairs of rows, share of f_z, 0 .. 1
  double agreement = 0.0;      ///< of the pairs of rows on one shift, by their marks, 0 .. 1
  double row_agreement = 0.0;  ///< of the marks within pairs of rows, mean, 0 .. 1
  std::vector<RowShift> rows;
};

/// How near marks must stand to an array to count as one.
struct AlignmentOptions {
  double shift_tolerance = 0.06;     ///< of f_z: so near to 0 or 1/2 counts as that
  double least_agreement = 0.9;      ///< of rows on one shift; below, they drift
  double least_row_agreement = 0.8;  ///< of marks in a pair of rows; below, they are irregular
};

/// What the marks at `places` [mm, texture plane] look like along the given rows. Errors:
/// InputError naming FeedPerTooth, CrossFeed, FeedDirection (zero, not finite) or Places (not finite).
AlignmentResult classify_alignment(const std::vector<Vec2>& places, const RowLayout& layout,
                                   const AlignmentOptions& options = {});

}  // namespace patchmill::marks

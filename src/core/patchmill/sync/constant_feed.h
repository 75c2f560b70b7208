// Constant feed: the phase is kept by geometry alone (Xu & Sasahara 2016, sections 3.2 and 3.3). At
// a constant spindle speed S and feed F the tool travels
//     L_k = F T_k,  T_k = Lambda_k / (2 pi S)                                             (Eq. 2)
// from dimple k to k+1 on two equal legs over an apex lifted along the mean normal by
//     h = sqrt(L_k² - d_k²) / 2,  d_k the distance of the two places.
// Deviation: vertices are rounded to the program's decimals before lengths are taken, of the
// rounded points near the apex the one is chosen whose legs fit best, and what is left is carried
// into the next L, so the phase error does not grow with the number of dimples. The paper says
// nothing of rounding.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/path/rounding.h"
#include "patchmill/sync/phase_rule.h"

namespace patchmill::sync {

/// What paths at a constant feed are made by.
struct ConstantFeed {
  double feed = 0.0;  ///< F [mm/s]; rounded to the decimals in mm/min, as it is posted
  PhaseRule phase;
  double safe_height = 0.0;       ///< links travel at or above this Z of the tip [mm]
  double clearance_height = 0.0;  ///< rapids before the first and after the last dimple [mm]
};

/// The feed as it is posted: rounded to `decimals` in mm/min [mm/s]; may be 0. Errors: InputError naming Feed
/// if it is not positive.
double posted_feed(double feed, const Decimals& decimals);

/// The path of a fixed vertical tool over all Cut dimples in their order: rapid above the first,
/// plunge, two legs per dimple, a link (Eq. 3) from patch to patch. Positions lie on `decimals`;
/// the turns of each move are what its rounded length takes at F and S. Errors: InputError naming
/// Feed (not positive, or too small for the turns asked: L_k < d_k), SpindleSpeed, Flutes,
/// ExtraTurns, SafeHeight (a dimple or apex is higher), ClearanceHeight (below the safe height),
/// Dimples (none is left to cut).
ToolPath constant_feed_path(const patch::Dimples& dimples, const Tool& tool, const Spindle& spindle,
                            const ConstantFeed& rule, const Decimals& decimals);

/// The corner of a dimple step of two equal legs of together `length`: a + (b - a) / 2 lifted by h
/// at right angles to b - a towards `up`. Errors: none; `length` >= |b - a|.
Vec3 apex(const Vec3& a, const Vec3& b, const Vec3& up, double length);

}  // namespace patchmill::sync

// Links between patches (Xu & Sasahara 2016, section 4.1, Eq. 3): lift, traverse and plunge at a
// feed, with a total length L such that lambda = L 2 pi S / F (mod M) arrives at the next patch's
// phase. Any whole number of periods will do, so the height is free and is used to set the length.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/path/rounding.h"

#include <array>

namespace patchmill::sync {

/// What a link must do.
struct LinkRequest {
  Vec3 from, to;             ///< tool tips on the decimals; vertical tool
  double safe_height = 0;    ///< least Z of the traverse [mm], not below from and to
  double length_zero = 0;    ///< L must be length_zero + a whole multiple of length_period [mm]
  double length_period = 0;  ///< F * M / (2 pi S) [mm], > 0
};

/// The two upper corners of the link, on the decimals: {above from, above to}. The first is raised
/// by up to one length_period, and moved sideways by up to sqrt(2 h / unit) units (0.2 mm at h = 20
/// mm and 3 decimals) where that makes the length fit better: to 1e-5 mm where possible.
std::array<Vec3, 2> link_corners(const LinkRequest& request, const Decimals& decimals);

/// Length of from -> corners -> to [mm].
double link_length(const LinkRequest& request, const std::array<Vec3, 2>& corners);

/// How far `length` is from the nearest length that keeps the phase [mm], signed.
double length_miss(const LinkRequest& request, double length);

}  // namespace patchmill::sync

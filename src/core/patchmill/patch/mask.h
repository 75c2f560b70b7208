// Masks: an image or the inside of curves says where dimples are left out, how dense they are, or
// how deep. A mask is a function of the place in the texture plane with values from 0 to 1.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/division.h"
#include "patchmill/patch/sampler.h"

namespace patchmill::patch {

/// Value of a mask at a place of the texture plane [mm]: 0 to 1.
using Mask = std::function<double(const Vec2& place)>;

/// A grey image: rows from the top, values 0 (black) to 1 (white).
struct Image {
  int columns = 0, rows = 0;
  std::vector<float> values;  ///< columns * rows
};

/// The image laid on `area`, its top along the largest y; bilinear between the pixels' centres,
/// `outside` beyond the area.
/// Errors: InputError naming Image (its size does not fit its values, or values are not in 0..1) or
/// MaskArea (empty or not finite) or MaskOutside (0 .. 1).
Mask image_mask(Image image, const Box2& area, double outside = 0.0);

/// 1 inside the closed curves, 0 outside, by the even-odd rule: a loop within a loop is a hole, as
/// in letters. The loops are polygons in the texture plane [mm]; the last point joins the first.
/// Errors: InputError naming Curves if a loop has fewer than three points or is not finite.
Mask curve_mask(std::vector<Polygon> loops);

/// 1 - mask.
inline Mask inverted(Mask mask) {
  return [mask = std::move(mask)](const Vec2& p) { return 1.0 - mask(p); };
}

/// Cut dimples where the mask is below `threshold` become Masked.
/// Errors (all three): InputError naming what is out of its range.
void keep_where(Dimples& dimples, const LatticePlace& place_of, const Mask& mask,
                double threshold = 0.5);

/// Density: leaves the share of dimples that the mask says, spread evenly by an 8 x 8 ordered
/// dither over the lattice (Bayer 1973); the others become Masked.
void thin_out(Dimples& dimples, const LatticePlace& place_of, const Mask& mask);

/// Depth of cut dimples from `depth_at_0` to `depth_at_1` [mm], linear in the mask; those that
/// would be shallower than `least` become Masked.
void set_depth(Dimples& dimples, const LatticePlace& place_of, const Mask& mask, double depth_at_0,
               double depth_at_1, double least = 0.0);

}  // namespace patchmill::patch

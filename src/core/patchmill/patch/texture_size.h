// Sizes of a texture: spacing, depth, dimple diameter, share of area and ridge height belong
// together through the ball's radius R, so that two of them (isolated dimples) or one (overlapping)
// give the rest.
//
// Overlapping (Matsuda 2008; Xu & Sasahara 2016): the dimples' bottoms are on the target surface,
// and what stays between them is
//     ridge  R - √(R² - f²/4)   half-way between neighbours (f²/8R for small f),
//     depth  R - √(R² - ρ²)     at the points furthest from all dimples, ρ the covering radius:
//                               f/√2 (square), f/√3 (triangular).
// Isolated: spherical caps of depth d sunk in a smooth surface, the ball's centre R - d over it,
//     diameter D = 2 √(2 R d - d²),   share = π D²/4 / cell,   cell = f² or f² √3/2,
// and the smooth surface stays between them if D < f.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/angle.h"
#include "patchmill/patch/lattice.h"

#include <optional>

namespace patchmill::patch {

enum class TextureKind : std::uint8_t { Overlapping, Isolated };

/// What is known of a texture; lengths in mm. Give what you know and leave the rest empty.
struct TextureWish {
  TextureKind kind = TextureKind::Overlapping;
  LatticeKind lattice = LatticeKind::Square;
  double ball_radius = 0.0;          ///< R
  std::optional<double> spacing;     ///< f
  std::optional<double> depth;       ///< isolated: d; overlapping: deepest below the highest point
  std::optional<double> diameter;    ///< of a dimple's rim; overlapping: 2 ρ
  std::optional<double> area_share;  ///< of the surface that is dimple, 0 to 1
  std::optional<double> ridge_height;  ///< overlapping: between neighbours; isolated: the depth
  std::optional<Angle> tilt;           ///< least angle between tool axis and normal
};

/// All of it.
struct TextureSize {
  double spacing = 0.0, depth = 0.0, diameter = 0.0;
  double area_share = 1.0, ridge_height = 0.0;
  double sunk = 0.0;  ///< how far dimples' bottoms lie below the surface: Dimple::depth
  /// Half the angle that a dimple takes up on the ball: with less tilt than this the tip, which
  /// does not cut, rubs in it.
  Angle least_tilt;
};

/// Completes a wish.
/// Errors: InputError naming the property that is missing (isolated dimples need their size, by
/// depth, diameter or ridge height, and their distance, by spacing or area share), out of range, or
/// at odds with the others by more than one part in 10⁴: its remedy says what the others ask for.
/// Also Spacing or AreaShare if isolated dimples would touch, Spacing if the ball does not reach
/// between overlapping ones, and Tilt if the tip would rub at the tilt.
TextureSize complete(const TextureWish& wish);

}  // namespace patchmill::patch

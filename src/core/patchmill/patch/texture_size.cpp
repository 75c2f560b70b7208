// Spacing, depth, diameter, share and ridge of a texture from one another; see texture_size.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/texture_size.h"

#include "patchmill/geometry/error.h"
#include "patchmill/patch/ridge.h"

#include <cmath>

#include <fmt/format.h>

namespace patchmill::patch {
namespace {

constexpr double kSlack = 1e-4;

void require_valid(const TextureWish& w) {
  require_positive("BallRadius", w.ball_radius, "mm");
  if (w.spacing) require_positive("Spacing", *w.spacing, "mm");
  if (w.depth) require_in_range("Depth", *w.depth, 1e-9, w.ball_radius, "mm");
  if (w.diameter) require_in_range("DimpleDiameter", *w.diameter, 1e-9, 2.0 * w.ball_radius, "mm");
  if (w.area_share) require_in_range("AreaShare", *w.area_share, 1e-9, 1.0, "");
  if (w.ridge_height) require_in_range("RidgeHeight", *w.ridge_height, 1e-9, w.ball_radius, "mm");
}

// Says which wish is at odds with what the others ask for.
void require_same(const char* property, const std::optional<double>& given, double computed,
                  const char* unit, const char* from) {
  if (!given || std::abs(*given - computed) <= kSlack * std::abs(computed)) return;
  throw InputError(property, fmt::format("{} {}", *given, unit),
                   fmt::format("{} asks for {:.6g} {}: give that, or leave one of them empty.",
                               from, computed, unit));
}

[[noreturn]] void missing(const char* property, const char* remedy) {
  throw InputError(property, "missing", remedy);
}

// Covering radius over spacing.
double reach(LatticeKind lattice) {
  return covering_radius({1.0, 0.0}, second_axis(lattice));
}

TextureSize overlapping(const TextureWish& w) {
  const double radius = w.ball_radius, reach_1 = reach(w.lattice);
  TextureSize size;
  const char* from = "Spacing";
  if (w.spacing) {
    size.spacing = *w.spacing;
  } else if (w.ridge_height) {
    size.spacing = 2.0 * cusp_distance(radius, *w.ridge_height);
    from = "RidgeHeight";
  } else if (w.depth) {
    size.spacing = cusp_distance(radius, *w.depth) / reach_1;
    from = "Depth";
  } else if (w.diameter) {
    size.spacing = 0.5 * *w.diameter / reach_1;
    from = "DimpleDiameter";
  } else {
    missing("Spacing", "give the spacing, the ridge height, the depth or the dimple diameter.");
  }
  const double rho = reach_1 * size.spacing;
  size.depth = cusp_height(radius, rho);
  size.diameter = 2.0 * rho;
  size.ridge_height = cusp_height(radius, 0.5 * size.spacing);
  size.least_tilt = Angle::radians(std::asin(rho / radius));
  require_same("RidgeHeight", w.ridge_height, size.ridge_height, "mm", from);
  require_same("Depth", w.depth, size.depth, "mm", from);
  require_same("DimpleDiameter", w.diameter, size.diameter, "mm", from);
  require_same("AreaShare", w.area_share, 1.0, "", "an overlapping texture");
  return size;
}

// Depth of isolated dimples from whichever way their size is given.
double isolated_depth(const TextureWish& w, const char*& from) {
  const double radius = w.ball_radius;
  if (w.depth) {
    from = "Depth";
    return *w.depth;
  }
  if (w.ridge_height) {
    from = "RidgeHeight";
    return *w.ridge_height;
  }
  double diameter = 0.0;
  if (w.diameter) {
    from = "DimpleDiameter";
    diameter = *w.diameter;
  } else if (w.spacing && w.area_share) {
    from = "AreaShare and Spacing";
    diameter = *w.spacing * std::sqrt(*w.area_share * cell_area(w.lattice) * 4.0 / kPi);
  } else {
    missing("Depth",
            "give the depth or the diameter of the dimples, or both their spacing and their "
            "share of the area.");
  }
  if (diameter > 2.0 * radius)
    throw InputError(
        "AreaShare", fmt::format("{}", w.area_share.value_or(0.0)),
        fmt::format("at this spacing it takes dimples of {:.4g} mm, wider than the ball: "
                    "choose a larger ball or a smaller spacing.",
                    diameter));
  return cusp_height(radius, 0.5 * diameter);
}

TextureSize isolated(const TextureWish& w) {
  TextureSize size;
  const char* from = "";
  size.depth = size.ridge_height = size.sunk = isolated_depth(w, from);
  const double half = cusp_distance(w.ball_radius, size.depth), area = kPi * half * half;
  size.diameter = 2.0 * half;
  require_same("RidgeHeight", w.ridge_height, size.ridge_height, "mm", from);
  require_same("DimpleDiameter", w.diameter, size.diameter, "mm", from);
  if (w.spacing)
    size.spacing = *w.spacing;
  else if (w.area_share)
    size.spacing = std::sqrt(area / (*w.area_share * cell_area(w.lattice)));
  else
    missing("Spacing", "give the spacing or the share of the area.");
  size.area_share = area / (size.spacing * size.spacing * cell_area(w.lattice));
  require_same("AreaShare", w.area_share, size.area_share, "", "the dimples' size at this spacing");
  size.least_tilt = Angle::radians(std::asin(std::min(1.0, half / w.ball_radius)));
  if (size.diameter >= size.spacing)
    throw InputError(
        w.spacing ? "Spacing" : "AreaShare",
        w.spacing ? fmt::format("{} mm", *w.spacing) : fmt::format("{}", *w.area_share),
        fmt::format(
            "dimples of {:.4g} mm touch: choose a spacing above that, shallower dimples, or "
            "the overlapping texture.",
            size.diameter));
  return size;
}

}  // namespace

TextureSize complete(const TextureWish& wish) {
  require_valid(wish);
  const TextureSize size =
      wish.kind == TextureKind::Overlapping ? overlapping(wish) : isolated(wish);
  if (wish.tilt) require_in_range("Tilt", wish.tilt->degrees(), 0.0, 90.0, "degrees");
  if (wish.tilt && !(wish.tilt->radians() > size.least_tilt.radians()))
    throw InputError(
        "Tilt", fmt::format("{:.3f}°", wish.tilt->degrees()),
        fmt::format("in dimples {:.4g} mm deep the tip of the ball would rub: incline the "
                    "tool by more than {:.3f}°, or choose shallower dimples.",
                    size.depth, size.least_tilt.degrees()));
  return size;
}

}  // namespace patchmill::patch

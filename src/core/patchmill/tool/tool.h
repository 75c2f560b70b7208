// Tool: the one place that knows the shape of a cutter. Its cutting end is a circle of `corner_radius` r whose centre
// runs round the axis at the distance R - r, and above it a flank along the axis or leaning out by the taper: the
// cutter of the APT language (ISO 4343) with R, r and one angle.
//     ball r = R        bull nose 0 < r < R        flat r = 0
// and each of them with a taper: a flat end with one is the cone of V-bits and chamfer mills.
// All of them are a core, a frustum, made thicker by r on all sides: that is what collision checks measure from. The
// tool's centre is the point of the axis at the height r above the tip: of a ball the ball's centre, of a flat end the
// tip itself.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/angle.h"
#include "patchmill/tool/shaft.h"

#include <optional>

namespace patchmill {

enum class CutterShape : std::uint8_t {
  Ball,
  BullNose,
  Flat,
  TaperedBall,
  TaperedBullNose,
  Conical
};

/// "ball end mill", "bull nose end mill", "flat end mill"; with a taper "tapered ball end mill", "tapered bull nose end
/// mill", "conical end mill".
const char* name(CutterShape shape);

/// A cutter with all that is above it.
struct Tool {
  double radius =
      0.0;  ///< R [mm], > 0: of the cutting end without its taper: of the ball, or of a cone's flat tip
  int flutes = 0;                                      ///< N
  std::optional<double> corner_radius = std::nullopt;  ///< r [mm], 0 .. R; not given: R
  Angle taper = {};  ///< between flank and axis, in [0, 60] degrees
  Shaft shaft = {};  ///< what is above the cutting end

  /// Radius r of the corner [mm]: how far the tool's centre is above its tip.
  double corner() const { return corner_radius.value_or(radius); }
  /// Whether it is a ball end mill, without a taper.
  bool is_ball() const { return corner() == radius && taper.radians() == 0.0; }
  /// Its kind, from its radii and taper.
  CutterShape shape() const;

  /// Height above the tip of the cutting surface at `distance` from the axis [mm]; infinite where it does not reach
  /// so far. Convex, and 0 at the axis.
  double height_at(double distance) const;
  /// Its slope there; infinite at the widest place of a flank along the axis.
  double slope_at(double distance) const;
  /// Distance from the axis at which the cutting surface has a slope > 0 [mm]: where the cutter touches a plane of
  /// that slope.
  double distance_at_slope(double slope) const;

  /// The core of the cutting part up to `height` above the tip [mm]; the cutter is all points within corner() of it.
  Frustum core(double height) const;

  /// Core of the cutting end as checks take it: up to the height R, as a ball's, or as far as it has edges.
  Frustum end_core() const;
  /// All that is above the cutting end, from below to above: edges, shank and holder as far as they are known.
  std::vector<ToolSection> sections() const;
};

/// Whether two tools are the same in all; a corner that is not given is that of a ball.
bool operator==(const Tool& a, const Tool& b);

/// Errors: InputError naming ToolDiameter, CornerRadius or TaperAngle, or what require_valid(Shaft) names.
void require_valid(const Tool& tool);

/// Refuses what is no ball end mill. Errors: InputError naming ToolController with the kind of tool; `work` is what
/// needs a ball, as "textures are milled".
void require_ball(const Tool& tool, const char* work);

/// Height of the ridge that the tool leaves on a flat between passes `cross_feed` apart [mm]: none while its own flat
/// bottom covers it, r beyond the width of a cutter without a taper. Errors: InputError naming CrossFeed (negative,
/// or not finite).
double scallop_height(const Tool& tool, double cross_feed);

}  // namespace patchmill

// Profiles of cutters; see tool.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/tool/tool.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/require.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace patchmill {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

}  // namespace

const char* name(CutterShape shape) {
  switch (shape) {
    case CutterShape::Ball:
      return "ball end mill";
    case CutterShape::BullNose:
      return "bull nose end mill";
    case CutterShape::Flat:
      return "flat end mill";
    case CutterShape::TaperedBall:
      return "tapered ball end mill";
    case CutterShape::TaperedBullNose:
      return "tapered bull nose end mill";
    default:
      return "conical end mill";
  }
}

CutterShape Tool::shape() const {
  const bool tapers = taper.radians() > 0.0;
  if (corner() == radius) return tapers ? CutterShape::TaperedBall : CutterShape::Ball;
  if (corner() > 0.0) return tapers ? CutterShape::TaperedBullNose : CutterShape::BullNose;
  return tapers ? CutterShape::Conical : CutterShape::Flat;
}

double Tool::height_at(double distance) const {
  const double r = corner(), out = distance - (radius - r);
  if (out <= 0.0) return 0.0;
  const double a = taper.radians(), last = r * std::cos(a);  // where the circle meets the flank
  if (out <= last) return r - std::sqrt(std::max(0.0, r * r - out * out));
  return a > 0.0 ? r - r * std::sin(a) + (out - last) / std::tan(a) : kInfinite;
}

double Tool::slope_at(double distance) const {
  const double r = corner(), out = distance - (radius - r);
  if (out <= 0.0) return 0.0;
  const double a = taper.radians();
  if (out < r * std::cos(a)) return out / std::sqrt(r * r - out * out);
  return a > 0.0 ? 1.0 / std::tan(a) : kInfinite;
}

double Tool::distance_at_slope(double slope) const {
  const double r = corner(),
               steepest = taper.radians() > 0.0 ? 1.0 / std::tan(taper.radians()) : kInfinite;
  const double s = std::min(slope, steepest);
  return radius - r + (std::isinf(s) ? r : r * s / std::hypot(1.0, s));
}

Frustum Tool::core(double height) const {
  const double r = corner(), to = std::max(height, r * (1.0 + 1e-9) + 1e-9);
  return {r, to, radius - r, radius - r + (to - r) * std::tan(taper.radians())};
}

Frustum Tool::end_core() const {
  constexpr double kDisc = 1e-6;  // thickness of a core that has no height [mm]
  const double edges = shaft.cutting_length > 0.0 ? shaft.cutting_length - corner() : radius;
  return core(std::max(corner() + kDisc, std::min(radius, edges)));
}

std::vector<ToolSection> Tool::sections() const {
  std::vector<ToolSection> out;
  const double r = corner(), a = taper.radians(), slant = std::tan(a);
  const double begin = r * (1.0 - std::sin(a)),
               width = radius - r + r * std::cos(a);  // of the flank
  const double out_of_holder = shaft.stick_out > 0.0 ? shaft.stick_out : kInfinite;
  const double edges = std::max(begin, std::min(shaft.cutting_length, out_of_holder));
  if (edges > begin)
    out.push_back({ToolPart::Flute, begin, edges, width, width + (edges - begin) * slant});
  if (shaft.stick_out > edges && shaft.shank_radius > 0.0)
    out.push_back(
        {ToolPart::Shank, edges, shaft.stick_out, shaft.shank_radius, shaft.shank_radius});
  for (const Frustum& f : shaft.holder)
    out.push_back({ToolPart::Holder, f.from, f.to, f.radius_from, f.radius_to});
  return out;
}

bool operator==(const Tool& a, const Tool& b) {
  return a.radius == b.radius && a.flutes == b.flutes && a.corner() == b.corner() &&
         a.taper == b.taper && a.shaft == b.shaft;
}

void require_valid(const Tool& tool) {
  require_positive("ToolDiameter", 2.0 * tool.radius, "mm");
  require_in_range("CornerRadius", tool.corner(), 0.0, tool.radius, "mm");
  require_in_range("TaperAngle", tool.taper.degrees(), 0.0, 60.0, "degrees");
  require_valid(tool.shaft);
}

void require_ball(const Tool& tool, const char* work) {
  if (tool.is_ball()) return;
  throw InputError("ToolController", name(tool.shape()),
                   fmt::format("{} with a ball end mill: choose one.", work));
}

double scallop_height(const Tool& tool, double cross_feed) {
  require_finite("CrossFeed", cross_feed, "mm");
  if (cross_feed < 0.0)
    throw InputError("CrossFeed", fmt::format("{:g} mm", cross_feed), "give 0 or more.");
  const double r = tool.corner(), half = std::max(0.0, 0.5 * cross_feed - (tool.radius - r));
  if (half == 0.0) return 0.0;
  const double at = half + tool.radius - r;
  return tool.height_at(tool.taper.radians() > 0.0 ? at : std::min(at, tool.radius));
}

}  // namespace patchmill

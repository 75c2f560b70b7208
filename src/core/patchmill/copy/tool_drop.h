// A cutter of any convex profile lowered along z until it touches the model, for those that are no ball. Over a
// triangle the height of its tip,
//     f(q) = z(q) - h(|q - p|),   h the cutter's profile (Tool::height_at),  p the place of its axis,
// is concave, since h is convex and rises outwards: the largest lies where the face has the slope of the profile, and
// if that place is not on the face, on an edge, where the slope of f is halved in on. The tree's boxes bound f by their
// top and their distance from the axis (branch and bound).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/copy/drop_probe.h"
#include "patchmill/tool/tool.h"

#include <optional>

namespace patchmill::copy {

/// Height z [mm] of the tool's centre (tool.h) where the tool, thicker by `allowance` [mm, >= 0] on all sides, rests
/// with its axis over (x, y) [mm]; kNoContact where nothing holds it. Of a ball exact as drop_ball; else exact to
/// rounding for a cutter of 1 - 1e-12 of the radius.
double drop_tool(const mesh::TriangleBvh& bvh, double x, double y, const Tool& tool,
                 double allowance);

/// The same from place to place: a ball with a DropProbe; any other cutter begins at the triangle that held it last.
/// The tree must outlive the probe. A probe serves one thread.
class ToolProbe {
 public:
  /// As drop_tool.
  ToolProbe(const mesh::TriangleBvh& bvh, const Tool& tool, double allowance);
  /// Height z [mm] of the tool's centre over (x, y) [mm], as drop_tool.
  double operator()(double x, double y);

 private:
  const mesh::TriangleBvh* bvh_;
  Tool thick_;  // with the allowance
  std::optional<DropProbe> ball_;
  std::int32_t triangle_ = -1;
};

}  // namespace patchmill::copy

// Matsuda's arrays: straight rows cut at constant feed and speed with a two-flute mill, the tool
// lifted back to the start between rows; the turns of the way back set the shift from row to row.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "arrays.h"

namespace patchmill::test {

struct RowMaker {
  Tool ball{1.0, 2};
  Vec3 axis = tilted_axis(kPi / 4, kPi / 2);
  double feed_per_tooth = 0.5, cross_feed = 0.4;
  int marks = 12, rows = 8;
  double lift = 0.5;  // of the way back

  /// `shift(j)`: of row j + 1 against row j, share of the feed per tooth.
  template <class Shift>
  ToolPath path(Shift&& shift) const {
    ToolPath out;
    out.tool = ball;
    out.spindle = {20.0, SpindleSense::M3};
    const double teeth = marks + 1.0, tooth = 1.0 / ball.flutes;
    const auto pose = [&](double x, int j, double z) {
      return pose_of_ball({x, j * cross_feed, z + ball.radius}, axis, ball.radius);
    };
    const double x0 = -0.7 * feed_per_tooth, x1 = x0 + teeth * feed_per_tooth;
    out.start = pose(x0, 0, 0.0);
    for (int j = 0; j < rows; ++j) {
      if (j > 0) {
        // marks of a row come later, and so farther along, by what the turns lack to whole teeth
        out.moves.push_back({pose(x1, j - 1, lift), 1.0, kNoDimple, MoveKind::Link});
        out.moves.push_back(
            {pose(x0, j, lift), 2.0 - shift(j - 1) * tooth, kNoDimple, MoveKind::Link});
        out.moves.push_back({pose(x0, j, 0.0), 1.0, kNoDimple, MoveKind::Link});
      }
      out.moves.push_back({pose(x1, j, 0.0), teeth * tooth, kNoDimple, MoveKind::Cut});
    }
    return out;
  }

  marks::SurfaceGrid grid(double step) const {
    return marks::flat_grid(plane_z0(), {0.0, -0.2},
                            {marks * feed_per_tooth - 0.5, (rows - 1) * cross_feed + 0.2}, step);
  }
};

}  // namespace patchmill::test

// Lines over a part: how far they are from where the tool would rest.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/copy/scanning.h"

#include "patchmill/copy/copy_milling.h"
#include "patchmill/copy/drop_cutter.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace patchmill::copy {
namespace {

// A groove with flat flanks and a sharp bottom, along y: where the centre of the ball turns from one flank to the
// other, a line that cuts the corner stays above the part.
mesh::TriangleMesh groove() {
  const double profile[5][2] = {{0, 0}, {20, 0}, {20, 8}, {10.3, 3}, {0, 8}};
  mesh::TriangleMesh m;
  for (const double y : {0.0, 20.0})
    for (const auto& p : profile) m.vertices.push_back({p[0], y, p[1]});
  for (std::int32_t i = 0; i < 5; ++i) {
    const std::int32_t j = (i + 1) % 5;
    m.triangles.push_back({i, i + 5, j});
    m.triangles.push_back({j, i + 5, j + 5});
    if (i == 3 || j == 3) continue;
    m.triangles.push_back({3, i, j});
    m.triangles.push_back({8, j + 5, i + 5});
  }
  return m;
}

TEST(CopyMilling, LinesStayWithinTheToleranceOfTheSurfaceOnBothSides) {
  const mesh::TriangleBvh part(groove());
  CopyOptions options;
  options.tool = {3.0, 2};
  options.spindle.speed = 100.0;
  options.feed = 400.0 / 60.0;
  options.radial_depth = 2.0;
  options.axial_depth = 20.0;  // one layer, on the surface
  options.stock.include(Vec3::Zero());
  options.stock.include(Vec3(20, 20, 8));
  const ToolPath path = copy_mill(part, options).path;
  double above = 0.0, below = 0.0;
  int seen = 0;
  Vec3 from = ball_centre(path.start, 3.0);
  for (const Move& move : path.moves) {
    const Vec3 to = ball_centre(move.end, 3.0);
    for (int i = 0; i <= 20 && move.kind == MoveKind::Cut; ++i) {
      const Vec3 c = from + 0.05 * i * (to - from);
      if (c.x() < 1.0 || c.x() > 19.0 || c.y() < 1.0 || c.y() > 19.0) continue;
      const double off = c.z() - drop_ball(part, c.x(), c.y(), 3.0);
      above = std::max(above, off);
      below = std::max(below, -off);
      ++seen;
    }
    from = to;
  }
  EXPECT_GT(seen, 1000);
  EXPECT_LE(above, options.tolerance);
  EXPECT_LE(below, options.tolerance);
}

}  // namespace
}  // namespace patchmill::copy

// The simulator against the slow swept edge, with the feed as fast as textures are cut: tilted
// tools, a corner of the path, helix, runout, a tool axis that turns, a recorded motion.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "arrays.h"
#include "swept_edge.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace patchmill::marks {
namespace {

using test::SweptEdge;
using test::ToolAt;

constexpr double kStock = 0.06;

/// A path of straight pieces of equal turns through `tips`, the axis swung from `axis` about
/// `hinge` by `swing` over the whole of it.
struct Way {
  std::vector<Vec3> tips;
  double turns = 0.5;  // of each piece
  Vec3 axis = test::tilted_axis(kPi / 6, 0.4);
  double swing = 0.0;
  Vec3 hinge = Vec3::UnitX();
  double phase = 0.7;
  double sense = -1.0;

  std::size_t pieces() const { return tips.size() - 1; }
  Eigen::AngleAxisd swung(double share) const { return {share * swing, hinge}; }

  /// The tool at share 0..1 of the whole way.
  ToolAt at(double share) const {
    const double place = share * static_cast<double>(pieces());
    const auto k = std::min(static_cast<std::size_t>(place), pieces() - 1);
    ToolAt tool;
    tool.tip = tips[k] + (place - static_cast<double>(k)) * (tips[k + 1] - tips[k]);
    tool.axis = swung(share) * axis;
    tool.housing_x = swung(share) * default_housing_x(axis);
    tool.spindle = phase + sense * 2.0 * kPi * turns * place;
    return tool;
  }

  ToolPath path(int flutes) const {
    ToolPath out;
    out.tool = {1.0, flutes};
    out.spindle = {20.0, sense < 0 ? SpindleSense::M3 : SpindleSense::M4};
    out.start = {tips[0], axis};
    for (std::size_t k = 1; k < tips.size(); ++k) {
      const ToolAt end = at(static_cast<double>(k) / static_cast<double>(pieces()));
      out.moves.push_back({{tips[k], end.axis}, turns, kNoDimple, MoveKind::Cut});
    }
    return out;
  }

  MotionOptions options() const {
    MotionOptions out;
    out.start_phase = Angle::radians(phase);
    for (std::size_t k = 0; k < tips.size(); ++k)
      out.housing_x.push_back(at(static_cast<double>(k) / static_cast<double>(pieces())).housing_x);
    out.chord_tolerance = 1e-7;
    return out;
  }
};

/// Two rows with a corner between them, half a millimetre per half turn, the ball touching z = 0.
Way two_rows() {
  Way way;
  for (int i = 0; i <= 4; ++i) way.tips.push_back({0.5 * i, 0.0, 0.0});
  for (int i = 4; i >= 0; --i) way.tips.push_back({0.5 * i, 0.5, 0.0});
  return way;
}

void lower_tips_to_touch(Way& way) {
  for (std::size_t k = 0; k < way.tips.size(); ++k) {
    const ToolAt tool = way.at(static_cast<double>(k) / static_cast<double>(way.pieces()));
    way.tips[k].z() = 1.0 - tool.axis.z();
  }
}

/// Rows of cells right on the way of the tip, but none on the corner of it.
SurfaceGrid small_grid() {
  return flat_grid(test::plane_z0(), {0.303, -0.3}, {2.103, 0.8}, 0.02);
}

/// Largest difference of the two reliefs; cells at the rim of the stock count as well.
double largest_difference(const Relief& a, const Relief& b) {
  double most = 0.0;
  for (std::size_t k = 0; k < a.height.size(); ++k)
    most = std::max(most, std::abs(double{a.height[k]} - double{b.height[k]}));
  return most;
}

Relief reference(const Way& way, const Cutter& cutter, double most_kappa = 1.4) {
  SweptEdge swept;
  swept.flutes = cutter.ball.flutes;
  swept.sense = way.sense;
  swept.helix = std::tan(cutter.helix.radians()) / cutter.ball.radius;
  swept.runout = cutter.runout;
  swept.time_steps = static_cast<int>(1500 * way.turns) * static_cast<int>(way.pieces());
  swept.edge_steps = 240;
  Relief relief;
  relief.grid = small_grid();
  relief.stock = kStock;
  relief.height.assign(static_cast<std::size_t>(relief.grid.cells()), static_cast<float>(kStock));
  swept.mill([&](double t) { return way.at(t); }, most_kappa, relief);
  return relief;
}

double difference(const Way& way, const Cutter& cutter) {
  const Relief simulated = simulate_marks(motion_of(way.path(cutter.ball.flutes), way.options()),
                                          cutter, small_grid(), {kStock})
                               .relief;
  EXPECT_LT(*std::min_element(simulated.height.begin(), simulated.height.end()), 0.01);
  return largest_difference(simulated, reference(way, cutter));
}

constexpr double kWithin = 1e-4;  // [mm]

TEST(Reference, TiltedToolRoundACorner) {
  for (const double towards : {0.4, 1.9, 3.9}) {
    Way way = two_rows();
    way.axis = test::tilted_axis(kPi / 6, towards);
    lower_tips_to_touch(way);
    EXPECT_LT(difference(way, {{1.0, 2}, {}, {}}), kWithin) << towards;
  }
}

TEST(Reference, SteepToolTurningTheOtherWay) {
  Way way = two_rows();
  way.axis = test::tilted_axis(kPi / 3, -1.0);
  way.sense = 1.0;
  lower_tips_to_touch(way);
  EXPECT_LT(difference(way, {{1.0, 2}, {}, {}}), kWithin);
}

TEST(Reference, HelixAndRunout) {
  Way way = two_rows();
  lower_tips_to_touch(way);
  EXPECT_LT(difference(way, {{1.0, 2}, Angle::degrees(30), {0.0, -0.005}}), kWithin);
}

TEST(Reference, TurningAxis) {
  Way way = two_rows();
  way.swing = 0.5;
  way.hinge = way.axis.cross(Vec3(0.3, 1.0, 0.2)).normalized();
  lower_tips_to_touch(way);
  EXPECT_LT(difference(way, {{1.0, 2}, {}, {}}), kWithin);
}

TEST(Reference, FourFlutesOfASlightlyTiltedTool) {
  Way way = two_rows();
  way.axis = test::tilted_axis(kPi / 9, 0.4);
  way.turns = 0.25;
  lower_tips_to_touch(way);
  EXPECT_LT(difference(way, {{1.0, 4}, {}, {}}), kWithin);
}

// The zigzag of Xu & Sasahara with a tool whose tip lies within the mark: many turns per dimple, most of
// them lifted clear.
TEST(Reference, ZigzagOfANearlyUprightTool) {
  for (const double tilt : {3.0, 10.0}) {
    Way way;
    way.axis = test::tilted_axis(tilt * kPi / 180.0, 0.4);
    for (int i = 0; i <= 4; ++i) way.tips.push_back({0.25 * i + 0.4, 0.2, i % 2 == 0 ? 0.0 : 0.9});
    way.turns = 2.55;
    for (Vec3& tip : way.tips) tip.z() += 1.0 - way.axis.z();
    EXPECT_LT(difference(way, {{1.0, 2}, {}, {}}), kWithin) << tilt;
  }
}

// Straight on, so that the times at which a cell near the axis may be cut are known in closed form.
TEST(Reference, StraightRowsPastTheTip) {
  for (const double tilt : {11.0, 15.0, 27.0})
    for (const double feed : {0.25, 0.38, 0.7}) {  // per tooth
      Way way;
      way.tips = {{-0.3, 0.2, 0.0}, {2.7, 0.26, 0.0}};
      way.axis = test::tilted_axis(tilt * kPi / 180.0, 2.5 - tilt);
      way.sense = feed > 0.3 ? 1.0 : -1.0;
      way.turns = 3.0 / (3.0 * feed);
      lower_tips_to_touch(way);
      EXPECT_LT(difference(way, {{1.0, 3}, {}, {}}), kWithin) << tilt << " " << feed;
    }
}

TEST(Reference, TipAlongAFlatRow) {
  Way way = two_rows();
  way.axis = test::tilted_axis(kPi / 36, 0.4);
  lower_tips_to_touch(way);
  EXPECT_LT(difference(way, {{1.0, 2}, {}, {}}), kWithin);
}

// The same motion, sampled as a machine would log it.
TEST(Reference, RecordedMotion) {
  Way way = two_rows();
  lower_tips_to_touch(way);
  std::vector<MotionSample> samples;
  const int steps = 40 * static_cast<int>(way.pieces());
  for (int i = 0; i <= steps; ++i) {
    const ToolAt tool = way.at(static_cast<double>(i) / steps);
    samples.push_back({0.001 * i, tool.tip, tool.axis, tool.spindle, tool.housing_x});
  }
  const Cutter cutter{{1.0, 2}, {}, {}};
  const Relief recorded =
      simulate_marks(motion_of(samples, SpindleSense::M3, 1.0), cutter, small_grid(), {kStock})
          .relief;
  const Relief planned =
      simulate_marks(motion_of(way.path(2), way.options()), cutter, small_grid(), {kStock}).relief;
  EXPECT_LT(largest_difference(recorded, planned), 1e-6);
}

}  // namespace
}  // namespace patchmill::marks

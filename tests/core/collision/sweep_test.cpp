// What a tool sweeps on a move against very many of its positions, and checks by it against steps that are taken one
// by one; where the tool gouges a check asks for hardly more distances than where it does not.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/collision/sweep.h"

#include "patchmill/collision/mesh_distance.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <random>

#include <gtest/gtest.h>

namespace patchmill::collision {
namespace {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double number(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(engine_);
  }
  Vec3 vector(double most) {
    return {number(-most, most), number(-most, most), number(-most, most)};
  }

 private:
  std::mt19937 engine_;
};

TEST(Sweep, IsTheLeastOfAllPositionsAndBoundsWhatIsAround) {
  Random random(11);
  for (int k = 0; k < 2000; ++k) {
    const Frustum frustum{0.5, random.number(0.6, 6.0), random.number(0.0, 3.0),
                          random.number(0.0, 3.0)};
    const Vec3 axis = random.vector(1.0).normalized(), travel = random.vector(4.0);
    const Vec3 p = random.vector(6.0), q = p + random.vector(3.0);
    const SweptDistance found = swept_distance(frustum, Vec3::Zero(), axis, travel, p);
    double least = 1e9, least_there = 1e9;
    for (int i = 0; i <= 400; ++i) {
      const Vec3 origin = i / 400.0 * travel;
      least = std::min(least, frustum_distance(frustum, origin, axis, p).value);
      least_there = std::min(least_there, frustum_distance(frustum, origin, axis, q).value);
    }
    ASSERT_LE(found.value, least + 1e-9);
    ASSERT_GE(found.value, least - travel.norm() / 800.0);
    ASSERT_NEAR(frustum_distance(frustum, found.fraction * travel, axis, p).value, found.value,
                1e-12);
    ASSERT_LE(found.value + found.gradient.dot(q - p), least_there + 2e-9);
  }
}

/// A block with a rough top: a height field of random heights, closed below.
mesh::TriangleMesh rough_block(Random& random, int n, double rough) {
  mesh::TriangleMesh mesh;
  for (const double bottom : {0.0, 1.0})
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        mesh.vertices.emplace_back(i, j, bottom > 0.0 ? -5.0 : random.number(-rough, 0.0));
  const int layer = (n + 1) * (n + 1);
  const auto at = [&](int i, int j, int below) { return below * layer + j * (n + 1) + i; };
  const auto quad = [&](int a, int b, int c, int d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      quad(at(i, j, 0), at(i + 1, j, 0), at(i + 1, j + 1, 0), at(i, j + 1, 0));
      quad(at(i, j, 1), at(i, j + 1, 1), at(i + 1, j + 1, 1), at(i + 1, j, 1));
    }
  for (int i = 0; i < n; ++i) {
    quad(at(i, 0, 1), at(i + 1, 0, 1), at(i + 1, 0, 0), at(i, 0, 0));
    quad(at(i + 1, n, 1), at(i, n, 1), at(i, n, 0), at(i + 1, n, 0));
    quad(at(0, i + 1, 1), at(0, i, 1), at(0, i, 0), at(0, i + 1, 0));
    quad(at(n, i, 1), at(n, i + 1, 1), at(n, i + 1, 0), at(n, i, 0));
  }
  return mesh;
}

const std::vector<ToolSection> kTool = {{ToolPart::Flute, 0.8, 3.0, 0.8, 0.8},
                                        {ToolPart::Shank, 3.0, 6.0, 1.5, 1.5},
                                        {ToolPart::Holder, 6.0, 12.0, 3.0, 4.0}};
const ClearanceOptions kOptions{0.01, 0.1, 0.01, 100000};

/// Random moves over the block and into it, of a ball end mill or another; half of them turn.
ToolPath random_path(Random& random, int n, const Tool& tool) {
  ToolPath path;
  path.tool = tool;
  path.spindle.speed = 10.0;
  const auto pose = [&](bool turn) {
    const Vec3 axis =
        Vec3(turn ? random.number(-0.8, 0.8) : 0.0, turn ? random.number(-0.8, 0.8) : 0.0, 1.0);
    return ToolPose{
        {random.number(1.0, n - 1.0), random.number(1.0, n - 1.0), random.number(-1.0, 4.0)},
        axis.normalized()};
  };
  path.start = pose(false);
  for (int k = 0; k < 12; ++k) path.moves.push_back({pose(k > 5), 0.5, kNoDimple, MoveKind::Cut});
  return path;
}

/// Depth of each part of the tool on each move: 0 where it is not too near.
std::vector<double> depths(const ClearanceReport& report, std::size_t moves) {
  std::vector<double> depth(moves * 5, 0.0);
  for (const ClearanceFinding& f : report.findings) {
    double& d = depth[static_cast<std::size_t>(f.move) * 5 + static_cast<std::size_t>(f.part)];
    EXPECT_EQ(d, 0.0) << "a part of the tool is reported twice on one move";
    d = f.depth;
  }
  return depth;
}

/// The part, of which nothing is known about a tool that moves: moves are walked in steps.
PartShape without_sweeps(const PartShape& part) {
  PartShape shape = part;
  shape.swept = [=](const ToolSection& section, const ToolPose& pose, const Vec3& travel,
                    double enough, double within) {
    SweptSection found;
    found.inside = section.part == ToolPart::Ball || !travel.isZero();
    return found.inside ? found : part.swept(section, pose, travel, enough, within);
  };
  return shape;
}

const double kDeep[] = {0.0, 0.0, 0.8, 1.5, 3.0};  // radius of a ball in flute, shank and holder

TEST(Sweep, ChecksFindWhatStepsFind) {
  Random random(5);
  int violated = 0, clear = 0;
  for (int k = 0; k < 12; ++k) {
    const int n = 8;
    PartShape part = shape_from_mesh(rough_block(random, n, k % 3 == 0 ? 0.0 : 2.0));
    const Tool tool = k % 4 == 3 ? Tool{0.8, 2, 0.2} : Tool{0.8, 2};
    const ToolPath path = random_path(random, n, tool);
    const auto swept = depths(check_sections(path, kTool, part, kOptions), path.moves.size());
    part = without_sweeps(part);
    const auto stepped = depths(check_sections(path, kTool, part, kOptions), path.moves.size());
    for (std::size_t i = 0; i < swept.size(); ++i) {
      const bool bad = stepped[i] > 0.0;
      (bad ? violated : clear) += 1;
      if (std::max(swept[i], stepped[i]) < 0.02)
        continue;  // what is no deeper than the resolution may be missed
      ASSERT_EQ(swept[i] > 0.0, bad) << k << ' ' << i;
      // a section so deep may be all inside at one place and reach out at another: two ways to say how deep
      if (i % 5 >= 2 && stepped[i] > kDeep[i % 5]) continue;
      // both are within a tenth of what is true, or within the resolution
      ASSERT_NEAR(swept[i], stepped[i], 0.15 * std::max(swept[i], stepped[i]) + 0.011)
          << k << ' ' << i;
    }
  }
  EXPECT_GT(violated, 30);
  EXPECT_GT(clear, 30);
}

/// The part, with its distances counted.
PartShape counted(const PartShape& part, std::shared_ptr<std::atomic<long>> count) {
  PartShape shape([=](const Vec3& p) { return ++*count, part.distance(p); });
  shape.section = [=](const ToolSection& section, const ToolPose& pose, double enough) {
    return ++*count, part.section(section, pose, enough);
  };
  shape.swept = [=](const ToolSection& section, const ToolPose& pose, const Vec3& travel,
                    double enough, double within) {
    return ++*count, part.swept(section, pose, travel, enough, within);
  };
  return shape;
}

/// A ball that goes to and fro over a plane top, its lowest point at `height`; every other move turns by a degree.
ToolPath gliding(double height) {
  ToolPath path;
  path.tool = {0.8, 2};
  path.spindle.speed = 10.0;
  for (int k = 0; k <= 200; ++k) {
    const double tilt = kPi / 180.0 * (30 + k / 2 % 2);
    const Vec3 axis(std::sin(tilt), 0.0, std::cos(tilt));
    const ToolPose pose =
        pose_of_ball({2.0 + 3.0 * (k % 2), 2.0 + 0.02 * k, 0.8 + height}, axis, 0.8);
    if (k == 0)
      path.start = pose;
    else
      path.moves.push_back({pose, 0.5, kNoDimple, MoveKind::Cut});
  }
  return path;
}

TEST(Sweep, AGougeTakesNoMoreDistancesThanTwiceAClearPath) {
  Random random(3);
  const PartShape part = shape_from_mesh(rough_block(random, 8, 0.0));
  const auto asked = [&](double height, ClearanceOutcome outcome) {
    const auto count = std::make_shared<std::atomic<long>>(0);
    EXPECT_EQ(check_sections(gliding(height), {kTool[0]}, counted(part, count), kOptions).outcome,
              outcome);
    return count->load();
  };
  const long clear = asked(-0.009, ClearanceOutcome::Clear);
  EXPECT_LE(clear, 200 * 2 * 3);
  for (const double depth : {0.0201, 0.03, 0.1, 0.3})
    EXPECT_LE(asked(-depth, ClearanceOutcome::Violated), 2 * clear) << depth;
}

TEST(Sweep, NoMoveIsBegunAfterAStop) {
  Random random(3);
  const PartShape part = shape_from_mesh(rough_block(random, 8, 0.0));
  const ToolPath path = gliding(-0.1);
  for (const int after : {1, 7, 50, 150}) {
    int told = 0;
    const auto report = check_sections(path, kTool, part, kOptions, [&](double share) {
      EXPECT_NEAR(share, (told + 1) / 200.0, 1e-12);
      return ++told < after;
    });
    EXPECT_EQ(told, after);
    EXPECT_LE(report.findings.size(), static_cast<std::size_t>(after + 64) * 3);
    EXPECT_FALSE(report.reason.empty());
  }
}

}  // namespace
}  // namespace patchmill::collision

// The two experiments of Kobayashi & Shirase 2014 (section 4, Tables 1 and 2): feed over a smooth
// convex part, posture over an overhanging part; each with the paper's staircase and with the
// smooth reading. With PATCHMILL_DCM_DIR set, the tables for the figures
// (src/patchmill/reports/dcm_plots.py) are written to that folder.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/copy/copy_milling.h"
#include "patchmill/dcm/apply_dcm.h"
#include "patchmill/voxel/voxelise.h"
#include "voxel/shapes.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace patchmill::copy {
namespace {

constexpr double kMinute = 60.0;
constexpr dcm::FeedLimits kFeed{400.0 / kMinute, 800.0 / kMinute};

std::ofstream table(const std::string& name, const std::string& columns) {
  const char* folder = std::getenv("PATCHMILL_DCM_DIR");
  std::ofstream out;
  if (folder) out.open(std::string(folder) + "/" + name + ".csv");
  out << columns << "\n";
  return out;
}

mesh::Box box(const Vec3& lo, const Vec3& hi) {
  mesh::Box b;
  b.include(lo);
  b.include(hi);
  return b;
}

CopyOptions copying(CopyMode mode, const mesh::Box& stock, double feed, double rpm) {
  CopyOptions options;
  options.mode = mode;
  options.tool = {3.0, 2};
  options.spindle.speed = rpm / kMinute;
  options.feed = feed / kMinute;
  options.radial_depth = 2.0;
  options.axial_depth = 2.0;
  options.stock = stock;
  return options;
}

double about_y(const Vec3& axis) {
  return Angle::radians(std::atan2(axis.x(), axis.z())).degrees();
}

// The cuts in the plane y: each run (without a lift between) begins with a line for its first pose;
// then one for each move, where it ends, how far along all cuts, at what feed.
void write_pass(const std::string& name, const ToolPath& path, double y) {
  std::ofstream out = table(name, "run,s,t,x,z,feed,b");
  ToolPose from = path.start;
  int run = 0;
  bool lifted = true;
  double s = 0.0, t = 0.0;
  for (const Move& move : path.moves) {
    const ToolPose begin = from;
    const Vec3 a = ball_centre(from, path.tool.radius), b = ball_centre(move.end, path.tool.radius);
    from = move.end;
    if (move.kind != MoveKind::Cut || std::abs(a.y() - y) > 1e-6 || std::abs(b.y() - y) > 1e-6) {
      lifted = true;
      continue;
    }
    const double length = (b - a).norm(), seconds = duration(move, path.spindle);
    const double feed = seconds > 0 ? kMinute * length / seconds : 0.0;
    const auto line = [&](const Vec3& c, const Vec3& axis) {
      out << fmt::format("{},{:.5f},{:.5f},{:.4f},{:.4f},{:.4f},{:.4f}\n", run, s, t, c.x(), c.z(),
                         feed, about_y(axis));
    };
    if (lifted) {
      ++run;
      line(a, begin.axis);
    }
    lifted = false;
    s += length;
    t += seconds;
    line(b, move.end.axis);
  }
}

// Ends of the cuts of a whole path; `run` counts the lifts.
void write_path(const std::string& name, const ToolPath& path) {
  std::ofstream out = table(name, "run,x,y,z");
  int run = 0;
  for (const Move& move : path.moves) {
    const Vec3 c = ball_centre(move.end, path.tool.radius);
    run += move.kind == MoveKind::Rapid ? 1 : 0;
    if (move.kind != MoveKind::Rapid)
      out << fmt::format("{},{:.3f},{:.3f},{:.3f}\n", run, c.x(), c.y(), c.z());
  }
}

void write_section(const std::string& name, const voxel::VoxelGrid& grid, double y,
                   const std::function<double(std::size_t)>& value) {
  std::ofstream out = table(name, "x,z,kind,value");
  shapes::for_each_cell(grid.table, [&](std::size_t i, const voxel::Cell& c) {
    if (c.y() != grid.frame.cell_at(Vec3(0, y, 0)).y()) return;
    const Vec3 p = grid.frame.centre(c);
    out << fmt::format("{},{},{},{:.6f}\n", p.x(), p.z(), static_cast<int>(grid.kind[i]), value(i));
  });
}

void report(const char* what, const dcm::PathSteps& stairs, const dcm::PathSteps& smooth) {
  const auto line = [&](const char* way, const dcm::PathSteps& steps) {
    std::printf(
        "%s, %s: %ld moves; feed step %.1f mm/min straight on, %.1f at corners; axis step "
        "%.2f deg on the spot, %.2f in a move\n",
        what, way, long(steps.moves), kMinute * steps.feed, kMinute * steps.feed_at_corners,
        steps.axis_at_rest.degrees(), steps.axis_per_move.degrees());
  };
  line("staircase", stairs);
  line("smooth", smooth);
}

struct BothWays {
  ToolPath stairs, smooth;
};

BothWays both_ways(const ToolPath& path, const voxel::VoxelGrid& grid, const dcm::FeedField* feed,
                   const dcm::PostureField* posture) {
  dcm::DcmOptions options;
  options.read_at = dcm::ReadAt::Tip;
  const ToolPath smooth = dcm::apply_dcm(path, grid, feed, posture, options);
  options.reading = dcm::Reading::Nearest;
  return {dcm::apply_dcm(path, grid, feed, posture, options), smooth};
}

// Every timed move's feed is between the limits.
void expect_within_limits(const ToolPath& path) {
  ToolPose from = path.start;
  for (const Move& move : path.moves) {
    const Vec3 a = ball_centre(from, path.tool.radius), b = ball_centre(move.end, path.tool.radius);
    from = move.end;
    if (move.kind == MoveKind::Rapid || (b - a).norm() < 1e-6) continue;
    const double feed = (b - a).norm() / duration(move, path.spindle);
    ASSERT_GE(feed, kFeed.low * (1 - 1e-9));
    ASSERT_LE(feed, kFeed.high * (1 + 1e-9));
  }
}

struct FeedExperiment {
  mesh::TriangleMesh part = shapes::convex_part(60);
  mesh::TriangleBvh bvh{part};
  voxel::VoxelGrid grid;
  dcm::FeedField feed;
  mesh::Box stock = box(Vec3::Zero(), Vec3(50, 50, 36));

  FeedExperiment() {
    voxel::VoxelOptions options;
    options.pitch = 2.0;
    grid = voxel::voxelise(mesh::box_mesh(stock.lo, stock.hi), part, options);
    feed = dcm::steady_feed(grid, kFeed);
  }
};

TEST(Kobayashi, FeedAlongScanningLinesAtY24) {
  const FeedExperiment e;
  write_section("feed_y24", e.grid, 24,
                [&](std::size_t i) { return kMinute * e.feed.along[0][i]; });
  const mesh::Box slice = box(Vec3(0, 24, 0), Vec3(50, 26, 36));
  const ToolPath path = copy_mill(e.bvh, copying(CopyMode::Scanning, slice, 400, 6000)).path;
  const BothWays way = both_ways(path, e.grid, &e.feed, nullptr);
  write_pass("feed_pass_stairs", way.stairs, 24);
  write_pass("feed_pass_smooth", way.smooth, 24);
  expect_within_limits(way.smooth);
  expect_within_limits(way.stairs);
  const dcm::PathSteps stairs = dcm::path_steps(way.stairs), smooth = dcm::path_steps(way.smooth);
  report("feed, scanning", stairs, smooth);
  EXPECT_GT(stairs.feed, 10.0 * smooth.feed);
  EXPECT_LT(statistics(way.smooth).timed_seconds, statistics(path).timed_seconds);
  std::printf("time at Y = 24 and 26: %.1f s at V_Lo, %.1f s with the fields\n",
              statistics(path).timed_seconds, statistics(way.smooth).timed_seconds);
}

TEST(Kobayashi, FeedAlongContourLines) {
  const FeedExperiment e;
  CopyOptions options = copying(CopyMode::Contour, e.stock, 400, 6000);
  options.axial_depth = 12.0;  // every sixth level of the experiment
  const ToolPath path = copy_mill(e.bvh, options).path;
  write_path("contour_path", path);
  const BothWays way = both_ways(path, e.grid, &e.feed, nullptr);
  expect_within_limits(way.smooth);
  const dcm::PathSteps stairs = dcm::path_steps(way.stairs), smooth = dcm::path_steps(way.smooth);
  report("feed, contour", stairs, smooth);
  EXPECT_LE(smooth.feed, stairs.feed);
}

TEST(Kobayashi, PostureAlongScanningLinesOverAnOverhang) {
  const mesh::TriangleMesh part = shapes::overhanging_part(60);
  const mesh::TriangleBvh bvh(part);
  voxel::VoxelOptions voxels;
  voxels.pitch = 2.0;
  const mesh::Box stock = box(Vec3::Zero(), Vec3(76, 50, 40));
  const voxel::VoxelGrid grid = voxel::voxelise(mesh::box_mesh(stock.lo, stock.hi), part, voxels);
  const dcm::PostureField posture = dcm::steady_posture(grid, part, bvh);
  ASSERT_TRUE(posture.outcome.converged);
  const mesh::Box slices = box(Vec3(0, 10, 0), Vec3(76, 40, 40));
  CopyOptions options = copying(CopyMode::ScanningUndercut, slices, 4000, 9000);
  options.radial_depth = 10.0;  // the four planes of the figures
  const ToolPath path = copy_mill(bvh, options).path;
  const BothWays way = both_ways(path, grid, nullptr, &posture);
  for (const int y : {10, 20, 30, 40}) {
    write_section(fmt::format("posture_y{}", y), grid, y,
                  [&](std::size_t i) { return Angle::radians(posture.value[1][i]).degrees(); });
    write_pass(fmt::format("posture_pass_y{}_stairs", y), way.stairs, y);
    write_pass(fmt::format("posture_pass_y{}_smooth", y), way.smooth, y);
  }
  const dcm::PathSteps stairs = dcm::path_steps(way.stairs), smooth = dcm::path_steps(way.smooth);
  report("posture", stairs, smooth);
  EXPECT_GT(stairs.axis_at_rest.degrees(), 5.0);
  EXPECT_LT(smooth.axis_per_move.degrees(), 5.0);
  EXPECT_EQ(smooth.axis_at_rest.degrees(), 0.0);
  double least = 0.0, most = 0.0;
  for (const Move& move : way.smooth.moves) {
    least = std::min(least, about_y(move.end.axis));
    most = std::max(most, about_y(move.end.axis));
  }
  EXPECT_LE(most, 70.0 + 1e-6);  // the limit of the paper, reached below the overhang
  EXPECT_GT(most, 60.0);
  EXPECT_LT(least, -20.0);
}

}  // namespace
}  // namespace patchmill::copy

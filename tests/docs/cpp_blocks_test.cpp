// The C++ blocks of docs/, each compiled and run: what stands around it is what the page says it begins with.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/collision/clearance.h"
#include "patchmill/collision/mesh_distance.h"
#include "patchmill/copy/copy_milling.h"
#include "patchmill/marks/texture_marks.h"
#include "patchmill/patch/boundary.h"
#include "patchmill/patch/cover.h"
#include "patchmill/patch/patch_surface.h"
#include "patchmill/patch/surface_lattice.h"
#include "patchmill/sync/constant_feed.h"
#include "patchmill/sync/contact_azimuth.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace patchmill {
namespace {

constexpr double kSphere = 40.0;  // mm

std::set<std::string>& included() {
  static std::set<std::string> names;
  return names;
}

// A sphere, looked at from above.
std::vector<patch::SurfaceSample> sampler(const std::vector<Vec2>& places) {
  std::vector<patch::SurfaceSample> samples;
  for (const Vec2& p : places) {
    patch::SurfaceSample found;
    if (p.norm() < 0.9 * kSphere) {
      const Vec3 point(p.x(), p.y(), std::sqrt(kSphere * kSphere - p.squaredNorm()));
      found = {{point, point / kSphere}, patch::DimpleState::Cut};
    }
    samples.push_back(found);
  }
  return samples;
}

std::int64_t cut(const patch::Dimples& dimples) {
  return patch::count_states(dimples)[static_cast<std::size_t>(patch::DimpleState::Cut)];
}

TEST(DocsBlocks, CopyMillingOfAMesh) {
  const mesh::TriangleMesh stock_mesh = mesh::box_mesh({0, 0, 0}, {20, 20, 10});
  const mesh::TriangleMesh part_mesh = mesh::box_mesh({5, 5, 0}, {15, 15, 6});
#include "copy-milling_1.inc"
  included().insert("copy-milling_1.inc");
  ASSERT_GT(path.moves.size(), 20u);
  collision::ClearanceOptions limits;
  limits.tolerance = 0.06;
  const auto found =
      collision::check_clearance(path, collision::shape_from_mesh(part_mesh), limits);
  EXPECT_EQ(found.outcome, collision::ClearanceOutcome::Clear);
}

TEST(DocsBlocks, MarksOfATexture) {
  const patch::TexturePlane plane;
  const Vec2 low(6.0, -2.0), high(10.0, 2.0);
  patch::Dimples dimples = *patch::sample_patches(
      patch::cover({patch::PatchShape::Square, 0.5, 14}, {Vec2(4, -4), Vec2(12, 4)}), plane,
      sampler, {patch::SurfaceKind::Curved});
  sync::mark_tool_tip(dimples, Vec3::UnitZ(), Angle::degrees(3));
  const Spindle spindle{1000.0 / 60.0, SpindleSense::M3};
  const sync::PhaseRule rule{sync::FluteChoice::Same, 5.0, {}};
  const sync::ConstantFeed planned{434.413 / 60.0, rule, 45.0, 50.0};
  const ToolPath path = sync::constant_feed_path(dimples, {1.0, 2}, spindle, planned, Decimals(3));
  std::vector<Vec2> places;
  for (const patch::Dimple& d : dimples)
    if (d.state == patch::DimpleState::Cut) places.push_back(d.surface.position.head<2>());
#include "cutter-marks_1.inc"
  included().insert("cutter-marks_1.inc");
  EXPECT_GT(part.comparison.matches.size(), 40u);
  EXPECT_LT(part.comparison.rms_move, 0.02);
}

TEST(DocsBlocks, LatticeOnASurface) {
  const patch::TexturePlane plane;
  const Vec2 start(8.0, 0.0);
  const patch::Box2 area(Vec2(4, -4), Vec2(12, 4));
#include "on-surface_1.inc"
  included().insert("on-surface_1.inc");
  EXPECT_GT(cut(dimples), 200);
  EXPECT_NEAR(spread.least, 1.0, 0.01);  // a Chebyshev net keeps the spacing along both steps
}

TEST(DocsBlocks, PatchesOnASurface) {
  const patch::TexturePlane plane;
  const patch::Box2 area(Vec2(-10, -10), Vec2(10, 10));
#include "patch-division_1.inc"
  included().insert("patch-division_1.inc");
  EXPECT_GT(cut(dimples), 1000);
}

TEST(DocsBlocks, AllAreRunHere) {
  const std::set<std::string> all = {
#include "all.inc"
  };
  EXPECT_EQ(included(), all);
}

}  // namespace
}  // namespace patchmill

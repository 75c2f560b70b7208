// The whole way from a face to its ToolPath: the same bytes on one thread and on many; progress rises and
// a stop is heeded.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/face_sampler.h"
#include "faces.h"
#include "patchmill/patch/boundary.h"
#include "patchmill/patch/cover.h"
#include "patchmill/patch/patch_surface.h"
#include "patchmill/sync/constant_feed.h"
#include "patchmill/sync/contact_azimuth.h"

#include <cstring>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace patchmill {
namespace {

constexpr double kSize = 60.0;

std::optional<patch::Dimples> dimples_of(patch::SurfaceKind kind, const Progress& progress = {}) {
  const patch::TexturePlane plane;
  const FaceSampler sampler({wavy_face(kSize, 100)}, plane, Angle::degrees(80));
  const Vec2 half = Vec2::Constant(0.5 * kSize);
  const patch::PatchDivision division =
      patch::cover({patch::PatchShape::Square, 0.15, 14}, patch::Box2(-half, half));
  const patch::SurfaceSampler sample = [&](const std::vector<Vec2>& places) {
    return sampler.sample(places);
  };
  return patch::sample_patches(division, plane, sample, {kind}, progress);
}

ToolPath path_of(patch::SurfaceKind kind) {
  patch::Dimples dimples = *dimples_of(kind);
  sync::mark_tool_tip(dimples, Vec3::UnitZ(), Angle::degrees(1));
  patch::drop_slivers(dimples, 10);
  const sync::PhaseRule rule{sync::FluteChoice::Same, 5.0, {}};
  return sync::constant_feed_path(dimples, {1.0, 2}, {1000.0 / 60.0, SpindleSense::M3},
                                  {434.413 / 60.0, rule, kSize, kSize + 1.0}, Decimals(3));
}

TEST(Texture, SameBytesOnOneThreadAndOnMany) {
  for (patch::SurfaceKind kind :
       {patch::SurfaceKind::Planar, patch::SurfaceKind::Pyramid, patch::SurfaceKind::Curved}) {
    const ToolPath many = path_of(kind);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const ToolPath single = path_of(kind);
    ASSERT_GT(many.moves.size(), 200000u);
    ASSERT_EQ(many.moves.size(), single.moves.size());
    for (std::size_t i = 0; i < many.moves.size(); ++i) {
      const Move &a = many.moves[i], &b = single.moves[i];
      ASSERT_EQ(a.end.tip, b.end.tip) << i;
      ASSERT_EQ(std::memcmp(&a.turns, &b.turns, sizeof a.turns), 0) << i;
      ASSERT_EQ(a.dimple, b.dimple);
      ASSERT_EQ(a.kind, b.kind);
    }
  }
}

TEST(Texture, ProgressRisesToOneAndAStopIsHeeded) {
  std::vector<double> shares;
  ASSERT_TRUE(dimples_of(patch::SurfaceKind::Curved, [&](double share) {
    shares.push_back(share);
    return true;
  }));
  ASSERT_GT(shares.size(), 2u);
  for (std::size_t i = 1; i < shares.size(); ++i) EXPECT_GT(shares[i], shares[i - 1]);
  EXPECT_EQ(shares.back(), 1.0);
  int calls = 0;
  EXPECT_FALSE(dimples_of(patch::SurfaceKind::Curved, [&](double) { return ++calls < 2; }));
  EXPECT_EQ(calls, 2) << "none after the stop";
}

}  // namespace
}  // namespace patchmill

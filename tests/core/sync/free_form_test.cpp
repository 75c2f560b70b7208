// Matsuda's free form on a ToolPath: teeth counted along its moves stand to one another as the closed
// form says, on planes, on a cylinder, and with marks left out.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/geometry/error.h"
#include "patchmill/patch/cover.h"
#include "patchmill/sync/free_form_path.h"
#include "patchmill/sync/phase_error.h"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::sync {
namespace {

const patch::TexturePlane kPlane;

double uniform(double lo, double hi) {
  return lo + (hi - lo) * *rc::gen::inRange(0, 1 << 30) / (1 << 30);
}

double apart(double a, double b) {
  return std::abs(a - b - std::round(a - b));
}

patch::SurfaceSampler inclined(double slope) {
  return [slope](const std::vector<Vec2>& places) {
    std::vector<patch::SurfaceSample> samples;
    const Vec3 normal = Vec3(-std::sin(slope), 0, std::cos(slope));
    for (const Vec2& p : places)
      samples.push_back(
          {{{p.x(), p.y(), std::tan(slope) * p.x()}, normal}, patch::DimpleState::Cut});
    return samples;
  };
}

patch::SurfaceSampler cylinder(double radius) {
  return [radius](const std::vector<Vec2>& places) {
    std::vector<patch::SurfaceSample> samples;
    for (const Vec2& p : places) {
      const double z2 = radius * radius - p.y() * p.y();
      if (z2 <= 0.0) {
        samples.push_back({});
        continue;
      }
      const Vec3 at(p.x(), p.y(), std::sqrt(z2));
      samples.push_back({{at, Vec3(0, at.y(), at.z()) / radius}, patch::DimpleState::Cut});
    }
    return samples;
  };
}

patch::FreePatch random_patch() {
  patch::FreePatch p;
  p.corners = *rc::gen::element(3, 4, 6);
  p.side = uniform(3.0, 9.0);
  p.cross_feed = uniform(0.2, 0.8);
  p.feed_per_tooth = uniform(0.2, 0.8);
  return p;
}

struct Made {
  patch::PlacedFreeTexture placed;
  ToolPath path;
};

Made make(const patch::FreePatch& patch, const patch::SurfaceSampler& sampler, int decimals,
          patch::HelixOrder order = patch::HelixOrder::Inward, int flutes = 2) {
  const patch::PatchDivision stands = patch::patch_block(patch::stand_pattern(patch), 2, 2);
  const patch::LatticePlace place_of = [&](const Vec2& p) { return patch::place(stands, p); };
  Made made;
  made.placed =
      *patch::place_free(patch, order, stands, place_of, kPlane, sampler, patch::PlaneFit::BestFit);
  const Spindle spindle{1000.0 / 60.0, SpindleSense::M3};
  const double feed = patch.feed_per_tooth * flutes * spindle.speed;
  made.path = free_form_path(made.placed.texture, made.placed.dimples, {1.0, flutes}, spindle,
                             {feed, {}, 60.0, 61.0}, Decimals(decimals));
  return made;
}

double worst(const Made& made, int patch) {
  const auto measured = measure_phase(made.path, made.placed.texture, made.placed.dimples, patch);
  EXPECT_FALSE(measured.empty());
  double most = 0.0;
  for (const patch::MeasuredPhase& m : measured)
    most = std::max(
        most, apart(m.teeth, patch::phase_difference(made.placed.texture.patch, m.lap, m.sector)));
  return most;
}

RC_GTEST_PROP(FreeForm, PhaseDifferenceOfThePathIsThePredictedOne, ()) {
  const patch::FreePatch patch = random_patch();
  const auto order = *rc::gen::element(patch::HelixOrder::Inward, patch::HelixOrder::Outward);
  const auto sampler = *rc::gen::arbitrary<bool>() ? inclined(uniform(0.05, 1.0)) : cylinder(30.0);
  // so many decimals that rounding does not show
  const Made made = make(patch, sampler, 12, order, *rc::gen::inRange(1, 5));
  const int patches = static_cast<int>(made.placed.texture.frames.size());
  for (int k = 0; k < patches; ++k) RC_ASSERT(worst(made, k) < 1e-9);
}

RC_GTEST_PROP(FreeForm, RoundedPathsKeepItWithinTheirDecimals, ()) {
  const Made made = make(random_patch(), inclined(0.3), 3);
  RC_ASSERT(worst(made, 0) < 0.03);
}

RC_GTEST_PROP(FreeForm, SpindleArrivesWithATooth, ()) {
  const patch::FreePatch patch = random_patch();
  const Made made = make(patch, cylinder(30.0), 3);
  const auto errors =
      phase_errors(made.path, wanted_phases(made.placed.dimples, {}, made.path.spindle),
                   phase_period(2, FluteChoice::Any));
  RC_ASSERT(errors.size() == made.placed.dimples.size());
  // a step round a corner has two moves, both ends of each rounded by half a unit in each direction
  const double most = 4.0 * std::sqrt(3.0) * 0.5e-3;
  RC_ASSERT(summary(errors).largest.turns() * 2.0 * patch.feed_per_tooth < most);
}

TEST(FreeForm, PatchesTileThePlaneTheyLieOn) {
  for (int corners : {3, 4, 6}) {
    const patch::FreePatch patch{corners, 5.0, 0.5, 0.5};
    const Made made = make(patch, inclined(0.0), 6);
    // patches that share a side have their centres two apothems apart, and none is nearer
    double least = 1e9;
    const auto& frames = made.placed.texture.frames;
    for (std::size_t i = 0; i < frames.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        least = std::min(least, (frames[i].origin - frames[j].origin).norm());
    EXPECT_NEAR(least, 2.0 * patch::apothem(patch), 1e-9);
    // the middles of their shared sides coincide: of the first patch one is a neighbour's too
    int shared = 0;
    const patch::Polygon outline = patch::free_outline(patch);
    std::vector<Vec3> middles;
    for (const patch::FreeFrame& frame : frames)
      for (std::size_t i = 0; i < outline.size(); ++i)
        middles.push_back(frame.at(0.5 * (outline[i] + outline[(i + 1) % outline.size()])));
    for (std::size_t i = 0; i < middles.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) shared += (middles[i] - middles[j]).norm() < 1e-9;
    EXPECT_GE(shared, corners == 3 ? 7 : 4);
    EXPECT_TRUE((made.placed.dimples[0].surface.position - frames[0].at(outline[0])).norm() < 1e-9);
  }
}

TEST(FreeForm, MarksLeftOutAreLinkedOver) {
  const patch::FreePatch patch{4, 7.0, 0.5, 0.5};
  Made made = make(patch, inclined(0.3), 6);
  for (std::size_t k = 20; k < 60; ++k) made.placed.dimples[k].state = patch::DimpleState::Masked;
  const double feed = patch.feed_per_tooth * 2 * made.path.spindle.speed;
  made.path = free_form_path(made.placed.texture, made.placed.dimples, made.path.tool,
                             made.path.spindle, {feed, {}, 60.0, 61.0}, Decimals(6));
  EXPECT_LT(worst(made, 0), 1e-3);
}

TEST(FreeForm, BadInputIsNamed) {
  auto property = [](const patch::FreePatch& patch, double feed_factor,
                     PhaseRule rule) -> std::string {
    try {
      const patch::PatchDivision stands = patch::patch_block(patch::stand_pattern(patch), 1, 1);
      const patch::LatticePlace place_of = [&](const Vec2& p) { return patch::place(stands, p); };
      const auto placed = *patch::place_free(patch, patch::HelixOrder::Inward, stands, place_of,
                                             kPlane, inclined(0.3), patch::PlaneFit::BestFit);
      free_form_path(placed.texture, placed.dimples, {1.0, 2}, {10.0, SpindleSense::M3},
                     {feed_factor * patch.feed_per_tooth * 20.0, rule, 60.0, 61.0}, Decimals(3));
    } catch (const InputError& e) {
      return e.property();
    }
    return "";
  };
  const patch::FreePatch good{4, 7.0, 0.5, 0.5};
  EXPECT_EQ(property(good, 1.0, {}), "");
  EXPECT_EQ(property({5, 7.0, 0.5, 0.5}, 1.0, {}), "Corners");
  EXPECT_EQ(property({4, 7.0, 0.0, 0.5}, 1.0, {}), "CrossFeed");
  EXPECT_EQ(property(good, 1.01, {}), "FeedPerTooth");
  EXPECT_EQ(property(good, 1.0, {FluteChoice::Same, 0.0, {}}), "SameFlute");
  EXPECT_EQ(property(good, 1.0, {FluteChoice::Any, 1.0, {}}), "ExtraTurns");
}

}  // namespace
}  // namespace patchmill::sync

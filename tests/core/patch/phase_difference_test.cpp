// Matsuda's condition: what is predicted is what the marks of the path show; the advisor's
// proposals measure as aligned.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/geometry/error.h"
#include "patchmill/patch/advisor.h"
#include "patchmill/patch/ridge.h"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::patch {
namespace {

double uniform(double lo, double hi) {
  return lo + (hi - lo) * *rc::gen::inRange(0, 1 << 30) / (1 << 30);
}

double apart(double a, double b) {
  return std::abs(a - b - std::round(a - b));
}

FreePatch random_patch() {
  FreePatch p;
  p.corners = *rc::gen::element(3, 4, 6, 5, 8);
  p.side = uniform(2.0, 20.0);
  p.cross_feed = uniform(0.1, 0.8);
  p.feed_per_tooth = uniform(0.1, 0.8);
  return p;
}

RC_GTEST_PROP(Matsuda, PredictedPhaseDifferenceIsTheOneMeasuredOnTheMarks, ()) {
  const FreePatch p = random_patch();
  const HelixOrder order = *rc::gen::element(HelixOrder::Inward, HelixOrder::Outward);
  const auto path = helix_path(p, order);
  const auto measured = measure_phase(path, helix_marks(path, p.feed_per_tooth), p.feed_per_tooth);
  RC_ASSERT(!measured.empty());
  for (const MeasuredPhase& m : measured)
    RC_ASSERT(apart(m.teeth, phase_difference(p, m.lap, m.sector)) < 1e-9);
}

RC_GTEST_PROP(Matsuda, PathIsContinuousAndPassesAreACrossFeedApart, ()) {
  const FreePatch p = random_patch();
  const auto path = helix_path(p);
  for (std::size_t k = 0; k < path.size(); ++k) {
    if (k > 0) {
      RC_ASSERT((path[k].start - path[k - 1].end).norm() < 1e-9);
      RC_ASSERT(std::abs(path[k].at - path[k - 1].at -
                         (path[k - 1].end - path[k - 1].start).norm()) < 1e-9);
    }
    if (k >= std::size_t(p.corners) && path[k - p.corners].sector == path[k].sector) {
      const Vec2 along = (path[k].end - path[k].start).normalized();
      const Vec2 across = path[k].start - path[k - p.corners].start;
      RC_ASSERT(std::abs(across.x() * along.y() - across.y() * along.x() + p.cross_feed) < 1e-9);
    }
  }
  RC_ASSERT(std::abs((path[0].end - path[0].start).norm() - p.side) < 1e-9);
}

RC_GTEST_PROP(Matsuda, StateIsWhatTheMarksShow, ()) {
  FreePatch p = random_patch();
  if (*rc::gen::arbitrary<bool>()) {  // make aligned ones likely
    p.cross_feed = *rc::gen::inRange(1, 4) * p.feed_per_tooth / (2 * std::tan(kPi / p.corners));
    p.side = *rc::gen::inRange(20, 80) * p.feed_per_tooth / p.corners * 0.5;
  }
  const auto path = helix_path(p);
  const auto measured = measure_phase(path, helix_marks(path, p.feed_per_tooth), p.feed_per_tooth);
  RC_PRE(!measured.empty());
  const MarkArrayState state = mark_array(p);
  double spread = 0.0;  // over the laps of side 0
  for (const MeasuredPhase& m : measured)
    if (m.sector == 0) spread = std::max(spread, apart(m.teeth, state.first));
  if (state.array != MarkArray::Drifting) RC_ASSERT(spread < 0.021);
  if (state.sides_alike)
    for (const MeasuredPhase& m : measured) RC_ASSERT(apart(m.teeth, state.first) < 0.041);
  if (state.array == MarkArray::Square) RC_ASSERT(apart(state.first, 0.0) < 0.021);
  if (state.array == MarkArray::Staggered) RC_ASSERT(apart(state.first, 0.5) < 0.021);
}

TEST(Matsuda, LatticePatchesAreFreePatchesThatAlign) {
  // With a = (points - 1) f and rows c apart, the marks of the continuous path are the lattice
  // points of the discrete helix, in the same order.
  const double f = 0.5;
  struct Case {
    PatchShape shape;
    int size;
    double steps_of_side, row;
    MarkArray array;
  };
  const double row = f * std::sqrt(0.75);
  for (int size : {2, 3, 4, 5, 9, 14})
    for (const Case& c :
         {Case{PatchShape::Square, size, size - 1.0, f, MarkArray::Square},
          Case{PatchShape::Hexagon, size, 1.0 * size, row, MarkArray::Staggered},
          Case{PatchShape::Triangle, size, size - 1.0, row, MarkArray::Staggered}}) {
      const FreePatch p{corners(c.shape), c.steps_of_side * f, c.row, f};
      const MarkArrayState state = mark_array(p, 1e-9);
      EXPECT_EQ(state.array, c.array);
      EXPECT_TRUE(state.sides_alike);
      const auto marks = helix_marks(helix_path(p), f);
      // the hexagon's first lap begins at its corner (r, 0); the continuous one's first side is at
      // the bottom: two turns on
      const int turn = c.shape == PatchShape::Hexagon ? 4 : 0;
      const auto helix = patch_helix(c.shape, c.size, HelixOrder::Inward, false, turn);
      ASSERT_EQ(marks.size(), helix.size());
      for (std::size_t n = 0; n < helix.size(); ++n) {
        const Vec2 lattice = lattice_place(lattice_of(c.shape), f, to_vec(helix[n]));
        const Vec2 first = lattice_place(lattice_of(c.shape), f, to_vec(helix[0]));
        ASSERT_NEAR((lattice - first - (marks[n].place - marks[0].place)).norm(), 0.0, 1e-9)
            << "size " << size << ", point " << n;
      }
    }
}

TEST(Matsuda, StatesAreNamed) {
  // m = 4: 4a/f_z whole: square; half: staggered; c off by 1 %: 8 x 0.01 teeth of drift a pass
  EXPECT_EQ(mark_array({4, 6.5, 0.5, 0.5}).array, MarkArray::Square);
  EXPECT_EQ(mark_array({4, 6.5625, 0.5, 0.5}).array, MarkArray::Staggered);
  EXPECT_EQ(mark_array({4, 6.53, 0.5, 0.5}).array, MarkArray::Oblique);
  const MarkArrayState drifting = mark_array({4, 6.5, 0.505, 0.5});
  EXPECT_EQ(drifting.array, MarkArray::Drifting);
  EXPECT_NEAR(drifting.drift_per_lap, -0.08, 1e-12);
  EXPECT_NEAR(drifting.drift_per_side, -0.02, 1e-12);
  EXPECT_EQ(describe(drifting), "drifting by -0.08 teeth a pass, -0.56 over the patch");
  EXPECT_EQ(describe(mark_array({4, 6.5, 0.5, 0.5})), "square on all sides");
  // rows straight on each side, though not alike: 8 c/f_z whole, 2 c/f_z not
  const MarkArrayState turning = mark_array({4, 6.5 + 0.625 / 8, 0.625, 0.5});
  EXPECT_NE(turning.array, MarkArray::Drifting);
  EXPECT_FALSE(turning.sides_alike);
}

RC_GTEST_PROP(Advisor, ProposalsMeasureAsAligned, ()) {
  MarkWish wish;
  wish.tool = {uniform(0.5, 6.0), *rc::gen::inRange(1, 5)};
  wish.spindle_speed = uniform(5.0, 400.0);
  wish.corners = *rc::gen::element(3, 4, 6);
  wish.side = uniform(4.0, 15.0);
  wish.array = *rc::gen::element(MarkArray::Square, MarkArray::Staggered);
  if (*rc::gen::arbitrary<bool>())
    wish.feed_per_tooth = uniform(0.1, 0.3);
  else
    wish.ridge_height = uniform(0.001, 0.003);
  if (*rc::gen::arbitrary<bool>()) wish.cross_feed = uniform(0.15, 0.4);
  const FreePatch wished = wished_patch(wish);
  const auto proposals = advise(wish);
  RC_ASSERT(proposals.size() == (wish.ridge_height ? 5u : 4u));
  for (const MarkProposal& p : proposals) {
    const auto path = helix_path(p.patch);
    const auto measured =
        measure_phase(path, helix_marks(path, p.patch.feed_per_tooth), p.patch.feed_per_tooth);
    RC_ASSERT(!measured.empty());
    const double wanted = wish.array == MarkArray::Square ? 0.0 : 0.5;
    for (const MeasuredPhase& m : measured) RC_ASSERT(apart(m.teeth, wanted) < 1e-9);
    RC_ASSERT(p.state.array == wish.array && p.state.sides_alike);
    // what is said to be kept is kept, and the feed makes the feed per tooth
    if (p.kept == Kept::FeedPerTooth)
      RC_ASSERT(std::abs(p.patch.feed_per_tooth - wished.feed_per_tooth) < 1e-12);
    if (p.kept == Kept::CrossFeed)
      RC_ASSERT(std::abs(p.patch.cross_feed - wished.cross_feed) < 1e-12);
    if (p.kept == Kept::Side) RC_ASSERT(std::abs(p.patch.side - wished.side) < 1e-12);
    if (p.kept == Kept::RidgeHeight)
      RC_ASSERT(std::abs(p.ridge_height - *wish.ridge_height) < 1e-12);
    RC_ASSERT(std::abs(p.feed / (wish.tool.flutes * wish.spindle_speed) - p.patch.feed_per_tooth) <
              1e-12);
    RC_ASSERT(p.change >= proposals.front().change);
  }
}

TEST(Advisor, AlignedWishStaysAsItIs) {
  MarkWish wish;
  wish.tool = {1.0, 2};
  wish.spindle_speed = 1000.0 / 60;
  wish.side = 6.5;
  wish.feed_per_tooth = 0.5;
  const auto proposals = advise(wish);
  for (const MarkProposal& p : proposals) {
    EXPECT_LT(p.change, 1e-12);
    EXPECT_EQ(describe_changes(wished_patch(wish), p), "nothing changes");
    EXPECT_NEAR(p.feed * 60, 1000.0, 1e-9) << "mm/min: 0.5 mm x 2 flutes x 1000 rpm";
    EXPECT_NEAR(p.ridge_height, 0.064586, 1e-6);
  }
}

TEST(Advisor, BadWishesAreNamed) {
  auto property = [](auto change) -> std::string {
    MarkWish wish;
    wish.tool = {1.0, 2};
    wish.spindle_speed = 10.0;
    wish.side = 6.5;
    wish.feed_per_tooth = 0.5;
    change(wish);
    try {
      advise(wish);
    } catch (const InputError& e) {
      return e.property();
    }
    return "";
  };
  EXPECT_EQ(property([](MarkWish&) {}), "");
  EXPECT_EQ(property([](MarkWish& w) { w.tool.radius = 0; }), "BallRadius");
  EXPECT_EQ(property([](MarkWish& w) { w.tool.flutes = 0; }), "Flutes");
  EXPECT_EQ(property([](MarkWish& w) { w.ridge_height = 0.1; }), "FeedPerTooth");
  EXPECT_EQ(property([](MarkWish& w) { w.feed_per_tooth.reset(); }), "FeedPerTooth");
  EXPECT_EQ(property([](MarkWish& w) { w.array = MarkArray::Drifting; }), "MarkArray");
  EXPECT_EQ(property([](MarkWish& w) { w.side = 0.6; }), "PatchSide");
  EXPECT_EQ(property([](MarkWish& w) { w.cross_feed = -1; }), "CrossFeed");
  EXPECT_EQ(property([](MarkWish& w) { w.feed_per_tooth = 3.0; }), "FeedPerTooth");
}

TEST(Ridge, ClosedForms) {
  // R = 1, f = p = 0.5
  EXPECT_NEAR(cusp_height(1.0, 0.25), 0.031754, 1e-6);
  EXPECT_NEAR(cusp_height(1.0, 0.25), 1 - std::sqrt(1 - 0.0625), 1e-15);
  EXPECT_NEAR(peak_height(1.0, 0.5, 0.5, 0.0), 0.064586, 1e-6);
  EXPECT_NEAR(peak_height(1.0, 0.5, 0.5, 0.5), 0.050082, 1e-6);
  EXPECT_NEAR(peak_height(1.0, 0.5, 0.5 * std::sqrt(0.75), 0.5), 0.042573, 1e-6);
  EXPECT_NEAR(cusp_distance(1.0, 0.02) * 2, 0.397995, 1e-6);
  EXPECT_THROW(cusp_height(1.0, 1.1), InputError);
}

RC_GTEST_PROP(Ridge, CoveringRadiusIsTheFurthestPointOfTheCell, ()) {
  const Vec2 a(uniform(0.2, 1.0), 0.0), b(uniform(-2.0, 2.0), uniform(0.2, 1.0));
  const double rho = covering_radius(a, b);
  double furthest = 0.0;  // by brute force over a grid of the cell
  const int n = 24;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Vec2 p = (i * a + j * b) / n;
      double nearest = 1e9;
      for (int k = -14; k <= 15; ++k)
        for (int l = -5; l <= 6; ++l) nearest = std::min(nearest, (p - k * a - l * b).norm());
      furthest = std::max(furthest, nearest);
    }
  RC_ASSERT(furthest <= rho + 1e-12);
  RC_ASSERT(furthest >= rho - (a.norm() + b.norm()) / n);
}

}  // namespace
}  // namespace patchmill::patch

// The constant-feed strategy on the paper's surface with the paper's numbers (Xu & Sasahara 2016,
// Tables 1 and 2): travel, angle of the legs, turns, phase with and without the carry, M3 against
// M4.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/constant_feed.h"

#include "patch/table1_surface.h"
#include "patchmill/geometry/error.h"
#include "patchmill/sync/contact_azimuth.h"
#include "patchmill/sync/fit_length.h"
#include "patchmill/sync/link.h"
#include "patchmill/sync/phase_error.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <tbb/global_control.h>

namespace patchmill::sync {
namespace {

const Tool kTool{1.0, 2};
const Spindle kM3{1000.0 / 60.0, SpindleSense::M3}, kM4{1000.0 / 60.0, SpindleSense::M4};

ConstantFeed paper_rule(Angle step = {}) {
  return {434.413 / 60.0, {FluteChoice::Same, 5.0, step}, 40.0, 42.0};
}

const patch::Dimples& whole_surface() {
  static const patch::Dimples dimples = [] {
    patch::Dimples d = patch::table1_dimples(14, 8, 8);
    mark_tool_tip(d, Vec3::UnitZ(), Angle::degrees(1));
    return d;
  }();
  return dimples;
}

std::vector<PhaseError> errors_of(const ToolPath& path, const patch::Dimples& dimples,
                                  const ConstantFeed& rule) {
  return phase_errors(path, wanted_phases(dimples, rule.phase, path.spindle),
                      phase_period(path.tool.flutes, rule.phase.flutes));
}

// Every pair of legs between consecutive dimples: start, apex, end.
template <class Visit>
void each_step(const ToolPath& path, Visit visit) {
  for (std::size_t i = 1; i + 1 < path.moves.size(); ++i) {
    const Move &from = path.moves[i - 1], &leg = path.moves[i], &end = path.moves[i + 1];
    if (from.dimple >= 0 && leg.dimple < 0 && leg.kind == MoveKind::Cut &&
        end.dimple == from.dimple + 1)
      visit(from.end.tip, leg.end.tip, end.end.tip, leg.turns + end.turns);
  }
}

TEST(ConstantFeed, PaperTravelsLegsAndTurns) {
  for (const Angle step : {Angle(), Angle::degrees(1)}) {
    const ToolPath path =
        constant_feed_path(whole_surface(), kTool, kM3, paper_rule(step), Decimals(3));
    int steps = 0;
    each_step(path, [&](const Vec3& a, const Vec3& b, const Vec3& c, double turns) {
      ++steps;
      EXPECT_GE(way_over(a, b, c), 2.17);
      const double angle = tilt((a - b).normalized(), (c - b).normalized()).degrees();
      EXPECT_LT(angle, 31.0);
      const double least = 5.0 + step.turns(), most = 6.0 + step.turns();
      EXPECT_GT(turns, least - 0.002);  // the carry may take a thousandth of a turn back
      EXPECT_LT(turns, most + 0.002);
    });
    EXPECT_GT(steps, 10000);
  }
}

TEST(ConstantFeed, PhaseHoldsOverTenThousandDimples) {
  const struct {
    int decimals;
    double bound;
  } cases[] = {{3, 1.0}, {4, 0.15}};
  for (const auto& c : cases) {
    const ToolPath path =
        constant_feed_path(whole_surface(), kTool, kM3, paper_rule(), Decimals(c.decimals));
    const auto errors = errors_of(path, whole_surface(), paper_rule());
    ASSERT_GT(errors.size(), 10000u);
    const PhaseErrorSummary s = summary(errors);
    EXPECT_LT(s.largest.degrees(), c.bound) << c.decimals;
    EXPECT_EQ(s.runs, 1);
    // no growth: the drift over all dimples is far below the bound
    EXPECT_LT(std::abs(Angle::radians(s.drift_per_dimple).degrees()) * double(errors.size()),
              0.05 * c.bound);
  }
}

// Batches are planned while those before them are taken, in memory that they share in turn: whatever their number, and
// however full the last one is, the path is the one of a single thread.
TEST(ConstantFeed, IsThatOfOneThreadForAnyNumberOfDimples) {
  for (const std::size_t count : {600, 1023, 1024, 1025, 2500, 9000}) {
    const patch::Dimples some(whole_surface().begin(),
                              whole_surface().begin() + static_cast<std::ptrdiff_t>(count));
    const auto planned = [&] {
      return constant_feed_path(some, kTool, kM3, paper_rule(), Decimals(3)).moves;
    };
    const auto serial = [&] {
      const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
      return planned();
    }();
    const int times = count < 2000 ? 60 : 8;
    for (int time = 0; time < times; ++time) {
      const std::vector<Move> moves = planned();
      ASSERT_EQ(moves.size(), serial.size()) << count << " dimples, time " << time;
      for (std::size_t i = 0; i < moves.size(); ++i) {
        ASSERT_EQ(moves[i].end.tip, serial[i].end.tip) << count << " dimples, move " << i;
        ASSERT_EQ(moves[i].dimple, serial[i].dimple) << count << " dimples, move " << i;
      }
    }
  }
}

// What the carry is for: round the exact path afterwards, as a post does, and the error wanders
// off.
TEST(ConstantFeed, WithoutTheCarryTheErrorGrows) {
  const ToolPath exact = constant_feed_path(whole_surface(), kTool, kM3, paper_rule(), Decimals(9));
  ToolPath rounded = exact;
  const Decimals three(3);
  Vec3 at = three.round(rounded.start.tip);
  for (Move& move : rounded.moves) {
    move.end.tip = three.round(move.end.tip);
    if (!std::isnan(move.turns)) move.turns = (move.end.tip - at).norm() * 1000.0 / 434.413;
    at = move.end.tip;
  }
  auto unwrapped = [&](const ToolPath& path, std::size_t from, std::size_t to) {
    double largest = 0.0;
    const auto e = errors_of(path, whole_surface(), paper_rule()),
               x = errors_of(exact, whole_surface(), paper_rule());
    for (std::size_t k = from; k < std::min(to, e.size()); ++k)
      largest = std::max(largest, std::abs(e[k].turns - x[k].turns) * 360.0);
    return largest;
  };
  const double early = unwrapped(rounded, 0, 100), late = unwrapped(rounded, 5000, 12000);
  EXPECT_GT(late, 20.0) << "degrees";
  EXPECT_GT(late, 4.0 * early);
  EXPECT_LT(summary(errors_of(exact, whole_surface(), paper_rule())).largest.degrees(), 0.01);
}

TEST(ConstantFeed, M3AndM4AreMirrored) {
  // the surface mirrored in the XZ plane, milled with M4, is the mirror image of the other
  patch::Dimples dimples = patch::table1_dimples(6, 1, 1), mirrored = dimples;
  for (patch::Dimple& d : mirrored) {
    d.surface.position.y() *= -1.0;
    d.surface.normal.y() *= -1.0;
  }
  const ToolPath a = constant_feed_path(dimples, kTool, kM3, paper_rule(), Decimals(6));
  const ToolPath b = constant_feed_path(mirrored, kTool, kM4, paper_rule(), Decimals(6));
  const ToolPath wrong = constant_feed_path(mirrored, kTool, kM3, paper_rule(), Decimals(6));
  ASSERT_EQ(a.moves.size(), b.moves.size());
  double total_a = 0, total_b = 0, total_wrong = 0;
  for (std::size_t i = 2; i < a.moves.size() - 1; ++i) {
    total_a += a.moves[i].turns;
    total_b += b.moves[i].turns;
    total_wrong += wrong.moves[i].turns;
    if (a.moves[i].dimple < 0) continue;
    EXPECT_NEAR(total_a, total_b, 1e-4);
  }
  EXPECT_GT(std::abs(total_a - total_wrong), 0.1) << "the sense of the spindle must matter";
  EXPECT_LT(summary(errors_of(b, mirrored, paper_rule())).largest.degrees(), 0.01);
  ToolPath confused = b;
  confused.spindle = kM3;
  EXPECT_GT(summary(errors_of(confused, mirrored, paper_rule())).rms.degrees(), 10.0);
}

TEST(ConstantFeed, PositionsLieOnTheDecimals) {
  const ToolPath path =
      constant_feed_path(patch::table1_dimples(4, 2, 2), kTool, kM3, paper_rule(), Decimals(3));
  for (const Move& move : path.moves)
    EXPECT_NEAR((move.end.tip * 1000.0 - (move.end.tip * 1000.0).array().round().matrix()).norm(),
                0.0, 1e-8);
}

TEST(ConstantFeed, LinksAreAtSafeHeight) {
  const ToolPath path =
      constant_feed_path(patch::table1_dimples(4, 3, 3), kTool, kM3, paper_rule(), Decimals(3));
  int traverses = 0;
  for (std::size_t i = 1; i < path.moves.size(); ++i) {
    const Vec3 &a = path.moves[i - 1].end.tip, &b = path.moves[i].end.tip;
    if (path.moves[i].kind != MoveKind::Link) continue;
    if ((a - b).head<2>().norm() < 0.5) continue;  // lifts lean by a fraction of a millimetre
    ++traverses;
    EXPECT_GE(a.z(), 40.0);
    EXPECT_GE(b.z(), 40.0);
  }
  EXPECT_EQ(traverses, 8);
}

RC_GTEST_PROP(LinkCorners, KeepThePhaseToAHundredthOfAUnit, ()) {
  auto mm = [](int lo, int hi) { return *rc::gen::inRange(lo * 1000, hi * 1000) / 1000.0; };
  LinkRequest r;
  r.from = {mm(-50, 50), mm(-50, 50), mm(0, 30)};
  r.to = {mm(-50, 50), mm(-50, 50), mm(0, 30)};
  r.safe_height = mm(32, 60);
  r.length_period = mm(1, 5) / 10.0;
  r.length_zero = mm(-3, 3);
  const auto corners = link_corners(r, Decimals(3));
  RC_ASSERT(std::abs(length_miss(r, link_length(r, corners))) < 5e-5);
  for (const Vec3& c : corners) RC_ASSERT(c.z() >= r.safe_height - 1e-9);
}

// What a refusal says is followed: with so many extra turns it is planned, with fewer it is not.
TEST(ConstantFeed, ItsRemedyWorks) {
  const patch::Dimples dimples = patch::table1_dimples(6, 2, 1);
  for (const FluteChoice flutes : {FluteChoice::Same, FluteChoice::Any})
    for (const double feed : {1.0, 3.0, 8.0, 30.0}) {
      ConstantFeed rule = paper_rule();
      rule.feed = feed;
      rule.phase.flutes = flutes;
      rule.phase.extra_turns = 0.0;
      try {
        constant_feed_path(dimples, kTool, kM3, rule, Decimals(3));
        FAIL() << "nothing is refused at " << feed;
      } catch (const InputError& e) {
        const std::string said = "at least ";
        const std::size_t at = e.remedy().find(said);
        ASSERT_NE(at, std::string::npos) << e.remedy();
        const double extra = std::stod(e.remedy().substr(at + said.size()));
        EXPECT_EQ(e.remedy().find("inf"), std::string::npos);
        ConstantFeed followed = rule;
        followed.phase.extra_turns = extra;
        EXPECT_NO_THROW(constant_feed_path(dimples, kTool, kM3, followed, Decimals(3)))
            << e.remedy();
        followed.phase.extra_turns = extra - phase_period(kTool.flutes, flutes).turns();
        EXPECT_THROW(constant_feed_path(dimples, kTool, kM3, followed, Decimals(3)), InputError);
      }
    }
}

TEST(ConstantFeed, ErrorsNameThePropertyAndTheRemedy) {
  const patch::Dimples dimples = patch::table1_dimples(4, 1, 1);
  auto property = [&](const Tool& tool, const Spindle& spindle, ConstantFeed rule,
                      const patch::Dimples& d) -> std::string {
    try {
      constant_feed_path(d, tool, spindle, rule, Decimals(3));
    } catch (const InputError& e) {
      EXPECT_FALSE(e.remedy().empty());
      return e.property();
    }
    return "";
  };
  EXPECT_EQ(property(kTool, kM3, paper_rule(), dimples), "");
  ConstantFeed rule = paper_rule();
  rule.feed = 1.0;
  EXPECT_EQ(property(kTool, kM3, rule, dimples), "Feed");
  rule.feed = std::nan("");
  EXPECT_EQ(property(kTool, kM3, rule, dimples), "Feed");
  EXPECT_EQ(property(kTool, {0.0, SpindleSense::M3}, paper_rule(), dimples), "SpindleSpeed");
  EXPECT_EQ(property({1.0, 0}, kM3, paper_rule(), dimples), "Flutes");
  EXPECT_EQ(property({0.0, 2}, kM3, paper_rule(), dimples), "ToolDiameter");
  rule = paper_rule();
  rule.safe_height = 10.0;
  EXPECT_EQ(property(kTool, kM3, rule, dimples), "SafeHeight");
  rule = paper_rule();
  rule.clearance_height = 30.0;
  EXPECT_EQ(property(kTool, kM3, rule, dimples), "ClearanceHeight");
  rule = paper_rule();
  rule.phase.extra_turns = 4.75;
  EXPECT_EQ(property(kTool, kM3, rule, dimples), "ExtraTurns");
  patch::Dimples none = dimples;
  for (patch::Dimple& d : none) d.state = patch::DimpleState::OffFace;
  EXPECT_EQ(property(kTool, kM3, paper_rule(), none), "Dimples");
}

}  // namespace
}  // namespace patchmill::sync

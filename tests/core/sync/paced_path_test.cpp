// Paced paths: every dimple once, whole teeth, clear of the surface in between, and told when a
// machine cannot.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/paced_path.h"

#include "ball_surface.h"
#include "patch/table1_surface.h"
#include "patchmill/geometry/error.h"
#include "patchmill/machine/predict_motion.h"
#include "patchmill/patch/row_order.h"
#include "patchmill/sync/contact_azimuth.h"
#include "patchmill/sync/verdict.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::sync {
namespace {

const Tool kTool{1.0, 2};
const Decimals kDecimals(4);

machine::MotionModel machine(double acceleration = 2000.0) {
  machine::MotionModel model;
  model.velocity = 100.0;
  model.acceleration = acceleration;
  model.spindle_lock = true;
  return model;
}

Spindle spindle(SpindleSense sense = SpindleSense::M3) {
  return {1000.0 / 60.0, sense};
}

PacedRule rule() {
  PacedRule r;
  r.safe_height = 40.0;
  r.clearance_height = 45.0;
  return r;
}

BallSurface surface_of(unsigned seed) {
  return {seed % 2 ? -25.0 : 25.0, Vec3(1.0, -2.0, seed % 2 ? 40.0 : 0.0)};
}

patch::Dimples random_dimples(unsigned seed, int side, int patches = 1) {
  const double x = 8.0 + 4.0 * (seed / 2 % 7) / 7.0, y = -9.0 + 3.0 * (seed / 14 % 5) / 5.0;
  return dimples_on(surface_of(seed), x, y, side, patches, 1);
}

double off_whole(double x, double period) {
  return std::abs(x - std::round(x / period) * period);
}

RC_GTEST_PROP(PacedPath, VisitsEveryDimpleInWholeTeeth, (unsigned seed, bool m4)) {
  patch::Dimples dimples = random_dimples(seed, 2 + seed % 5, 1 + seed % 3);
  // some places are missing
  for (std::size_t k = 3; k < dimples.size(); k += 5 + seed % 11)
    dimples[k].state = patch::DimpleState::OffFace;
  const Spindle turning = spindle(m4 ? SpindleSense::M4 : SpindleSense::M3);
  const PacedPath paced = paced_path(dimples, kTool, turning, rule(), machine(), kDecimals);
  std::vector<std::int32_t> visited;
  double turns = 0.0;
  for (const Move& move : paced.path.moves) {
    if (move.kind != MoveKind::Rapid) turns += move.turns;
    if (move.dimple == kNoDimple) continue;
    const patch::Dimple& dimple = dimples[static_cast<std::size_t>(move.dimple)];
    const Vec3 tip = dimple.surface.position + dimple.surface.normal - Vec3::UnitZ();
    RC_ASSERT((move.end.tip - tip).norm() < 1e-4);
    // s alpha and the spindle go together
    const double wanted = turning.sign() * contact_azimuth(dimple.surface.normal).turns();
    if (visited.empty()) turns = wanted;
    RC_ASSERT(off_whole(turns - wanted, 0.5) < 1e-9);
    visited.push_back(move.dimple);
  }
  std::vector<std::int32_t> cut;
  for (std::size_t k = 0; k < dimples.size(); ++k)
    if (dimples[k].state == patch::DimpleState::Cut) cut.push_back(static_cast<std::int32_t>(k));
  RC_ASSERT(visited == cut);
}

// Neither rows nor turn-arounds nor links may cut deeper than the surface: chords of a bump dip by
// d² / 8 rho, roundings and decimals a little more.
RC_GTEST_PROP(PacedPath, NeverGouges, (unsigned seed)) {
  const BallSurface surface = surface_of(seed);
  const patch::Dimples dimples = random_dimples(seed, 5, 2);
  const PacedPath paced = paced_path(dimples, kTool, spindle(), rule(), machine(), kDecimals);
  Vec3 from = paced.path.start.tip;
  for (const Move& move : paced.path.moves) {
    for (int i = 0; i <= 8; ++i) {
      const Vec3 tip = from + i / 8.0 * (move.end.tip - from);
      RC_ASSERT(surface.clearance(tip + Vec3::UnitZ(), kTool.radius) > -0.004);
    }
    from = move.end.tip;
  }
}

// When a tooth passes between rows, the ball is off the surface.
TEST(PacedPath, IsClearWhenATeethComesByBetweenRows) {
  const BallSurface surface = surface_of(0);
  const patch::Dimples dimples = random_dimples(0, 6);
  const PacedPath paced = paced_path(dimples, kTool, spindle(), rule(), machine(), kDecimals);
  EXPECT_GT(paced.clearance, 0.065);  // the ridges' height, f² / 4R
  EXPECT_GT(paced.turnarounds, 5);
  double turns = 0.0;
  Vec3 from = paced.path.start.tip;
  bool begun = false;
  for (const Move& move : paced.path.moves) {
    if (move.kind == MoveKind::Rapid) {
      from = move.end.tip;
      continue;
    }
    for (int i = 1; i < 40 && begun; ++i) {
      const Vec3 centre = from + i / 40.0 * (move.end.tip - from) + Vec3::UnitZ();
      const Vec3 normal = (centre - surface.centre).normalized();
      const double off =
          off_whole(turns + i / 40.0 * move.turns + contact_azimuth(normal).turns(), 0.5);
      const Vec3 on = centre - normal;
      double nearest = 1e9;
      for (const patch::Dimple& dimple : dimples)
        nearest = std::min(nearest, (dimple.surface.position - on).norm());
      if (off < 0.01 && nearest > 0.1) {
        EXPECT_GT(surface.clearance(centre, 1.0), 0.06) << on.transpose();
      }
    }
    turns += move.turns;
    from = move.end.tip;
    if (move.dimple == 0) begun = true, turns = -contact_azimuth(dimples[0].surface.normal).turns();
  }
}

TEST(PacedPath, TakesFewTurnsAndHoldsItsPhase) {
  const patch::Dimples dimples = random_dimples(4, 14);
  const std::vector<Angle> wanted = wanted_phases(dimples, rule().phase, spindle());
  // acceleration, turns per dimple at most
  const double cases[][2] = {{500.0, 1.3}, {2000.0, 0.9}, {10000.0, 0.7}};
  for (const auto& [acceleration, limit] : cases) {
    const machine::MotionModel model = machine(acceleration);
    const ToolPath path = paced_path(dimples, kTool, spindle(), rule(), model, kDecimals).path;
    const PredictedPhase phase = predicted_phase(path, model, wanted, Angle::degrees(180));
    ASSERT_TRUE(phase.known);
    EXPECT_LT(phase.rms.degrees(), 1.5);
    EXPECT_LT(phase.errors.back().turns / static_cast<double>(dimples.size() - 1), limit);
  }
}

// What is lost at a rounded corner is planned for the tolerance that is posted, with six decimals.
TEST(PacedPath, RoundsCornersByWhatIsPosted) {
  for (const double acceleration : {500.0, 2000.0, 10000.0}) {
    const PacedPath made = paced_path(random_dimples(5, 6), kTool, spindle(), rule(),
                                      machine(acceleration), kDecimals);
    int rounded = 0;
    for (const Move& move : made.path.moves) {
      if (!(move.tolerance > 0.0)) continue;
      ++rounded;
      EXPECT_NEAR(move.tolerance * 1e6, std::round(move.tolerance * 1e6), 1e-9);
    }
    EXPECT_GT(rounded, 10);
  }
}

// Whose rounding would swallow the straight before it, with another K: the row ends there, and the phase is known.
TEST(PacedPath, EndsRowsOnCornersThatSwallowAStraight) {
  patch::Dimples dimples = patch::table1_dimples(14, 8, 8);
  mark_tool_tip(dimples, Vec3::UnitZ(), Angle::degrees(1));
  PacedRule along = rule();
  along.rows = true;
  const PacedPath made =
      paced_path(patch::in_rows(dimples, patch::lattice_of(patch::PatchShape::Square), {}), kTool,
                 {2800.0 / 60.0, SpindleSense::M3}, along, machine(10000.0), kDecimals);
  const machine::Prediction prediction = machine::predict(made.path, machine(10000.0));
  EXPECT_TRUE(prediction.known) << prediction.reason;
}

// Rows over a bump, and their path; half way through some of its steps the tool may be lifted.
std::pair<patch::Dimples, ToolPath> over_a_bump(double rpm, double acceleration) {
  patch::Dimples dimples = dimples_on({60.0, Vec3::Zero()}, -8.0, -40.0, 30, 1, 5);
  mark_tool_tip(dimples, Vec3::UnitZ(), Angle::degrees(1));
  PacedRule along = rule();
  along.rows = true;
  along.safe_height = along.clearance_height = 70.0;
  const patch::Dimples rows =
      patch::in_rows(dimples, patch::lattice_of(patch::PatchShape::Square), {});
  const Spindle turning{rpm / 60.0, SpindleSense::M3};
  return {rows, paced_path(rows, kTool, turning, along, machine(acceleration), kDecimals).path};
}

// Whether move i ends on a dimple whose steps before and after it are both parted.
bool parted_about(const std::vector<Move>& moves, std::size_t i) {
  return moves[i - 2].dimple != kNoDimple && moves[i - 1].dimple == kNoDimple &&
         moves[i].dimple != kNoDimple && moves[i + 1].dimple == kNoDimple &&
         moves[i + 2].dimple != kNoDimple;
}

// On a bump the straight way from dimple to dimple leads below the tangent planes of both. Near the tip a flute is
// nearly as deep all the while that it passes, so that it would mark deepest beside them: there the way leads up from
// every dimple, and only there.
TEST(PacedPath, LeadsUpFromDimplesNearTheTip) {
  const auto [dimples, path] = over_a_bump(1000.0, 4000.0);
  const std::vector<Move>& moves = path.moves;
  int parted = 0, straight = 0;
  for (std::size_t i = 2; i + 2 < moves.size(); ++i) {
    if (moves[i].dimple == kNoDimple) continue;
    const Vec3& n = dimples[static_cast<std::size_t>(moves[i].dimple)].surface.normal;
    const Vec3 from = moves[i - 1].end.tip - moves[i].end.tip;
    const Vec3 to = moves[i + 1].end.tip - moves[i].end.tip;
    if (moves[i - 1].dimple != kNoDimple && moves[i + 1].dimple != kNoDimple) {
      ++straight;
      EXPECT_GT(tilt(n, Vec3::UnitZ()).degrees(), 8.0) << i;
    } else if (parted_about(moves, i)) {
      ++parted;
      EXPECT_LT(tilt(n, Vec3::UnitZ()).degrees(), 25.0) << i;
      for (const Vec3& way : {from, to}) {
        EXPECT_GT(way.dot(n), 0.0) << i;
        EXPECT_LT(way.dot(n), 2.5e-4) << i;
      }
      const double pitch = from.norm() / moves[i].turns;
      EXPECT_NEAR(to.norm() / moves[i + 1].turns, pitch, 0.05 * pitch) << i;
    }
  }
  EXPECT_GT(parted, 300);
  EXPECT_GT(straight, 300);
}

// Halves of less than 10 ms, or such that the machine could not stop in, would cost the lock its phase.
TEST(PacedPath, PartsNoStepsThatCostTheLock) {
  for (const auto& [rpm, acceleration] : {std::pair{1500.0, 10000.0}, {1000.0, 500.0}}) {
    const std::vector<Move> moves = over_a_bump(rpm, acceleration).second.moves;
    for (std::size_t i = 2; i + 2 < moves.size(); ++i) EXPECT_FALSE(parted_about(moves, i)) << i;
  }
}

TEST(PacedPath, LinksGoOverTheSafeHeight) {
  const patch::Dimples dimples = random_dimples(2, 3, 2);
  const PacedPath paced = paced_path(dimples, kTool, spindle(), rule(), machine(), kDecimals);
  double highest = 0.0;
  std::int32_t last = kNoDimple;
  for (const Move& move : paced.path.moves) {
    if (move.kind != MoveKind::Rapid) highest = std::max(highest, move.end.tip.z());
    if (move.dimple == kNoDimple) continue;
    const bool link = last != kNoDimple && dimples[last].patch != dimples[move.dimple].patch;
    EXPECT_EQ(link, highest >= 40.0);
    last = move.dimple;
    highest = 0.0;
  }
}

std::string refused(const std::function<void(patch::Dimples&, PacedRule&, machine::MotionModel&,
                                             Spindle&)>& change) {
  patch::Dimples dimples = random_dimples(0, 3);
  PacedRule r = rule();
  machine::MotionModel model = machine();
  Spindle turning = spindle();
  change(dimples, r, model, turning);
  try {
    paced_path(dimples, kTool, turning, r, model, kDecimals);
  } catch (const InputError& error) {
    return error.property();
  }
  return "";
}

TEST(PacedPath, BadInputIsNamed) {
  using D = patch::Dimples&;
  using R = PacedRule&;
  using M = machine::MotionModel&;
  using S = Spindle&;
  EXPECT_EQ(refused([](D, R, M, S) {}), "");
  EXPECT_EQ(refused([](D, R, M m, S) { m.spindle_lock = false; }), "SpindleLock");
  EXPECT_EQ(refused([](D, R, M m, S) { m.velocity = 10.0; }), "MaxVelocity");
  EXPECT_EQ(refused([](D, R, M m, S) { m.acceleration = 0.0; }), "MaxAcceleration");
  EXPECT_EQ(refused([](D, R r, M, S) { r.lift = 0.0; }), "Lift");
  EXPECT_EQ(refused([](D, R r, M, S) { r.safe_height = 3.0; }), "SafeHeight");
  EXPECT_EQ(refused([](D, R r, M, S) { r.clearance_height = 39.0; }), "ClearanceHeight");
  EXPECT_EQ(refused([](D, R r, M, S) { r.phase.extra_turns = 5.0; }), "ExtraTurns");
  EXPECT_EQ(refused([](D, R r, M, S) { r.phase.flutes = FluteChoice::Same; }), "Flutes");
  EXPECT_EQ(refused([](D, R, M, S s) { s.speed = 0.0; }), "SpindleSpeed");
  EXPECT_EQ(refused([](D d, R, M, S) { d.clear(); }), "Dimples");
}

TEST(PacedPath, TheSpeedThatARefusalProposesIsAccepted) {
  EXPECT_EQ(refused([](patch::Dimples&, PacedRule&, machine::MotionModel& m, Spindle&) {
              m.velocity = 10.0;
            }),
            "MaxVelocity");
  EXPECT_EQ(refused([](patch::Dimples&, PacedRule&, machine::MotionModel& m, Spindle& s) {
              m.velocity = 10.0;
              s.speed *= 0.4;
            }),
            "");
}

}  // namespace
}  // namespace patchmill::sync

// Finding dimples in a relief, how they line up, and how they compare with the plan.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/marks/alignment.h"
#include "patchmill/marks/place_index.h"
#include "patchmill/marks/plan_comparison.h"
#include "rows.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::marks {
namespace {

using test::MarkMaker;
using test::RowMaker;

std::vector<Vec2> places_of(const std::vector<DimpleMark>& marks, double margin,
                            const SurfaceGrid& grid) {
  const Vec2 low = grid.first.array() + margin;
  const Vec2 high = grid.plane_point(grid.columns - 1, grid.rows - 1).array() - margin;
  std::vector<Vec2> places;
  for (const DimpleMark& m : marks)
    if ((m.place.array() > low.array()).all() && (m.place.array() < high.array()).all())
      places.push_back(m.place);
  return places;
}

TEST(FindDimples, PlacesDepthsAndSizesOfASquareArray) {
  const auto places = test::rows_of_places(4, 4, 0.5, 0.5, [](int) { return 0.0; });
  const SurfaceGrid grid = flat_grid(test::plane_z0(), {-0.5, -0.5}, {2.0, 2.0}, 0.0093);
  const auto marks = find_dimples(test::mark(MarkMaker{}, places, grid, 0.09).relief);
  ASSERT_EQ(marks.size(), places.size());
  for (const Vec2& place : places) {
    const auto nearest =
        std::min_element(marks.begin(), marks.end(), [&](const DimpleMark& a, const DimpleMark& b) {
          return (a.place - place).norm() < (b.place - place).norm();
        });
    EXPECT_LT((nearest->place - place).norm(), 1e-5);
    EXPECT_NEAR(nearest->bottom, 0.0, 1e-6);
    EXPECT_LT((nearest->point - Vec3(place.x(), place.y(), 0.0)).norm(), 1e-5);
    EXPECT_FALSE(nearest->at_edge);
    // inner ones overflow at the ridge; the grid sees it within half a cell
    EXPECT_NEAR(nearest->depth, 0.031754, 0.26 * grid.step);
    const bool inner = place.minCoeff() > 0.1 && place.maxCoeff() < 1.4;
    if (inner) {
      EXPECT_NEAR(nearest->diameter, 2.0 * std::sqrt(0.25 / kPi), 0.01);
    }
  }
  EXPECT_NEAR(mean_spacing(marks), 0.5, 1e-5);
}

TEST(FindDimples, IsolatedMark) {
  MarkMaker maker;
  maker.height = -0.02;
  const SurfaceGrid grid = flat_grid(test::plane_z0(), {-0.3, -0.3}, {0.3, 0.3}, 0.004);
  const auto marks = find_dimples(test::mark(maker, {{0.0, 0.0}}, grid, 0.0).relief);
  ASSERT_EQ(marks.size(), 1u);
  EXPECT_NEAR(marks[0].depth, 0.02, 1e-6);
  EXPECT_NEAR(marks[0].diameter, 0.397995, 1e-3);
}

TEST(FindDimples, DentsBelongToTheirHollow) {
  Relief relief;
  relief.grid = flat_grid(test::plane_z0(), {0, 0}, {8, 0}, 1.0);
  relief.stock = 1.0;
  relief.height = {1.0f, 0.5f, 0.2f, 0.21f, 0.19f, 0.6f, 0.3f, 0.7f, 1.0f};
  const auto coarse = find_dimples(relief, {0.05});
  ASSERT_EQ(coarse.size(), 2u);
  EXPECT_NEAR(coarse[0].bottom, 0.19, 1e-6);
  EXPECT_NEAR(coarse[0].depth, 0.6 - 0.19, 1e-6);
  EXPECT_NEAR(coarse[1].depth, 0.3, 1e-6);
  EXPECT_EQ(find_dimples(relief, {0.005}).size(), 3u);
}

// The marks of a zigzag: a crease through the lowest point, at any angle and place in its cell.
RC_GTEST_PROP(FindDimples, CreasedMarksAreFoundWithinACell,
              (std::uint8_t angle, std::uint8_t right, std::uint8_t up)) {
  const double turn = angle * kPi / 128.0, step = 0.02;
  const Vec2 across(std::cos(turn), std::sin(turn)), along(-across.y(), across.x());
  const Vec2 place(step * (right / 256.0 - 0.5), step * (up / 256.0 - 0.5));
  Relief relief;
  relief.grid = flat_grid(test::plane_z0(), {-0.2, -0.2}, {0.2, 0.2}, step);
  relief.stock = 0.02;
  for (int j = 0; j < relief.grid.rows; ++j)
    for (int i = 0; i < relief.grid.columns; ++i) {
      const Vec2 p = relief.grid.plane_point(i, j) - place;
      const double h = 0.15 * std::abs(p.dot(across)) + 0.5 * p.squaredNorm();
      relief.height.push_back(static_cast<float>(std::min(h, relief.stock)));
    }
  const auto marks = find_dimples(relief, {0.004});
  RC_ASSERT(marks.size() == 1u);
  RC_ASSERT((marks[0].place - place).norm() < step);
}

struct ArrayCase {
  const char* what;
  double shift, drift;
  Alignment expected;
};
class MatsudaArrays : public ::testing::TestWithParam<ArrayCase> {};

TEST_P(MatsudaArrays, SimulatedAndRecognised) {
  const ArrayCase& c = GetParam();
  const RowMaker maker;
  const ToolPath path = maker.path([&](int j) { return c.shift + c.drift * j; });
  const SurfaceGrid grid = maker.grid(0.02);
  const auto marks =
      find_dimples(simulate_marks(motion_of(path), {path.tool, {}, {}}, grid, {0.08}).relief);
  const auto places = places_of(marks, 0.05, grid);
  EXPECT_GT(places.size(), 80u);
  const AlignmentResult result =
      classify_alignment(places, {Vec2::UnitX(), maker.feed_per_tooth, maker.cross_feed});
  EXPECT_EQ(result.state, c.expected) << name(result.state) << " shift " << result.shift;
  EXPECT_GT(result.row_agreement, 0.99);
  ASSERT_EQ(result.rows.size(), 7u);
  for (const RowShift& row : result.rows) {
    const double off = row.shift - (c.shift + c.drift * row.row);
    EXPECT_NEAR(off - std::round(off), 0.0, 0.01) << row.row;
  }
}

INSTANTIATE_TEST_SUITE_P(Fig2, MatsudaArrays,
                         ::testing::Values(ArrayCase{"square", 0.0, 0.0, Alignment::Square},
                                           ArrayCase{"staggered", 0.5, 0.0, Alignment::Staggered},
                                           ArrayCase{"skewed", 0.25, 0.0, Alignment::Skewed},
                                           ArrayCase{"drifting", 0.1, 0.13, Alignment::Drifting}),
                         [](const auto& info) { return info.param.what; });

TEST(Alignment, RandomMarksAreIrregularAndFewAreUnknown) {
  std::vector<Vec2> places;
  std::uint32_t seed = 1;
  for (int j = 0; j < 10; ++j)
    for (int i = 0; i < 30; ++i) {
      seed = seed * 1664525u + 1013904223u;
      places.push_back({i + seed / 4294967296.0, 0.8 * j});
    }
  EXPECT_EQ(classify_alignment(places, {Vec2::UnitX(), 1.0, 0.8}).state, Alignment::Irregular);
  EXPECT_EQ(classify_alignment({{0, 0}, {1, 0}}, {Vec2::UnitX(), 1.0, 0.8}).state,
            Alignment::Unknown);
}

// Turning the whole array turns the feed with it and changes nothing else.
RC_GTEST_PROP(Alignment, DoesNotDependOnTheDirectionOfTheRows,
              (int degrees, std::uint8_t percent)) {
  const double turn = (degrees % 360) * kPi / 180.0, shift = (percent % 100) / 100.0;
  const Vec2 u(std::cos(turn), std::sin(turn)), v(-u.y(), u.x());
  std::vector<Vec2> places;
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 8; ++i) places.push_back(0.5 * (i + shift * j) * u + 0.45 * j * v);
  const AlignmentResult result = classify_alignment(places, {u, 0.5, 0.45});
  RC_ASSERT(std::abs(result.shift - shift - std::round(result.shift - shift)) < 1e-9);
  RC_ASSERT(result.agreement > 1.0 - 1e-9);
}

// Runout of one flute: every second dimple is shallower; dimples all made by the same flute are
// not.
TEST(Runout, ShowsWithAnyFluteAndNotWithTheSame) {
  const double runout = 0.005;
  const RowMaker maker;
  const ToolPath any = maker.path([](int) { return 0.0; });
  const SurfaceGrid grid = maker.grid(0.02);
  const Cutter cutter{any.tool, {}, {0.0, -runout}};
  std::vector<double> bottoms;
  for (const DimpleMark& m :
       find_dimples(simulate_marks(motion_of(any), cutter, grid, {0.08}).relief))
    if (!m.at_edge) bottoms.push_back(m.bottom);
  ASSERT_GT(bottoms.size(), 40u);
  int low = 0, high = 0;
  for (const double b : bottoms) {
    low += std::abs(b) < 2e-4;
    high += std::abs(b - runout) < 2e-4;
  }
  EXPECT_EQ(low + high, static_cast<int>(bottoms.size()));
  EXPECT_NEAR(low, high, 0.2 * bottoms.size());

  // one turn per dimple, over an apex while the other flute passes
  ToolPath same;
  same.tool = any.tool;
  same.spindle = any.spindle;
  const auto pose = [&](double x, double z) {
    return pose_of_ball({x, 0.0, 1.0 + z}, maker.axis, 1.0);
  };
  same.start = pose(-0.25, 0.3);
  MarkMaker like;
  like.axis = maker.axis;
  for (int k = 0; k < 10; ++k) {
    same.moves.push_back({pose(0.5 * k, 0.0), 0.5, k, MoveKind::Cut});
    same.moves.push_back({pose(0.5 * k + 0.25, 0.3), 0.5, kNoDimple, MoveKind::Cut});
  }
  const SurfaceGrid row = flat_grid(test::plane_z0(), {-0.2, -0.2}, {4.7, 0.2}, 0.02);
  const auto marks =
      find_dimples(simulate_marks(motion_of(same, like.locked(10)), cutter, row, {0.03}).relief);
  ASSERT_EQ(marks.size(), 10u);
  for (const DimpleMark& m : marks) EXPECT_NEAR(m.bottom, marks.front().bottom, 1e-4);
}

std::vector<PlannedPlace> plan_of(const std::vector<Vec2>& places) {
  std::vector<PlannedPlace> plan;
  for (const Vec2& p : places) plan.push_back({static_cast<std::int32_t>(plan.size()), p});
  return plan;
}

std::vector<DimpleMark> marks_at(const std::vector<Vec2>& places) {
  std::vector<DimpleMark> marks(places.size());
  for (std::size_t k = 0; k < places.size(); ++k) marks[k].place = places[k];
  return marks;
}

TEST(PlanComparison, MissingExtraAndMoved) {
  auto places = test::rows_of_places(5, 4, 0.5, 0.5, [](int) { return 0.0; });
  const auto plan = plan_of(places);
  places[7] += Vec2(0.03, -0.04);
  places.erase(places.begin() + 3);
  places.push_back({0.25, 0.25});
  const PlanComparison c = compare_with_plan(marks_at(places), plan, 0.5);
  EXPECT_EQ(c.missing, 1);
  EXPECT_EQ(c.matches[3].found, -1);
  EXPECT_EQ(c.extra, std::vector<std::int32_t>{19});
  EXPECT_NEAR((c.matches[7].moved - Vec2(0.03, -0.04)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(c.largest_move, 0.05, 1e-12);
  EXPECT_NEAR(c.rms_move, 0.05 / std::sqrt(19.0), 1e-12);
  EXPECT_NEAR(c.quality, (18 + 1 - 0.4 * 0.4) / 21, 1e-12);
}

TEST(PlanComparison, MeanAndDeviationOfTheDepths) {
  const auto places = test::rows_of_places(2, 2, 0.5, 0.5, [](int) { return 0.0; });
  auto found = marks_at(places);
  const double depths[] = {0.010, 0.012, 0.014, 0.020};
  for (std::size_t k = 0; k < 4; ++k) found[k].depth = depths[k];
  const PlanComparison c = compare_with_plan(found, plan_of(places), 0.5);
  EXPECT_NEAR(c.mean_depth, 0.014, 1e-15);
  EXPECT_NEAR(c.depth_deviation, std::sqrt((16.0 + 4.0 + 0.0 + 36.0) / 4.0) * 1e-3, 1e-12);
}

TEST(PlanComparison, SimulatedArrayIsAsPlanned) {
  const auto places = test::rows_of_places(4, 4, 0.5, 0.5, [](int j) { return 0.5 * (j % 2); });
  const SurfaceGrid grid = flat_grid(test::plane_z0(), {-0.4, -0.4}, {2.2, 1.9}, 0.02);
  const auto found = find_dimples(test::mark(MarkMaker{}, places, grid, 0.09).relief);
  const PlanComparison c = compare_with_plan(found, plan_of(places), 0.5);
  EXPECT_EQ(c.missing, 0);
  EXPECT_TRUE(c.extra.empty());
  EXPECT_LT(c.largest_move, 1e-4);
  EXPECT_GT(c.quality, 0.9999);
}

RC_GTEST_PROP(PlaceIndex, FindsTheNearestAsTryingAllDoes, (std::vector<std::uint16_t> raw)) {
  std::vector<Vec2> places;
  for (std::size_t k = 0; k + 1 < raw.size(); k += 2)
    places.push_back({raw[k] % 101 * 0.1, raw[k + 1] % 37 * 0.3});
  const PlaceIndex index(places);
  for (const Vec2& at : {Vec2(5.03, 4.0), Vec2(-3.0, 20.0), Vec2(0.0, 0.0)}) {
    std::size_t best = PlaceIndex::kNobody;
    for (std::size_t k = 0; k < places.size(); ++k)
      if (best == PlaceIndex::kNobody || (places[k] - at).norm() < (places[best] - at).norm())
        best = k;
    RC_ASSERT(index.nearest(at) == best);
    std::vector<std::size_t> near;
    for (std::size_t k = 0; k < places.size(); ++k)
      if ((places[k] - at).norm() <= 2.0) near.push_back(k);
    RC_ASSERT(index.within(at, 2.0) == near);
  }
}

}  // namespace
}  // namespace patchmill::marks

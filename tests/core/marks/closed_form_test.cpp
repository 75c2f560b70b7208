// Heights of regular arrays in closed form. With the feed slow against the edge a mark is a
// spherical cap, so the lowest cap at distance q from its centre stands at R - sqrt(R² - q²).
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "arrays.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace patchmill::marks {
namespace {

using test::MarkMaker;

double cap(double q) {
  return 1.0 - std::sqrt(1.0 - q * q);
}

/// Height of one cell at `at` after milling `places`.
double height_at(const MarkMaker& maker, const std::vector<Vec2>& places, const Vec2& at) {
  const SurfaceGrid grid = flat_grid(test::plane_z0(), at, at, 0.01);
  return test::mark(maker, places, grid, 0.1).relief.height.front();
}

struct Array {
  double p, shift;
  Vec2 peak;  // farthest from all places
  double height;
};

class Arrays : public ::testing::TestWithParam<Array> {};

TEST_P(Arrays, RidgeAndPeakHeights) {
  const Array& a = GetParam();
  const double f = 0.5;
  const auto places =
      test::rows_of_places(5, 5, f, a.p, [&](int j) { return j % 2 == 0 ? 0.0 : a.shift; });
  const MarkMaker still;
  EXPECT_NEAR(height_at(still, places, places[12]), 0.0, 1e-6);
  EXPECT_NEAR(height_at(still, places, places[12] + Vec2(f / 2, 0)), 0.031754, 1e-6);
  EXPECT_NEAR(height_at(still, places, places[12] + a.peak), a.height, 1e-6);
}

std::string name_of(const ::testing::TestParamInfo<Array>& array) {
  const char* names[] = {"Square", "Staggered", "Triangular"};
  return names[array.index];
}

// f = 0.5, R = 1. The farthest point of a triangle of places is its circumcentre.
INSTANTIATE_TEST_SUITE_P(
    SpindleMarks, Arrays,
    ::testing::Values(Array{0.5, 0.0, {0.25, 0.25}, 0.064586},
                      Array{0.5, 0.5, {0.0, 0.3125}, 0.050082},
                      Array{0.5 * std::sqrt(0.75), 0.5, {0.0, 0.5 / std::sqrt(3.0)}, 0.042573}),
    name_of);

TEST(ClosedForm, RidgeIsTheExactScallop) {
  const auto places = test::rows_of_places(3, 1, 0.5, 0.5, [](int) { return 0.0; });
  EXPECT_NEAR(height_at(MarkMaker{}, places, {0.25, 0.0}), 1.0 - std::sqrt(1.0 - 0.0625), 1e-7);
  EXPECT_NEAR(height_at(MarkMaker{}, places, {0.25, 0.0}), 0.5 * 0.5 / 8.0, 6e-4);
}

TEST(ClosedForm, IsolatedMarkHasTheDiameterOfItsCap) {
  MarkMaker maker;
  maker.height = -0.02;
  const double step = 0.002;
  const SurfaceGrid grid = flat_grid(test::plane_z0(), {-0.25, -0.25}, {0.25, 0.25}, step);
  const Relief relief = test::mark(maker, {{0.0, 0.0}}, grid, 0.0).relief;
  const auto cut =
      std::count_if(relief.height.begin(), relief.height.end(), [](float h) { return h < 0.0f; });
  const double diameter = 2.0 * std::sqrt(cut * step * step / kPi);
  EXPECT_NEAR(diameter, 0.397995, 5e-4);  // counting cells: a share of a step
  EXPECT_NEAR(*std::min_element(relief.height.begin(), relief.height.end()), -0.02, 1e-6);
}

// A creeping ball changes the ridge in proportion to the feed per turn.
TEST(ClosedForm, ErrorIsOfFirstOrderInFeedOverSpeed) {
  const auto places = test::rows_of_places(3, 1, 0.5, 0.5, [](int) { return 0.0; });
  std::vector<double> error;
  for (const double feed : {0.04, 0.02, 0.01, 0.005}) {
    MarkMaker maker;
    maker.creep = {feed, 0.0, 0.0};
    error.push_back(std::abs(height_at(maker, places, {0.25, 0.0}) - cap(0.25)));
  }
  for (std::size_t k = 1; k < error.size(); ++k)
    EXPECT_NEAR(std::log2(error[k - 1] / error[k]), 1.0, 0.05) << error[k];
  EXPECT_LT(error.back(), 1e-4);
}

// The highest cell misses the peak by half a cell's diagonal at most, where the caps rise by q /
// sqrt(R² - q²).
TEST(ClosedForm, HighestCellConvergesToThePeakWithTheGrid) {
  const auto places = test::rows_of_places(2, 2, 0.5, 0.5, [](int) { return 0.0; });
  double before = 0.0;
  for (const double step : {0.02, 0.01, 0.005, 0.0025}) {
    const Vec2 off(0.25 + step / 2, 0.25 + step / 2);  // the worst place of the grid
    const SurfaceGrid grid = flat_grid(test::plane_z0(), off - Vec2(0.1, 0.1), off, step);
    const Relief relief = test::mark(MarkMaker{}, places, grid, 0.1).relief;
    const double error =
        cap(std::sqrt(0.125)) - *std::max_element(relief.height.begin(), relief.height.end());
    EXPECT_GT(error, 0.0);
    EXPECT_LT(error, 0.379 * step * std::sqrt(0.5));
    if (before > 0.0) {
      EXPECT_NEAR(std::log2(before / error), 1.0, 0.1);
    }
    before = error;
  }
}

// Motion along the normal only: the same bottom, wherever the tool leans and however it turns.
TEST(ClosedForm, CapsDoNotDependOnTheToolAxisOrSense) {
  for (const double tilt : {25.0, 45.0, 60.0})
    for (const double towards : {0.0, 2.0, 4.0})
      for (const SpindleSense sense : {SpindleSense::M3, SpindleSense::M4}) {
        MarkMaker maker;
        maker.axis = test::tilted_axis(tilt * kPi / 180.0, towards);
        maker.spindle.sense = sense;
        const SurfaceGrid grid = flat_grid(test::plane_z0(), {-0.2, -0.2}, {0.2, 0.2}, 0.02);
        const Relief relief = test::mark(maker, {{0.0, 0.0}}, grid, 0.05).relief;
        for (int j = 0; j < grid.rows; ++j)
          for (int i = 0; i < grid.columns; ++i)
            ASSERT_NEAR(relief.at(i, j), std::min(cap(grid.plane_point(i, j).norm()), 0.05), 1e-6)
                << tilt << " " << towards;
      }
}

}  // namespace
}  // namespace patchmill::marks

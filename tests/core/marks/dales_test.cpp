// Dales by watershed and Wolf pruning: closed forms of sines and caps, and what pruning leaves.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/marks/dales.h"

#include "patchmill/geometry/angle.h"
#include "patchmill/geometry/error.h"

#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::marks {
namespace {

HeightGrid sampled(int rows, int columns, double step,
                   const std::function<double(double, double)>& z) {
  HeightGrid grid;
  grid.rows = rows;
  grid.columns = columns;
  grid.step = {step, step};
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      grid.height.push_back(static_cast<float>(z(i * step, j * step)));
  return grid;
}

double area_of(const std::vector<Dale>& found) {
  double sum = 0.0;
  for (const Dale& d : found) sum += d.area;
  return sum;
}

// sin x sin y: a pit in every second quarter, saddles at height 0: depth A, closed area a quarter wave squared, volume
// A (2/pi)² of it.
TEST(Dales, OfAProductOfSinesHaveTheirClosedForms) {
  const double amplitude = 0.01, length = 1.0, k = 2.0 * kPi / length;
  const HeightGrid grid = sampled(401, 401, 0.01, [&](double x, double y) {
    return amplitude * std::sin(k * (x - 0.0031)) * std::sin(k * (y + 0.0017));
  });
  int inner = 0;
  for (const Dale& d : dales(grid, 0.2 * amplitude)) {
    if (d.at_edge) continue;
    ++inner;
    EXPECT_NEAR(d.bottom, -amplitude, 1e-3 * amplitude);
    EXPECT_NEAR(d.depth, amplitude, 0.02 * amplitude);
    EXPECT_NEAR(d.closed_area, 0.25, 0.01);
    EXPECT_NEAR(d.volume, amplitude * 0.25 * 4.0 / (kPi * kPi), 0.03 * 0.1 * amplitude);
  }
  EXPECT_GE(inner, 18);  // 4 x 4 waves have 32 pits, of which those at the border are open
}

// A ball's cap in a plane: depth h, closed area pi a², volume pi h (3 a² + h²) / 6.
TEST(Dales, OfBallCapsInAPlane) {
  const double depth = 0.02, radius = 0.2, spacing = 0.5;
  const double ball = (radius * radius + depth * depth) / (2 * depth);
  const HeightGrid grid = sampled(501, 501, 0.005, [&](double x, double y) {
    const double u = x - spacing * std::round(x / spacing),
                 v = y - spacing * std::round(y / spacing);
    const double square = u * u + v * v;
    if (square > radius * radius) return 0.0;
    return ball - depth - std::sqrt(ball * ball - square);
  });
  int inner = 0;
  for (const Dale& d : dales(grid, 0.05 * depth)) {
    if (d.at_edge) continue;
    ++inner;
    EXPECT_NEAR(d.depth, depth, 1e-6);
    EXPECT_NEAR(d.closed_area, kPi * radius * radius, 0.002);
    EXPECT_NEAR(d.volume, kPi * depth * (3 * radius * radius + depth * depth) / 6, 2e-6);
  }
  EXPECT_EQ(inner, 16);
}

// Saddles at 3, 1 and 2 over pits at 0, 0.5, 0.2 and 0: 0.5 is shallowest (0.5), then 0.2 (1.8).
TEST(Dales, AreMergedShallowestFirstOverTheLowestSaddle) {
  HeightGrid grid;
  grid.rows = 2;
  grid.columns = 7;
  grid.height = {0.0f, 3.0f, 0.5f, 1.0f, 0.2f, 2.0f, 0.0f,
                 0.0f, 3.0f, 0.5f, 1.0f, 0.2f, 2.0f, 0.0f};
  const auto all = dales(grid, 0.0);
  ASSERT_EQ(all.size(), 4u);
  EXPECT_NEAR(all[1].depth, 0.5, 1e-6);
  const auto three = dales(grid, 0.6);
  ASSERT_EQ(three.size(), 3u);
  EXPECT_EQ(three[1].pit, 4);
  EXPECT_NEAR(three[1].depth, 1.8, 1e-6);
  const auto two = dales(grid, 1.9);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_NEAR(two[1].depth, 3.0, 1e-6);
  const auto one = dales(grid, 3.5);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_TRUE(std::isinf(one[0].depth));
}

// Four bowls over a plain: a hole in one opens it, a hole in the plain opens none; one lies at the border.
TEST(Dales, AreOpenWhereTheirClosedPartMeetsABorderOrAHole) {
  HeightGrid grid = sampled(41, 41, 0.05, [](double x, double y) {
    return std::min(0.0, std::hypot(x - (x < 0.75 ? 0.1 : 1.5), y - (y < 1.0 ? 0.5 : 1.5)) - 0.25);
  });
  const auto opened = [&] {
    std::vector<std::pair<std::int64_t, bool>> open;
    for (const Dale& d : dales(grid, 0.1))
      open.emplace_back(d.pit % 41 * 100 + d.pit / 41, d.at_edge);
    return open;
  };
  using Open = std::vector<std::pair<std::int64_t, bool>>;
  EXPECT_EQ(opened(), (Open{{210, true}, {3010, false}, {230, true}, {3030, false}}));
  grid.height[20 * 41 + 21] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(opened(), (Open{{210, true}, {3010, false}, {230, true}, {3030, false}}));
  grid.height[12 * 41 + 31] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(opened(), (Open{{210, true}, {3010, true}, {230, true}, {3030, false}}));
}

// Every known point belongs to one dale, none is shallower than asked for, and moving all heights changes nothing.
RC_GTEST_PROP(Dales, PartTheSurface, (std::uint32_t seed, std::uint8_t share)) {
  std::uint32_t state = seed;
  const auto chance = [&] {
    state = state * 1664525u + 1013904223u;
    return (state >> 8) / 16777216.0;
  };
  const double hole = share / 1024.0, least = 0.3;
  HeightGrid grid = sampled(12, 17, 0.1, [&](double, double) {
    return chance() < hole ? std::numeric_limits<double>::quiet_NaN() : chance();
  });
  int known = 0;
  for (const float h : grid.height) known += std::isnan(h) ? 0 : 1;
  const auto found = dales(grid, least);
  RC_ASSERT(std::abs(area_of(found) - 0.01 * known) < 1e-9);
  for (const Dale& d : found) {
    RC_ASSERT(d.depth >= least);
    RC_ASSERT(d.closed_area <= d.area + 1e-12);
  }
  for (float& h : grid.height) h += 4.0f;
  RC_ASSERT(dales(grid, least).size() == found.size());
}

TEST(Dales, BadInputIsNamed) {
  HeightGrid grid = sampled(4, 4, 0.1, [](double x, double) { return x; });
  const auto property = [&](const HeightGrid& surface, double least) {
    try {
      dales(surface, least);
    } catch (const InputError& e) {
      return std::string(e.property());
    }
    return std::string();
  };
  EXPECT_EQ(property(grid, -1.0), "LeastDepth");
  EXPECT_EQ(property(grid, std::nan("")), "LeastDepth");
  HeightGrid other = grid;
  other.rows = 5;
  EXPECT_EQ(property(other, 0.0), "Heights");
  other = grid;
  other.step.y() = 0.0;
  EXPECT_EQ(property(other, 0.0), "GridStep");
  EXPECT_EQ(property(grid, 0.0), "");
}

}  // namespace
}  // namespace patchmill::marks

// All patch shapes: helices step by step, tiling of the lattice, outlines, covers and links.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/geometry/error.h"
#include "patchmill/patch/cover.h"

#include <map>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::patch {
namespace {

const std::vector<PatchShape>& kShapes = all_patch_shapes();

PatchPattern random_pattern(int largest) {
  PatchPattern p;
  p.shape = *rc::gen::elementOf(kShapes);
  p.spacing = *rc::gen::element(0.1, 0.5, 1.25);
  p.size = *rc::gen::inRange(traits(p.shape).least.side, largest);
  if (traits(p.shape).two_sided) p.size.across = *rc::gen::inRange(1, largest);
  p.order = *rc::gen::element(HelixOrder::Inward, HelixOrder::Outward);
  p.start = *rc::gen::element(HelixStart::SameCorner, HelixStart::NearestCorner);
  return p;
}

bool inside(const Polygon& polygon, const Vec2& p) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], edge = polygon[(i + 1) % polygon.size()] - a;
    if (edge.x() * (p - a).y() - edge.y() * (p - a).x() <= 0.0) return false;
  }
  return true;
}

double area(const Polygon& p) {
  double sum = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2 a = p[i], b = p[(i + 1) % p.size()];
    sum += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  return sum;
}

RC_GTEST_PROP(Helix, VisitsEachPointOnceInLatticeSteps, ()) {
  const PatchPattern p = random_pattern(40);
  const bool down = *rc::gen::arbitrary<bool>();
  const int turn = *rc::gen::inRange(0, traits(p.shape).turns);
  const auto path = patch_helix(p.shape, p.size, p.order, down, turn);
  RC_ASSERT(std::int64_t(path.size()) == point_count(p.shape, p.size));
  const std::set<LatticePoint> points(path.begin(), path.end());
  RC_ASSERT(points.size() == path.size());
  for (std::size_t i = 1; i < path.size(); ++i)
    RC_ASSERT(lattice_distance(lattice_of(p.shape),
                               {path[i][0] - path[i - 1][0], path[i][1] - path[i - 1][1]}) == 1);
  // turning the helix and turning it round leave the points as they are
  const auto plain = patch_helix(p.shape, p.size, HelixOrder::Inward, down);
  RC_ASSERT(points == std::set<LatticePoint>(plain.begin(), plain.end()));
}

TEST(Helix, PointsAreThoseOfTheDefinition) {
  for (int m = 1; m < 12; ++m) {
    std::set<LatticePoint> hexagon, up, down;
    for (int i = -m; i <= m; ++i)
      for (int j = -m; j <= m; ++j) {
        if (std::abs(i) + std::abs(j) + std::abs(i + j) <= 2 * m) hexagon.insert({i, j});
        if (i >= 0 && j >= 0 && i + j <= m - 1) up.insert({i, j});
        if (i <= m && j <= m - 1 && i + j >= m) down.insert({i, j});
      }
    auto as_set = [](const std::vector<LatticePoint>& v) {
      return std::set<LatticePoint>(v.begin(), v.end());
    };
    EXPECT_EQ(as_set(patch_helix(PatchShape::Hexagon, m, HelixOrder::Inward)), hexagon);
    EXPECT_EQ(as_set(patch_helix(PatchShape::Triangle, m, HelixOrder::Inward)), up);
    EXPECT_EQ(as_set(patch_helix(PatchShape::Triangle, m, HelixOrder::Inward, true)), down);
  }
}

TEST(Helix, LoopsShrinkBySixAndNine) {
  // loop number of a point, outermost first, and the points in each loop
  auto loops = [](const std::vector<LatticePoint>& path, auto loop) {
    std::vector<int> count;
    int last = 0;
    for (const auto& p : path) {
      const int k = loop(p);
      EXPECT_GE(k, last) << "loops are finished before the next one is begun";
      last = k;
      count.resize(std::max<std::size_t>(count.size(), k + 1));
      ++count[k];
    }
    return count;
  };
  const int r = 7, m = 16;
  const auto hexagon = loops(
      patch_helix(PatchShape::Hexagon, r, HelixOrder::Inward),
      [&](const LatticePoint& p) { return r - lattice_distance(LatticeKind::Triangular, p); });
  const auto triangle =
      loops(patch_helix(PatchShape::Triangle, m, HelixOrder::Inward), [&](const LatticePoint& p) {
        return std::min({p[0], p[1], m - 1 - p[0] - p[1]});
      });
  for (std::size_t k = 1; k + 1 < hexagon.size(); ++k) EXPECT_EQ(hexagon[k - 1] - hexagon[k], 6);
  for (std::size_t k = 1; k + 1 < triangle.size(); ++k) EXPECT_EQ(triangle[k - 1] - triangle[k], 9);
}

RC_GTEST_PROP(PatchDivision, EachLatticePointOfTheAreaIsInExactlyOnePatch, ()) {
  const PatchPattern p = random_pattern(7);
  const double width = p.spacing * *rc::gen::inRange(1, 40);
  const double height = p.spacing * *rc::gen::inRange(1, 40);
  const Vec2 corner(0.1 * *rc::gen::inRange(-50, 50), 0.1 * *rc::gen::inRange(-50, 50));
  const Box2 box(corner, corner + Vec2(width, height));
  const PatchDivision d = cover(p, box);
  std::set<LatticePoint> seen;
  for (const Dimple& dimple : lattice_points(d)) RC_ASSERT(seen.insert(dimple.lattice).second);
  // every lattice point of the box, found by going through a larger range of them
  for (int i = -200; i <= 200; ++i)
    for (int j = -200; j <= 200; ++j)
      if (box.contains(place(d, LatticePoint{i, j}))) RC_ASSERT(seen.count({i, j}) == 1);
}

RC_GTEST_PROP(PatchDivision, OutlinesHoldTheirOwnPointsAndTile, ()) {
  const PatchPattern p = random_pattern(9);
  const PatchDivision d = patch_block(p, *rc::gen::inRange(1, 5), *rc::gen::inRange(1, 5));
  const auto borders = outlines(d);
  const double points = double(point_count(p.shape, p.size));
  const double cell = cell_area(lattice_of(p.shape)) * p.spacing * p.spacing;
  const Dimples dimples = lattice_points(d);
  for (const Dimple& dimple : dimples)
    for (std::size_t k = 0; k < borders.size(); ++k)
      RC_ASSERT(inside(borders[k], place(d, dimple.lattice)) == (int(k) == dimple.patch));
  for (const Polygon& border : borders) {
    RC_ASSERT(int(border.size()) == corners(p.shape));
    RC_ASSERT(std::abs(area(border) - points * cell) < 1e-9 * points * cell);
  }
}

TEST(PatchDivision, NeighboursShareCornersSoThatThreeHexagonsAndSixTrianglesMeet) {
  for (PatchShape shape : kShapes) {
    PatchPattern p{shape, 1.0, 4, HelixOrder::Inward, HelixStart::SameCorner};
    const PatchDivision d = cover(p, Box2(Vec2(-30, -30), Vec2(30, 30)));
    std::map<std::pair<long, long>, int> meet;
    for (const Polygon& border : outlines(d))
      for (const Vec2& c : border) ++meet[{std::lround(c.x() * 1e6), std::lround(c.y() * 1e6)}];
    const int full = traits(shape).lattice == LatticeKind::Square ? 4
                     : shape == PatchShape::Hexagon               ? 3
                                                                  : 6;
    int inner = 0;
    for (const auto& [corner, count] : meet) {
      EXPECT_LE(count, full);
      if (std::abs(corner.first) < 25e6 && std::abs(corner.second) < 25e6) {
        EXPECT_EQ(count, full);
        ++inner;
      }
    }
    EXPECT_GT(inner, 20);
  }
}

TEST(PatchDivision, LinesRunOnAcrossBorders) {
  // around every dimple, all neighbours at one spacing are there, whichever patch they are in
  for (PatchShape shape : kShapes) {
    PatchPattern p{shape, 0.5, 5, HelixOrder::Inward, HelixStart::SameCorner};
    const PatchDivision d = cover(p, Box2(Vec2(-10, -10), Vec2(10, 10)));
    std::map<LatticePoint, int> patch;
    for (const Dimple& dimple : lattice_points(d)) patch[dimple.lattice] = dimple.patch;
    int across = 0;
    for (const auto& [at, k] : patch) {
      if (!Box2(Vec2(-9, -9), Vec2(9, 9)).contains(place(d, at))) continue;
      for (const LatticePoint& s : neighbour_steps(lattice_of(shape))) {
        const LatticePoint next{at[0] + s[0], at[1] + s[1]};
        ASSERT_EQ(patch.count(next), 1u);
        ASSERT_NEAR((place(d, next) - place(d, at)).norm(), 0.5, 1e-12);
        across += patch[next] != k;
      }
    }
    EXPECT_GT(across, 500);
  }
}

TEST(PatchDivision, BlocksOfSquaresAreCentredAndWhole) {
  const PatchDivision d = patch_block({PatchShape::Square, 0.5, 14, HelixOrder::Outward}, 8, 7);
  EXPECT_NEAR((place(d, LatticePoint{0, 0}) + place(d, LatticePoint{111, 97})).norm(), 0.0, 1e-12);
  std::set<LatticePoint> seen;
  for (const Dimple& dimple : lattice_points(d)) {
    ASSERT_TRUE(seen.insert(dimple.lattice).second);
    ASSERT_TRUE(dimple.lattice[0] >= 0 && dimple.lattice[0] < 112);
    ASSERT_TRUE(dimple.lattice[1] >= 0 && dimple.lattice[1] < 98);
  }
  EXPECT_EQ(seen.size(), 112u * 98u);
}

TEST(PatchDivision, CoverTakesNoMoreSquaresThanNeeded) {
  const PatchPattern p{PatchShape::Square, 0.5, 14, HelixOrder::Inward, HelixStart::SameCorner};
  EXPECT_EQ(cover(p, Box2(Vec2(3, 4), Vec2(59, 60))).cells.size(), 64u);
  EXPECT_EQ(cover(p, Box2(Vec2(3, 4), Vec2(10, 11))).cells.size(), 1u);
  EXPECT_EQ(cover(p, Box2(Vec2(0, 0), Vec2(57, 20))).cells.size(), 27u);
}

TEST(PatchDivision, LinksAreShort) {
  for (PatchShape shape : kShapes) {
    PatchPattern p{shape, 0.5, 8, HelixOrder::Inward, HelixStart::SameCorner};
    const Box2 box(Vec2(-40, -40), Vec2(40, 40));
    const PatchDivision same = cover(p, box);
    p.start = HelixStart::NearestCorner;
    const PatchDivision nearest = cover(p, box);
    EXPECT_EQ(same.cells.size(), nearest.cells.size());
    // The way from a centre to the next patch is at least an inradius; with the nearest corner
    // links stay under the patch's own width.
    const Polygon border = outlines(same).front();
    double width = 0.0;
    for (const Vec2& c : border) width = std::max(width, (c - border[0]).norm());
    const double links = double(same.cells.size() - 1);
    EXPECT_LT(link_length(nearest), (is_regular(shape) ? 0.9 : 1.0) * link_length(same));
    EXPECT_LT(link_length(nearest) / links, width);
  }
}

TEST(PatchDivision, KeepPatchesDropsWholePatches) {
  const PatchPattern p{PatchShape::Hexagon, 1.0, 3, HelixOrder::Inward, HelixStart::SameCorner};
  const PatchDivision all = cover(p, Box2(Vec2(-40, -40), Vec2(40, 40)));
  const PatchDivision right =
      keep_patches(all, [&](const LatticePoint& at) { return place(all, at).x() > 0.0; });
  EXPECT_LT(right.cells.size(), all.cells.size());
  std::vector<bool> wanted(right.cells.size(), false);
  for (const Dimple& dimple : lattice_points(right))
    if (place(right, dimple.lattice).x() > 0.0) wanted[dimple.patch] = true;
  for (bool w : wanted) EXPECT_TRUE(w);
}

TEST(PatchDivision, BadInputIsNamed) {
  auto property = [](auto&& call) -> std::string {
    try {
      call();
    } catch (const InputError& e) {
      return e.property();
    }
    return "";
  };
  PatchPattern p{PatchShape::Hexagon, 1.0, 3, HelixOrder::Inward, HelixStart::SameCorner};
  const Box2 box(Vec2(0, 0), Vec2(10, 10));
  EXPECT_EQ(property([&] { cover(p, box); }), "");
  EXPECT_EQ(property([&] { cover(p, Box2()); }), "Area");
  EXPECT_EQ(property([&] { cover(p, Box2(Vec2(0, 0), Vec2(1e9, 1e9))); }), "Spacing");
  EXPECT_EQ(property([&] { cover(p, Box2(Vec2(0, 0), Vec2(1e15, 0))); }), "Spacing");
  EXPECT_EQ(property([&] { patch_block(p, 0, 1); }), "PatchesX");
  p.size = -1;
  EXPECT_EQ(property([&] { cover(p, box); }), "PatchSide");
  p.size = 0;
  EXPECT_EQ(property([&] { cover(p, box); }), "") << "a hexagon of one point";
  p.spacing = std::nan("");
  EXPECT_EQ(property([&] { cover(p, box); }), "Spacing");
}

}  // namespace
}  // namespace patchmill::patch

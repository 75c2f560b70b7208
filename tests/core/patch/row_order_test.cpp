// Rows: the same dimples, each once, straight on along one step of the lattice, to and fro or one way.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/row_order.h"

#include "patchmill/geometry/error.h"
#include "patchmill/patch/cover.h"
#include "table1_surface.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::patch {
namespace {

PatchShape shape_of(unsigned seed) {
  return static_cast<PatchShape>(seed % 3);
}

Dimples block(PatchShape shape, int size, int nx, int ny) {
  return lattice_points(patch_block({shape, 0.5, size}, nx, ny));
}

LatticePoint step(const Dimple& a, const Dimple& b) {
  return {b.lattice[0] - a.lattice[0], b.lattice[1] - a.lattice[1]};
}

bool along(const LatticePoint& way, const LatticePoint& row) {
  return way[0] * row[1] == way[1] * row[0];
}

RC_GTEST_PROP(RowOrder, HasTheSameDimplesAndRunsAlongItsStep,
              (unsigned seed, bool one_way, bool whole)) {
  const PatchShape shape = shape_of(seed);
  Dimples dimples = block(shape, 2 + seed / 3 % 4, 1 + seed / 12 % 3, 1 + seed / 36 % 3);
  for (std::size_t k = seed % 7; k < dimples.size(); k += 9) dimples[k].state = DimpleState::Masked;
  const LatticeKind kind = lattice_of(shape);
  const auto& steps = neighbour_steps(kind);
  const RowOrder order{whole ? RowExtent::WholeFace : RowExtent::EachPatch,
                       seed / 108 % steps.size(), one_way};
  const Dimples ordered = in_rows(dimples, kind, order);
  std::set<LatticePoint> before, after;
  for (const Dimple& d : dimples) before.insert(d.lattice);
  for (const Dimple& d : ordered) after.insert(d.lattice);
  RC_ASSERT(ordered.size() == dimples.size());
  RC_ASSERT(before == after);
  const auto cut = std::size_t(count_states(dimples)[0]);
  RC_ASSERT(std::size_t(count_states(ordered)[0]) == cut);
  const LatticePoint row = steps[order.direction];
  int sense = 0;
  for (std::size_t k = 1; k < cut; ++k) {
    RC_ASSERT(ordered[k].state == DimpleState::Cut);
    const LatticePoint way = step(ordered[k - 1], ordered[k]);
    const bool next = !along(way, row) || (!whole && ordered[k].patch != ordered[k - 1].patch);
    if (whole) RC_ASSERT(ordered[k].patch == ordered[k - 1].patch + int(next));
    if (next) {
      sense = one_way || (!whole && ordered[k].patch != ordered[k - 1].patch) ? 0 : -sense;
      continue;
    }
    const int here = way[0] * row[0] + way[1] * row[1] > 0 ? 1 : -1;
    if (one_way) RC_ASSERT(here == 1);
    if (sense != 0) RC_ASSERT(here == sense);
    sense = here;
  }
}

TEST(RowOrder, OfASquareBlockIsALineToAndFro) {
  const Dimples rows = in_rows(block(PatchShape::Square, 3, 2, 2), LatticeKind::Square, {});
  ASSERT_EQ(rows.size(), 36u);
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const LatticePoint way = step(rows[k - 1], rows[k]);
    EXPECT_EQ(lattice_distance(LatticeKind::Square, way), 1) << k;
    EXPECT_EQ(way[1], k % 6 == 0 ? 1 : 0) << k;
  }
}

TEST(RowOrder, OfRowsFarApartIsThatOfRowsSideBySide) {
  Dimples near = block(PatchShape::Square, 5, 2, 2), far = near;
  for (Dimple& dimple : far) dimple.lattice[1] *= 1000;
  const LatticeKind kind = lattice_of(PatchShape::Square);
  const Dimples one = in_rows(near, kind, {}), other = in_rows(far, kind, {});
  for (std::size_t k = 0; k < near.size(); ++k) {
    EXPECT_EQ(one[k].lattice[0], other[k].lattice[0]);
    EXPECT_EQ(1000 * one[k].lattice[1], other[k].lattice[1]);
  }
}

TEST(RowOrder, RefusesAStepThatTheLatticeHasNot) {
  try {
    in_rows(block(PatchShape::Square, 2, 1, 1), LatticeKind::Square,
            {RowExtent::WholeFace, 2, false});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.property(), "RowDirection");
  }
}

TEST(RowOrder, DirectionsNearestToXAndY) {
  EXPECT_EQ(nearest_step(LatticeKind::Square, {1.0, 0.2}), 0u);
  EXPECT_EQ(nearest_step(LatticeKind::Square, {0.0, -1.0}), 1u);
  EXPECT_EQ(nearest_step(LatticeKind::Triangular, {-1.0, 0.0}), 0u);
  EXPECT_EQ(nearest_step(LatticeKind::Triangular, {0.3, 1.0}), 1u);
  EXPECT_EQ(nearest_step(LatticeKind::Triangular, {-0.3, 1.0}), 2u);
}

// A cylinder bends across its axis only.
TEST(RowOrder, FlattestAlongACylinder) {
  for (const bool along_x : {true, false}) {
    Dimples dimples = block(PatchShape::Square, 6, 2, 2);
    for (Dimple& d : dimples) {
      const double x = 0.5 * d.lattice[0], y = 0.5 * d.lattice[1], across = along_x ? y : x;
      const Vec3 normal(along_x ? 0.0 : std::sin(across / 9.0),
                        along_x ? std::sin(across / 9.0) : 0.0, std::cos(across / 9.0));
      d.surface = {Vec3(along_x ? x : 0.0, along_x ? 0.0 : y, 0.0) + 9.0 * normal, normal};
    }
    EXPECT_EQ(flattest_step(dimples, LatticeKind::Square), along_x ? 0u : 1u);
  }
}

}  // namespace
}  // namespace patchmill::patch

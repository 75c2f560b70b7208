// Steepness limit, margin, slivers and masks.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/boundary.h"

#include "analytic_surfaces.h"
#include "patchmill/geometry/error.h"
#include "patchmill/patch/cover.h"
#include "patchmill/patch/mask.h"
#include "patchmill/patch/patch_surface.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::patch {
namespace {

using namespace analytic;

struct Plate {
  PatchDivision division;
  Dimples dimples;
  Vec2 at(std::size_t k) const { return place(division, dimples[k].lattice); }
  LatticePlace place_of() const {
    return [d = division](const Vec2& lattice) { return place(d, lattice); };
  }
  std::int64_t count(DimpleState s) const {
    return count_states(dimples)[static_cast<std::size_t>(s)];
  }
};

Plate plate(const Ray& surface, PatchShape shape = PatchShape::Square, double half = 8.0) {
  const TexturePlane plane;
  Plate p;
  p.division = cover({shape, 0.25, 8}, Box2(Vec2(-half, -half), Vec2(half, half)));
  p.dimples = *sample_patches(p.division, plane, by_rays(plane, surface), {SurfaceKind::Curved});
  return p;
}

TEST(Boundary, SteepnessOnASphereIsTheLatitude) {
  Plate p = plate(sphere(Vec3::Zero(), 7.0));
  limit_steepness(p.dimples, -Vec3::UnitZ(), Angle::degrees(40));
  for (std::size_t k = 0; k < p.dimples.size(); ++k) {
    const double r = p.at(k).norm();
    if (std::abs(r - 7.0 * std::sin(Angle::degrees(40).radians())) < 1e-9) continue;
    const DimpleState want = r >= 7.0 ? DimpleState::OffFace
                             : r > 7.0 * std::sin(Angle::degrees(40).radians())
                                 ? DimpleState::TooSteep
                                 : DimpleState::Cut;
    ASSERT_EQ(p.dimples[k].state, want);
  }
  EXPECT_THROW(limit_steepness(p.dimples, -Vec3::UnitZ(), Angle::degrees(0)), InputError);
}

TEST(Boundary, LimitsOutOfRangeAreNamed) {
  const auto refused = [](auto call) -> std::string {
    Dimples dimples(1);
    try {
      call(dimples);
    } catch (const InputError& error) {
      return error.property();
    }
    return "";
  };
  for (const double degrees : {0.0, -10.0, 90.001, 120.0, std::nan("")})
    EXPECT_EQ(
        refused([&](Dimples& d) { limit_steepness(d, -Vec3::UnitZ(), Angle::degrees(degrees)); }),
        "SteepnessLimit")
        << degrees;
  for (const double margin : {-1e-6, -5.0, std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_EQ(refused([&](Dimples& d) { keep_off_edges(d, {}, margin); }), "Margin") << margin;
  EXPECT_EQ(refused([](Dimples& d) {
              limit_steepness(d, -Vec3::UnitZ(), Angle::degrees(90.0));
              keep_off_edges(d, {}, 0.0);
            }),
            "");
}

TEST(Boundary, FacesThatLookAwayAreUndercut) {
  Dimples dimples(2);
  dimples[0].surface.normal = Vec3(1, 0, -0.1).normalized();
  dimples[1].surface.normal = Vec3(1, 0, 0.1).normalized();
  limit_steepness(dimples, -Vec3::UnitZ(), Angle::degrees(45));
  EXPECT_EQ(dimples[0].state, DimpleState::Undercut);
  EXPECT_EQ(dimples[1].state, DimpleState::TooSteep);
}

RC_GTEST_PROP(Boundary, MarginIsTheDistanceToTheNearestSegment, ()) {
  auto number = [] { return *rc::gen::inRange(-400, 400) * 0.01; };
  Plate p = plate(waves(1.0, 9.0), PatchShape::Triangle, 3.0);
  std::vector<Segment3> edges;
  for (int n = *rc::gen::inRange(1, 6); n > 0; --n)
    edges.push_back(
        {Vec3(number(), number(), 0.1 * number()), Vec3(number(), number(), 0.1 * number())});
  const double margin = *rc::gen::inRange(1, 300) * 0.01;
  keep_off_edges(p.dimples, edges, margin);
  for (const Dimple& dimple : p.dimples) {
    double nearest = 1e9;
    for (const Segment3& s : edges)  // the nearest of finely spaced points of the segment, refined
      for (double lo = 0, hi = 1, n = 0; n < 40; ++n) {
        const double a = lo + 0.382 * (hi - lo), b = lo + 0.618 * (hi - lo);
        auto far = [&](double t) {
          return (dimple.surface.position - s.a - t * (s.b - s.a)).norm();
        };
        (far(a) < far(b) ? hi : lo) = far(a) < far(b) ? b : a;
        nearest = std::min({nearest, far(lo), far(hi), far(0), far(1)});
      }
    if (std::abs(nearest - margin) < 1e-6) continue;
    RC_ASSERT((dimple.state == DimpleState::NearEdge) == (nearest < margin));
  }
}

TEST(Boundary, SliversGoWholePatchByPatch) {
  Plate p = plate(trimmed(waves(0.1, 9.0),
                          [](const SurfacePoint& s) { return s.position.head<2>().norm() < 6.0; }));
  const std::int64_t cut = p.count(DimpleState::Cut);
  std::map<int, int> on_patch;
  for (const Dimple& d : p.dimples) on_patch[d.patch] += d.state == DimpleState::Cut;
  drop_slivers(p.dimples, 20);
  std::int64_t dropped = 0;
  for (const Dimple& d : p.dimples) {
    ASSERT_EQ(d.state == DimpleState::Cut,
              d.state != DimpleState::OffFace && on_patch[d.patch] >= 20);
    dropped += d.state == DimpleState::Sliver;
  }
  EXPECT_GT(dropped, 0);
  EXPECT_EQ(p.count(DimpleState::Cut) + dropped, cut);
  EXPECT_THROW(drop_slivers(p.dimples, -1), InputError);
}

TEST(Mask, CurvesWithHolesKeepTheInside) {
  // a ring of two polygons; against the distance to the centre, for polygons of many sides
  Polygon outer, inner;
  for (int i = 0; i < 2000; ++i) {
    const double t = 2 * kPi * i / 2000;
    outer.push_back({6 * std::cos(t), 6 * std::sin(t)});
    inner.push_back({3 * std::cos(-t), 3 * std::sin(-t)});
  }
  Plate p = plate(flat(Vec3::Zero(), Vec3::UnitZ()));
  keep_where(p.dimples, p.place_of(), curve_mask({outer, inner}));
  for (std::size_t k = 0; k < p.dimples.size(); ++k) {
    const double r = p.at(k).norm();
    ASSERT_EQ(p.dimples[k].state == DimpleState::Cut, r > 3.0 && r < 6.0) << r;
  }
  EXPECT_THROW(curve_mask({{{0, 0}, {1, 0}}}), InputError);
}

RC_GTEST_PROP(Mask, InsideIsTheWindingParity, ()) {
  auto number = [] { return *rc::gen::inRange(-1000, 1000) * 0.01; };
  Polygon loop;
  for (int n = *rc::gen::inRange(3, 12); n > 0; --n) loop.push_back({number(), number()});
  const Mask mask = curve_mask({loop});
  for (int n = 0; n < 50; ++n) {
    const Vec2 p(number() + 0.0013, number() + 0.0017);
    double turns = 0.0;  // winding number by angles
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 a = loop[i] - p, b = loop[(i + 1) % loop.size()] - p;
      turns += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)) / (2 * kPi);
    }
    RC_ASSERT((mask(p) > 0.5) == (std::lround(turns) % 2 != 0));
  }
}

TEST(Mask, ImageIsBilinearWithTheTopUp) {
  Image ramp{5, 4, {}};
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 5; ++c) ramp.values.push_back(0.1f * c + 0.1f * r);
  const Mask mask = image_mask(ramp, Box2(Vec2(10, 20), Vec2(15, 24)), 0.25);
  EXPECT_NEAR(mask({12.5, 22.0}), 0.2 + 0.15, 1e-6) << "the middle";
  EXPECT_NEAR(mask({10.5, 23.5}), 0.0, 1e-6) << "first pixel: top left";
  EXPECT_NEAR(mask({14.5, 20.5}), 0.7, 1e-6) << "last pixel: bottom right";
  EXPECT_NEAR(mask({12.0, 23.0}), 0.15 + 0.05, 1e-6) << "between four";
  EXPECT_EQ(mask({9.0, 22.0}), 0.25);
  EXPECT_THROW(image_mask({2, 2, {0, 0, 0}}, Box2(Vec2(0, 0), Vec2(1, 1))), InputError);
  EXPECT_THROW(image_mask({1, 1, {2.0f}}, Box2(Vec2(0, 0), Vec2(1, 1))), InputError);
  EXPECT_THROW(image_mask({1, 1, {1.0f}}, Box2(Vec2(0, 0), Vec2(0, 1))), InputError);
}

TEST(Mask, DitherLeavesTheShareEvenly) {
  for (double share : {0.0, 0.1, 0.25, 0.5, 0.77, 1.0}) {
    Plate p = plate(flat(Vec3::Zero(), Vec3::UnitZ()));
    thin_out(p.dimples, p.place_of(), [=](const Vec2&) { return share; });
    // every 8 x 8 block of the lattice has the same number, the share of 64 rounded up
    std::map<std::pair<int, int>, int> block;
    for (const Dimple& d : p.dimples)
      block[{d.lattice[0] >> 3, d.lattice[1] >> 3}] += d.state == DimpleState::Cut;
    for (const auto& [at, n] : block) ASSERT_EQ(n, int(std::ceil(share * 64)));
  }
}

TEST(Mask, DepthIsLinearInTheMask) {
  Plate p = plate(flat(Vec3::Zero(), Vec3::UnitZ()));
  set_depth(
      p.dimples, p.place_of(), [](const Vec2& at) { return 0.5 + at.x() / 20; }, 0.0, 0.04, 0.01);
  for (std::size_t k = 0; k < p.dimples.size(); ++k) {
    const double depth = 0.04 * (0.5 + p.at(k).x() / 20);
    ASSERT_NEAR(p.dimples[k].depth, depth, 1e-15);
    ASSERT_EQ(p.dimples[k].state == DimpleState::Masked, depth < 0.01);
  }
}

}  // namespace
}  // namespace patchmill::patch

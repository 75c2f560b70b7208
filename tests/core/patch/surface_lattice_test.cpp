// Lattices laid on the surface: lengths that must be kept are kept, distortion against closed
// forms.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/surface_lattice.h"

#include "analytic_surfaces.h"
#include "patchmill/geometry/error.h"
#include "patchmill/patch/boundary.h"
#include "patchmill/patch/cover.h"
#include "patchmill/patch/patch_surface.h"

#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::patch {
namespace {

using namespace analytic;

constexpr PatchShape shape_of(LatticeKind kind) {
  return kind == LatticeKind::Square ? PatchShape::Square : PatchShape::Hexagon;
}

struct Laid {
  Dimples dimples;
  SpacingSpread spread;
};

// Dimples of a mapping on a surface over the standard texture plane, up to a slope. The surface
// ends at the area's border; with `end_beyond`, only for the dimples, so that the map has it
// beyond.
Laid lay(Mapping mapping, LatticeKind kind, double f, const Ray& surface, double half,
         double slope = 80.0, const Vec2& start = Vec2::Zero(), bool end_beyond = false) {
  const TexturePlane plane;
  const Box2 area(Vec2(-half, -half), Vec2(half, half));
  const auto sampler = by_rays(plane, trimmed(surface, [&](const SurfacePoint& p) {
                                 return area.contains(Vec2(p.position.head<2>()));
                               }));
  const PatchPattern pattern{shape_of(kind), f, 6};
  Laid laid;
  if (mapping == Mapping::Projected) {
    laid.dimples = *sample_patches(cover(pattern, area), plane, sampler, {SurfaceKind::Curved});
  } else {
    LatticeRequest request{kind, f, start, area};
    const auto seen = end_beyond ? by_rays(plane, surface) : sampler;
    request.steepest = Angle::degrees(slope + 2.0);
    const auto lattice = mapping == Mapping::ChebyshevNet
                             ? chebyshev_net(request, plane, seen)
                             : low_distortion_lattice(request, plane, seen);
    const PatchDivision d = cover(pattern, *lattice, area);
    laid.dimples = *sample_patches(d, plane, lattice->place_of, sampler, {SurfaceKind::Curved});
  }
  limit_steepness(laid.dimples, plane.direction, Angle::degrees(slope));
  laid.spread = spacing_spread(laid.dimples, kind, f);
  return laid;
}

std::int64_t cut(const Laid& laid) {
  return count_states(laid.dimples)[0];
}

TEST(ChebyshevNet, KeepsBothSpacingsOnAHemisphereUpTo60Degrees) {
  const double radius = 20.0, f = 0.5;
  const Ray ball = sphere(Vec3::Zero(), radius);
  const double half = radius * std::sin(Angle::degrees(60).radians());
  const Laid net = lay(Mapping::ChebyshevNet, LatticeKind::Square, f, ball, half, 60.0);
  const Laid projected = lay(Mapping::Projected, LatticeKind::Square, f, ball, half, 60.0);
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(net.spread.along[k].least, 1.0, 1e-6);
    EXPECT_NEAR(net.spread.along[k].greatest, 1.0, 1e-6);
  }
  EXPECT_GT(projected.spread.greatest, 1.85) << "1/cos 60 degrees is 2";
  EXPECT_GT(net.spread.least_angle.degrees(), 45.0);
  // It covers the cap: the area 2 pi R² (1 - cos 60°) is that of the meshes, f² sin(angle) each.
  const double cap = 2 * kPi * radius * radius * 0.5;
  EXPECT_GT(double(cut(net)) * f * f, cap);
  EXPECT_LT(double(cut(net)) * f * f * std::sin(net.spread.least_angle.radians()), cap);
}

TEST(ChebyshevNet, AngleIsOffByTheCurvatureOfTheQuadrangle) {
  // Hazzidakis: with straight threads through the start, the angle at (n, n) is 90° less the total
  // curvature of the quadrangle between them, the sum of f² sin(angle)/R² over its meshes
  const double radius = 20.0;
  double error_before = 0.0;
  for (double f : {1.0, 0.5, 0.25}) {
    const int n = static_cast<int>(10 / f);
    const TexturePlane plane;
    const auto sampler = by_rays(plane, sphere(Vec3::Zero(), radius));
    const auto net = *chebyshev_net(
        {LatticeKind::Square, f, Vec2::Zero(), Box2(Vec2(-16, -16), Vec2(16, 16))}, plane, sampler);
    auto at = [&](int i, int j) { return sampler({net.place_of(Vec2(i, j))})[0].point.position; };
    auto angle = [&](int i, int j) {
      const Vec3 a = at(i + 1, j) - at(i, j), b = at(i, j + 1) - at(i, j);
      return std::acos(a.normalized().dot(b.normalized()));
    };
    double curvature = 0.0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) curvature += f * f * std::sin(angle(i, j)) / (radius * radius);
    const double error = std::abs(angle(n, n) - (0.5 * kPi - curvature));
    EXPECT_GT(curvature, 0.2);
    EXPECT_LT(error, 0.07 * f) << "converges with f";
    if (error_before > 0.0) {
      EXPECT_LT(error, 0.7 * error_before);
    }
    error_before = error;
  }
}

TEST(ChebyshevNet, LeavesNoPartOfTheCapOut) {
  // every point of the cap, but for a rim of one spacing, has a dimple as near as in a square mesh;
  // sheared meshes cover better
  const double radius = 20.0, f = 0.5;
  const double half = radius * std::sin(Angle::degrees(60).radians());
  const Laid net =
      lay(Mapping::ChebyshevNet, LatticeKind::Square, f, sphere(Vec3::Zero(), radius), half, 60.0);
  const double reach = f / std::sqrt(2.0) * 1.01;
  for (int a = 0; a < 40; ++a)
    for (int b = 0; b < 12; ++b) {
      const double polar = Angle::degrees(58.0).radians() * b / 12, t = a * 0.1571;
      const Vec3 p = radius * Vec3(std::sin(polar) * std::cos(t), std::sin(polar) * std::sin(t),
                                   std::cos(polar));
      double nearest = 1e9;
      for (const Dimple& d : net.dimples)
        if (d.state == DimpleState::Cut)
          nearest = std::min(nearest, (d.surface.position - p).norm());
      ASSERT_LT(nearest, reach) << "polar angle " << polar << ", around " << t;
    }
}

RC_GTEST_PROP(ChebyshevNet, KeepsSpacingsOnWavesFromAnyStart, ()) {
  const double h = *rc::gen::inRange(0, 200) * 0.01, length = *rc::gen::inRange(1200, 4000) * 0.01;
  const Vec2 start(*rc::gen::inRange(-500, 500) * 0.01, *rc::gen::inRange(-500, 500) * 0.01);
  const Laid net = lay(Mapping::ChebyshevNet, LatticeKind::Square, 0.5, waves(h, length), 8.0, 85.0,
                       start, true);
  for (int k = 0; k < 2; ++k) {
    RC_ASSERT(net.spread.along[k].pairs > 500);
    RC_ASSERT(std::abs(net.spread.along[k].least - 1.0) < 1e-6);
    RC_ASSERT(std::abs(net.spread.along[k].greatest - 1.0) < 1e-6);
  }
}

// On planes and cylinders every lattice can be laid without any change of lengths and angles, over
// holes too.
TEST(OnSurface, DevelopableSurfacesAreUnrolled) {
  const Ray inclined = flat(Vec3(0, 0, 1), Vec3(0.5, 0.3, 1).normalized());
  const Ray holed = trimmed(inclined, [](const SurfacePoint& p) {
    return (p.position - Vec3(4, 3, p.position.z())).norm() > 2.0;
  });
  const Ray tube = cylinder(Vec3(0, 0, -3), Vec3(std::cos(0.4), std::sin(0.4), 0), 12.0);
  int number = 0;
  for (const Ray& surface : {inclined, holed, tube})
    for (LatticeKind kind : {LatticeKind::Square, LatticeKind::Triangular})
      for (Mapping mapping : {Mapping::ChebyshevNet, Mapping::LowDistortion})
        for (bool end_beyond : {true, false}) {
          SCOPED_TRACE(number++);
          const Laid laid = lay(mapping, kind, 0.8, surface, 8.0, 80.0, Vec2::Zero(), end_beyond);
          const double angle = kind == LatticeKind::Square ? 90.0 : 60.0;
          // Distances are chords, f²/24r² short on the tube; twice that is left to the map. Where
          // it must guess the surface beyond its border, it is off a little there.
          const double chord = std::pow(0.8 / 12.0, 2) / 24.0;
          const double tolerance = end_beyond ? 2.0 * chord : 5e-3;
          const double degrees = end_beyond ? 0.05 : 0.5;
          EXPECT_GT(cut(laid), 350);
          EXPECT_NEAR(laid.spread.least, 1.0, tolerance);
          EXPECT_NEAR(laid.spread.greatest, 1.0, tolerance);
          EXPECT_NEAR(laid.spread.least_angle.degrees(), angle, degrees);
          EXPECT_NEAR(laid.spread.greatest_angle.degrees(), angle, degrees);
        }
}

TEST(LowDistortion, HemisphereUpTo60DegreesIsNearMilnorsBound) {
  const double radius = 20.0, f = 0.8, theta = kPi / 3;
  const Ray ball = sphere(Vec3::Zero(), radius);
  const double half = radius * std::sin(theta);
  const Laid projected = lay(Mapping::Projected, LatticeKind::Triangular, f, ball, half, 60.0);
  const double best = theta / std::sin(theta);
  EXPECT_GT(projected.spread.greatest / projected.spread.least, 1.8);
  for (LatticeKind kind : {LatticeKind::Triangular, LatticeKind::Square}) {
    const Laid laid = lay(Mapping::LowDistortion, kind, f, ball, half, 60.0);
    EXPECT_GT(laid.spread.least, 0.83);
    EXPECT_LT(laid.spread.greatest, 1.08);
    EXPECT_LT(laid.spread.rms, 0.05);
    // a lattice has two or three directions only, so it may come a little under the bound
    EXPECT_GT(laid.spread.greatest / laid.spread.least, 0.97 * best);
    EXPECT_LT(laid.spread.greatest / laid.spread.least, 1.06 * best);
  }
}

TEST(LowDistortion, FineLatticesComeOutAsCoarseOnes) {
  const double half = 15.0;
  const Ray ball = sphere(Vec3::Zero(), 20.0);
  const Laid coarse = lay(Mapping::LowDistortion, LatticeKind::Triangular, 0.8, ball, half, 50.0);
  const Laid fine = lay(Mapping::LowDistortion, LatticeKind::Triangular, 0.2, ball, half, 50.0);
  EXPECT_NEAR(fine.spread.rms, coarse.spread.rms, 0.005);
  EXPECT_NEAR(fine.spread.least, coarse.spread.least, 0.03);
  EXPECT_NEAR(fine.spread.greatest, coarse.spread.greatest, 0.03);
}

TEST(OnSurface, NarrowGapsAreCrossed) {
  const Ray gap = trimmed(waves(0.3, 20.0),
                          [](const SurfacePoint& p) { return std::abs(p.position.x() - 3) > 0.6; });
  for (Mapping mapping : {Mapping::ChebyshevNet, Mapping::LowDistortion}) {
    SCOPED_TRACE(int(mapping));
    const Laid laid = lay(mapping, LatticeKind::Square, 0.5, gap, 8.0);
    int beyond = 0;
    for (const Dimple& d : laid.dimples)
      beyond += d.state == DimpleState::Cut && d.surface.position.x() > 3.6;
    EXPECT_GT(beyond, 200);
    EXPECT_GT(laid.spread.least, 0.97);
    EXPECT_LT(laid.spread.greatest, 1.03);
  }
}

// Random waves, steep ones too, with random discs cut out: whatever happens, dimples are on the
// surface under their places and the reasons add up.
RC_GTEST_PROP(OnSurface, RandomFacesGiveOnlySoundDimples, ()) {
  auto number = [](int lo, int hi) { return *rc::gen::inRange(lo, hi) * 0.01; };
  const Ray whole = waves(number(0, 400), number(400, 3000));
  std::vector<std::pair<Vec2, double>> holes;
  for (int n = *rc::gen::inRange(0, 5); n > 0; --n)
    holes.push_back({Vec2(number(-500, 500), number(-500, 500)), number(10, 250)});
  auto inside = [&](const SurfacePoint& p) {
    for (const auto& [centre, radius] : holes)
      if ((p.position.head<2>() - centre).norm() < radius) return false;
    return true;
  };
  const Vec2 start(number(-400, 400), number(-400, 400));
  RC_PRE(inside({Vec3(start.x(), start.y(), 0), Vec3::UnitZ()}));
  const double slope = 70.0;
  const Vec3 normal = whole(Vec3(start.x(), start.y(), 0), -Vec3::UnitZ())->normal;
  // a lattice begins at its start: only where that is too steep to be milled may there be nothing
  const bool steep_start = normal.z() <= std::cos(slope * kPi / 180.0);
  const Mapping mapping = *rc::gen::element(Mapping::ChebyshevNet, Mapping::LowDistortion);
  const LatticeKind kind = *rc::gen::element(LatticeKind::Square, LatticeKind::Triangular);
  const Laid laid = lay(mapping, kind, 0.9, trimmed(whole, inside), 5.0, slope, start);
  std::int64_t sum = 0;
  for (std::int64_t n : count_states(laid.dimples)) sum += n;
  RC_ASSERT(sum == std::int64_t(laid.dimples.size()) && (steep_start || cut(laid) > 0));
  std::set<LatticePoint> seen;
  for (const Dimple& d : laid.dimples) {
    RC_ASSERT(seen.insert(d.lattice).second);
    RC_ASSERT(d.surface.position.allFinite() && d.surface.normal.allFinite());
    if (d.state != DimpleState::Cut) continue;
    RC_ASSERT(inside(d.surface));
    const Vec3 on = whole(d.surface.position, -Vec3::UnitZ())->position;
    RC_ASSERT((on - d.surface.position).norm() < 1e-9);
  }
}

TEST(OnSurface, CancelGivesNothingAndBadInputIsNamed) {
  const TexturePlane plane;
  const auto sampler = by_rays(plane, sphere(Vec3::Zero(), 20.0));
  const Box2 area(Vec2(-10, -10), Vec2(10, 10));
  const auto stop = [](double) { return false; };
  LatticeRequest good{LatticeKind::Square, 0.5, Vec2::Zero(), area};
  EXPECT_FALSE(chebyshev_net(good, plane, sampler, stop));
  EXPECT_FALSE(low_distortion_lattice(good, plane, sampler, stop));
  auto property = [&](auto change) -> std::string {
    LatticeRequest r = good;
    change(r);
    try {
      chebyshev_net(r, plane, sampler);
    } catch (const InputError& e) {
      return e.property();
    }
    return "";
  };
  EXPECT_EQ(property([](LatticeRequest&) {}), "");
  EXPECT_EQ(property([](LatticeRequest& r) { r.spacing = 0; }), "Spacing");
  EXPECT_EQ(property([](LatticeRequest& r) { r.start = {30, 0}; }), "Start");
  EXPECT_EQ(property([](LatticeRequest& r) { r.area = Box2(); }), "Area");
  EXPECT_EQ(property([](LatticeRequest& r) { r.max_nodes = 100; }), "Spacing");
}

}  // namespace
}  // namespace patchmill::patch

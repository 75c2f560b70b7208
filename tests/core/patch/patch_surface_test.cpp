// Planar, pyramid and curved patches on surfaces with a formula.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/patch_surface.h"

#include "analytic_surfaces.h"
#include "patchmill/geometry/error.h"
#include "patchmill/patch/cover.h"

#include <numeric>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <tbb/global_control.h>

namespace patchmill::patch {
namespace {

using namespace analytic;

PatchDivision division(PatchShape shape, int size, double half) {
  return cover({shape, 0.5, size, HelixOrder::Inward, HelixStart::SameCorner},
               Box2(Vec2(-half, -half), Vec2(half, half)));
}

std::int64_t total(const Dimples& dimples) {
  const auto counts = count_states(dimples);
  return std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
}

std::int64_t count(const Dimples& dimples, DimpleState state) {
  return count_states(dimples)[static_cast<std::size_t>(state)];
}

const PatchShape kShapes[] = {PatchShape::Square, PatchShape::Hexagon, PatchShape::Triangle};

RC_GTEST_PROP(Curved, DimplesLieOnTheSphereUnderTheirPlaces, ()) {
  // any direction, any position of the texture plane
  const PatchShape shape =
      *rc::gen::element(PatchShape::Square, PatchShape::Hexagon, PatchShape::Triangle);
  auto angle = [] { return *rc::gen::inRange(-300, 300) * 0.01; };
  const Vec3 towards(std::cos(angle()), std::sin(angle()), 0.5 * angle());
  const TexturePlane plane =
      texture_plane(Vec3(1, 2, 3) - 20.0 * towards.normalized(), towards, {0.1, 0.2, 0.9}, angle());
  const Ray ball = sphere(Vec3(1, 2, 3), 8.0);
  const PatchDivision d = division(shape, 4, 9.0);
  const auto dimples = *sample_patches(d, plane, by_rays(plane, ball), {SurfaceKind::Curved});
  RC_ASSERT(total(dimples) == std::int64_t(lattice_points(d).size()));
  RC_ASSERT(count(dimples, DimpleState::Cut) > 500);
  for (const Dimple& dimple : dimples) {
    const Vec2 at = place(d, dimple.lattice);
    if (std::abs(at.norm() - 8.0) < 1e-9) continue;  // grazing: either is right
    RC_ASSERT((dimple.state == DimpleState::Cut) == (at.norm() < 8.0));
    if (dimple.state != DimpleState::Cut) continue;
    const Vec3 off = dimple.surface.position - plane.at(at);
    RC_ASSERT((off - off.dot(plane.direction) * plane.direction).norm() < 1e-9);
    RC_ASSERT(std::abs((dimple.surface.position - Vec3(1, 2, 3)).norm() - 8.0) < 1e-9);
  }
}

TEST(Planar, BestFitPlaneIsTheBestAndDimplesAreOnIt) {
  const TexturePlane plane;
  const auto sampler = by_rays(plane, waves(1.0, 12.0));
  for (PatchShape shape : kShapes) {
    const PatchDivision d = division(shape, 5, 6.0);
    const auto curved = *sample_patches(d, plane, sampler, {SurfaceKind::Curved});
    const auto planar = *sample_patches(d, plane, sampler, {SurfaceKind::Planar});
    const std::size_t n = planar.size() / d.cells.size();
    for (std::size_t first = 0; first < planar.size(); first += n) {
      const SurfacePoint on = planar[first].surface;
      auto misfit = [&](const Vec3& point, const Vec3& normal) {
        double sum = 0.0;
        for (std::size_t k = first; k < first + n; ++k) {
          const double h = (curved[k].surface.position - point).dot(normal.normalized());
          sum += h * h;
        }
        return sum;
      };
      const double best = misfit(on.position, on.normal);
      for (const Vec3& nudge : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, -1, 0)})
        EXPECT_GT(misfit(on.position, on.normal + 1e-4 * nudge), best - 1e-12);
      for (double lift : {1e-4, -1e-4})
        EXPECT_GT(misfit(on.position + lift * on.normal, on.normal), best);
      for (std::size_t k = first; k < first + n; ++k) {
        ASSERT_NEAR((planar[k].surface.position - on.position).dot(on.normal), 0.0, 1e-12);
        ASSERT_EQ(planar[k].surface.normal, on.normal);
        ASSERT_NEAR((planar[k].surface.position - curved[k].surface.position).head<2>().norm(), 0.0,
                    1e-12);
      }
    }
  }
}

TEST(Planar, CornersOfTrianglesAreOnTheSurface) {
  const TexturePlane plane;
  const Ray surface = waves(1.0, 12.0);
  PatchSurface planar{SurfaceKind::Planar};
  planar.fit = PlaneFit::Corners;
  const PatchDivision d = division(PatchShape::Triangle, 6, 6.0);
  const auto dimples = *sample_patches(d, plane, by_rays(plane, surface), planar);
  const auto borders = outlines(d);
  for (const Dimple& dimple : dimples)
    for (const Vec2& corner : borders[dimple.patch]) {
      const Vec3 on = surface(plane.at(corner), plane.direction)->position;
      ASSERT_NEAR((on - dimple.surface.position).dot(dimple.surface.normal), 0.0, 1e-9);
    }
}

TEST(Planar, PlaneOfFewPointsTakesTheirNormal) {
  const Vec3 down(0, 0, -1), lean = Vec3(0.3, 0, 1).normalized();
  EXPECT_FALSE(best_fit_plane({}, down));
  for (int n = 1; n <= 4; ++n) {
    std::vector<SurfacePoint> line;
    for (int i = 0; i < n; ++i) line.push_back({Vec3(0, i, 0), lean});
    EXPECT_NEAR((best_fit_plane(line, down)->normal - lean).norm(), 0.0, 1e-12) << n;
  }
}

TEST(Pyramid, LiftOnAPlaneIsARoof) {
  // z = lift (1 - distance from the middle / half the side), in the maximum norm, on squares
  const TexturePlane plane;
  PatchSurface pyramid{SurfaceKind::Pyramid};
  pyramid.apex_lift = 0.7;
  const PatchDivision d = division(PatchShape::Square, 8, 6.0);
  const auto sampler = by_rays(plane, flat(Vec3(0, 0, 1), Vec3::UnitZ()));
  const auto dimples = *sample_patches(d, plane, sampler, pyramid);
  const auto borders = outlines(d);
  for (const Dimple& dimple : dimples) {
    const Polygon& b = borders[dimple.patch];
    const Vec2 off = place(d, dimple.lattice) - 0.5 * (b[0] + b[2]);
    const double roof = 0.7 * (1.0 - off.cwiseAbs().maxCoeff() / 2.0);
    ASSERT_NEAR(dimple.surface.position.z(), 1.0 + roof, 1e-12);
    ASSERT_NEAR(dimple.surface.normal.z(), 1.0 / std::hypot(1.0, 0.35), 1e-12);
  }
}

TEST(Pyramid, CornersAndApexAreOnTheSurfaceAndFacetsMeetAtTheEdges) {
  const TexturePlane plane = texture_plane({-6, 3, 30}, {0.2, -0.1, -1}, {1, 0, 0}, 0.3);
  const Ray surface = sphere(Vec3(0, 0, 0), 12.0);
  for (PatchShape shape : kShapes) {
    const PatchDivision d = division(shape, 5, 4.0);
    const auto dimples = *sample_patches(d, plane, by_rays(plane, surface), {SurfaceKind::Pyramid});
    const auto borders = outlines(d);
    for (const Dimple& dimple : dimples) {
      const Polygon& border = borders[dimple.patch];
      Vec2 middle = Vec2::Zero();
      for (const Vec2& c : border) middle += c / double(border.size());
      auto height = [&](const Vec2& at) {
        return (surface(plane.at(at), plane.direction)->position - dimple.surface.position)
            .dot(dimple.surface.normal);
      };
      ASSERT_NEAR(height(middle), 0.0, 1e-9);
      // the facet holds two neighbouring corners, so it meets the next patch's facet between them
      int best = 0;
      for (std::size_t i = 0; i < border.size(); ++i)
        best += std::abs(height(border[i])) < 1e-9 &&
                std::abs(height(border[(i + 1) % border.size()])) < 1e-9;
      ASSERT_GE(best, 1);
      ASSERT_NEAR(dimple.surface.normal.norm(), 1.0, 1e-12);
      ASSERT_LT(dimple.surface.normal.dot(plane.direction), 0.0);
    }
  }
}

TEST(Pyramid, HeightFactorScalesTheApex) {
  // over a sphere cap the square's corners are in one plane: the apex' height is factor x sagitta
  const TexturePlane plane;
  const double radius = 12.0, half = 3.75;
  const PatchDivision d = patch_block({PatchShape::Square, 0.5, 15}, 1, 1);
  const double base = std::sqrt(radius * radius - 2 * half * half);
  for (double factor : {0.0, 0.5, 1.0, 2.0, -1.0}) {
    PatchSurface pyramid{SurfaceKind::Pyramid};
    pyramid.height_factor = factor;
    const auto dimples =
        *sample_patches(d, plane, by_rays(plane, sphere(Vec3::Zero(), radius)), pyramid);
    const Dimple& middle = dimples.back();
    ASSERT_EQ(middle.lattice, (LatticePoint{7, 7}));
    EXPECT_NEAR(middle.surface.position.z(), base + factor * (radius - base), 1e-9);
  }
}

TEST(AllKinds, HoleAndBorderAreCountedAndOrderStays) {
  const TexturePlane plane;
  const Ray plate = trimmed(waves(0.5, 15.0), [](const SurfacePoint& p) {
    return p.position.head<2>().norm() > 2.01 && p.position.head<2>().norm() < 7.01;
  });
  for (SurfaceKind kind : {SurfaceKind::Planar, SurfaceKind::Pyramid, SurfaceKind::Curved})
    for (PatchShape shape : kShapes) {
      const PatchDivision d = division(shape, 5, 8.0);
      const auto dimples = *sample_patches(d, plane, by_rays(plane, plate), {kind});
      const Dimples plain = lattice_points(d);
      ASSERT_EQ(dimples.size(), plain.size());
      std::int64_t on = 0;
      for (std::size_t k = 0; k < plain.size(); ++k) {
        ASSERT_EQ(dimples[k].lattice, plain[k].lattice);
        const double r = place(d, plain[k].lattice).norm();
        const bool inside = r > 2.01 && r < 7.01;
        on += inside;
        ASSERT_EQ(dimples[k].state == DimpleState::Cut, inside);
        ASSERT_TRUE(dimples[k].surface.position.allFinite());
        ASSERT_TRUE(dimples[k].surface.normal.allFinite());
      }
      ASSERT_EQ(count(dimples, DimpleState::Cut) + count(dimples, DimpleState::OffFace),
                std::int64_t(plain.size()));
      ASSERT_EQ(count(dimples, DimpleState::Cut), on);
    }
}

TEST(AllKinds, CancelGivesNothing) {
  const TexturePlane plane;
  const auto sampler = by_rays(plane, waves(0.5, 15.0));
  EXPECT_FALSE(sample_patches(division(PatchShape::Square, 5, 8.0), plane, sampler,
                              {SurfaceKind::Curved}, [](double) { return false; }));
}

TEST(AllKinds, AnyNumberOfThreadsGivesTheSame) {
  const TexturePlane plane;
  const auto sampler = by_rays(plane, waves(0.5, 15.0));
  for (SurfaceKind kind : {SurfaceKind::Planar, SurfaceKind::Pyramid}) {
    const PatchDivision d = division(PatchShape::Hexagon, 3, 15.0);
    const auto many = *sample_patches(d, plane, sampler, {kind});
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const auto single = *sample_patches(d, plane, sampler, {kind});
    for (std::size_t k = 0; k < many.size(); ++k) {
      ASSERT_EQ(many[k].surface.position, single[k].surface.position);
      ASSERT_EQ(many[k].surface.normal, single[k].surface.normal);
    }
  }
}

TEST(Planar, SteepPlanesAreNoFacets) {
  // corners of a patch across the brim of a tall step make a wall
  const TexturePlane plane;
  const auto step = by_rays(plane, height_field([](double x, double) { return x < 0 ? 0.0 : 1e4; },
                                                [](double, double) { return Vec2(0, 0); }));
  const PatchDivision d = patch_block({PatchShape::Square, 0.5, 4}, 1, 1);
  const auto dimples = *sample_patches(d, plane, step, {SurfaceKind::Planar});
  EXPECT_EQ(count(dimples, DimpleState::NoFacet), 16);
}

}  // namespace
}  // namespace patchmill::patch

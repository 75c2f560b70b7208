// Projection on meshes: against all triangles one by one, against the surfaces that they were made from, through
// edges and vertices, under motions, on any number of threads.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/mesh_sampler.h"

#include "analytic_surfaces.h"
#include "mesh_fields.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace patchmill::patch {
namespace {

// The least depth at which a triangle of the mesh contains the line, by barycentric coordinates; NaN for none.
double depth_by_all(const mesh::TriangleMesh& m, const TexturePlane& plane, const Vec2& place) {
  double least = std::nan("");
  for (const auto& t : m.triangles) {
    const Vec3 a = m.vertices[std::size_t(t[0])], b = m.vertices[std::size_t(t[1])],
               c = m.vertices[std::size_t(t[2])];
    Eigen::Matrix3d columns;
    columns << b - a, c - a, -plane.direction;
    if (std::abs(columns.determinant()) < 1e-12) continue;
    const Vec3 found = columns.inverse() * (plane.at(place) - a);
    if (found[0] < 0.0 || found[1] < 0.0 || found[0] + found[1] > 1.0) continue;
    if (!(found[2] >= least)) least = found[2];
  }
  return least;
}

TEST(MeshSampler, EqualsAllTrianglesOneByOne) {
  // random triangles: most lines meet several
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(-8.0, 8.0), side(-3.0, 3.0);
  mesh::TriangleMesh m;
  for (std::int32_t i = 0; i < 300; ++i) {
    const auto vector = [&](auto& of) {
      const double x = of(random), y = of(random);
      return Vec3(x, y, of(random));
    };
    const Vec3 first = vector(at);
    m.vertices.push_back(first);
    m.vertices.push_back(first + vector(side));
    m.vertices.push_back(first + vector(side));
    m.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  for (const Vec3& direction : {Vec3(0, 0, -1), Vec3(1, 2, -3), Vec3(-1, 0.01, 0)}) {
    const TexturePlane plane = texture_plane(-30.0 * direction, direction, {0.3, 1, 0.2}, 0.4);
    const auto places = random_places(3000, 12.0);
    const auto samples = sampler_on(m, plane).sample(places);
    int on = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double depth = depth_by_all(m, plane, places[i]);
      ASSERT_EQ(std::isfinite(depth), on_face(samples[i].state)) << places[i].transpose();
      if (!std::isfinite(depth)) continue;
      ++on;
      const Vec3 expected = plane.at(places[i]) + depth * plane.direction;
      EXPECT_LT((samples[i].point.position - expected).norm(), 1e-9);
    }
    EXPECT_GT(on, 500);
    EXPECT_LT(on, 3000);
  }
}

TEST(MeshSampler, LiesWithinTheChordOfTheSurfaceAndNormalsAreOfSecondOrder) {
  double last = 0.0;
  for (const int n : {40, 80, 160}) {
    const double edge = 2.0 * kHalf / n;
    const MeshSampler sampler = sampler_on(field(n, waves));
    const auto places = random_places(4000, kHalf - 2.0 * edge);
    const auto samples = sampler.sample(places);
    double off = 0.0, turned = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      ASSERT_EQ(samples[i].state, DimpleState::Cut);
      const Vec3& p = samples[i].point.position;
      EXPECT_LT((p.head<2>() - places[i]).norm(), 1e-12);
      off = std::max(off, std::abs(p.z() - waves(p.x(), p.y())));
      turned = std::max(
          turned, Angle::between(samples[i].point.normal, normal_of_waves(p.x(), p.y())).radians());
      EXPECT_NEAR(samples[i].point.normal.norm(), 1.0, 1e-12);
    }
    // second derivatives are at most 0.49, 0.25 and 0.35: the chord of a side or a diagonal
    EXPECT_LT(off, 0.125 * (0.49 + 0.25 + 0.7) * edge * edge);
    if (last > 0.0) {
      EXPECT_LT(turned, last / 3.5) << n;
    }
    last = turned;
  }
  EXPECT_LT(last, 0.003);
}

TEST(MeshSampler, NoRayPassesBetweenTriangles) {
  // every vertex, and points of every edge that are exactly on it or as near as numbers can be
  const mesh::TriangleMesh m = field(24, [](double, double) { return 1.0; });
  for (const double turn : {0.0, 0.3, 1.1}) {
    const TexturePlane plane =
        texture_plane({0.1, 0.7, 3}, {0.2 * turn, -0.1 * turn, -1}, {1, 0, 0}, turn);
    const ObliqueFrame frame(plane);
    std::vector<Vec2> places;
    const double inner = kHalf - 1e-9;
    for (const auto& t : m.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 a = m.vertices[std::size_t(t[k])];
        const Vec3 b = m.vertices[std::size_t(t[(k + 1) % 3])];
        for (const double share : {0.0, 1.0 / 3.0, 0.5, 0.77}) {
          const Vec3 p = a + share * (b - a);
          if (p.head<2>().cwiseAbs().maxCoeff() < inner)
            places.emplace_back(frame.coordinates(p).head<2>());
        }
      }
    ASSERT_GT(places.size(), 5000u);
    for (const SurfaceSample& sample : sampler_on(m, plane).sample(places))
      ASSERT_EQ(sample.state, DimpleState::Cut);
  }
}

TEST(MeshSampler, FirstOfSeveralIsMetAndItsStateIsByTheAngle) {
  const auto inner = analytic::sphere({1, 2, 3}, 5.0);
  mesh::TriangleMesh ball;  // rings of a sphere, closed at its poles
  constexpr std::int32_t kRound = 96, kRings = 48;
  for (std::int32_t j = 0; j <= kRings; ++j)
    for (std::int32_t i = 0; i < kRound; ++i) {
      const double u = 2.0 * kPi * i / kRound, v = kPi * j / kRings;
      const double out = j == 0 || j == kRings ? 0.0 : 5.0 * std::sin(v);
      ball.vertices.emplace_back(1 + out * std::cos(u), 2 + out * std::sin(u), 3 + 5 * std::cos(v));
    }
  for (std::int32_t j = 0; j < kRings; ++j)
    for (std::int32_t i = 0; i < kRound; ++i) {
      const std::int32_t a = j * kRound + i, b = j * kRound + (i + 1) % kRound;
      ball.triangles.push_back({a, a + kRound, b + kRound});
      ball.triangles.push_back({a, b + kRound, b});
    }
  for (const double side : {1.0, -1.0}) {
    const TexturePlane plane = texture_plane({1, 2, 50 * side}, {0, 0, -side}, {1, 0, 0}, 0.0);
    const MeshSampler sampler = sampler_on(mesh::join_vertices(ball), plane, 60.0);
    const auto places = random_places(4000, 6.0);
    const auto samples = sampler.sample(places);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double r = places[i].norm() / 5.0;
      if (r > 1.0) {
        EXPECT_EQ(samples[i].state, DimpleState::OffFace);
      }
      if (r > 0.98) continue;
      const auto exact = inner(plane.at(places[i]), plane.direction);
      ASSERT_TRUE(exact && on_face(samples[i].state));
      EXPECT_GT((samples[i].point.position - Vec3(1, 2, 3)).z() * side, 0.0);
      EXPECT_NEAR((samples[i].point.position - Vec3(1, 2, 3)).norm(), 5.0, 0.01);
      const Vec3 outward = (samples[i].point.position - Vec3(1, 2, 3)).normalized();
      EXPECT_LT((samples[i].point.normal - outward).norm(), 0.005);
      const double limit = std::sin(60.0 * kPi / 180.0);
      if (std::abs(r - limit) > 0.01) {
        EXPECT_EQ(samples[i].state, r > limit ? DimpleState::TooSteep : DimpleState::Cut);
      }
    }
  }
}

TEST(MeshSampler, MovesTurnsAndGrowsWithTheMesh) {
  const mesh::TriangleMesh m = field(30, waves);
  const Eigen::AngleAxisd turn(0.8, Vec3(1, 2, -1).normalized());
  const Vec3 shift(40, -7, 12);
  const auto places = random_places(1000, 11.0);
  const auto before = sampler_on(m).sample(places);
  for (const double size : {1.0, 1e-3, 250.0}) {
    mesh::TriangleMesh moved = m;
    for (Vec3& v : moved.vertices) v = size * (turn * v) + shift;
    TexturePlane plane;
    plane.origin = shift;
    plane.x_axis = turn * plane.x_axis;
    plane.y_axis = turn * plane.y_axis;
    plane.direction = turn * plane.direction;
    std::vector<Vec2> scaled = places;
    for (Vec2& p : scaled) p *= size;
    const auto after = sampler_on(moved, plane).sample(scaled);
    for (std::size_t i = 0; i < places.size(); ++i) {
      ASSERT_EQ(before[i].state, after[i].state) << places[i].transpose();
      if (before[i].state == DimpleState::OffFace) continue;
      const Vec3 expected = size * (turn * before[i].point.position) + shift;
      EXPECT_LT((after[i].point.position - expected).norm(), 1e-12 * (size * 20.0 + 50.0));
      EXPECT_LT((after[i].point.normal - turn * before[i].point.normal).norm(), 1e-9);
    }
  }
}

TEST(MeshSampler, SameSamplesOnAnyNumberOfThreads) {
  const MeshSampler sampler = sampler_on(field(60, waves));
  const auto places = random_places(20000, 11.0);
  const auto many = sampler.sample(places);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const auto alone = sampler.sample(places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    ASSERT_EQ(many[i].state, alone[i].state);
    ASSERT_EQ(many[i].point.position, alone[i].point.position);
    ASSERT_EQ(many[i].point.normal, alone[i].point.normal);
  }
}

TEST(MeshSampler, StopsWhenItIsTold) {
  const MeshSampler sampler = sampler_on(field(10, waves));
  EXPECT_TRUE(sampler.sample(random_places(20000, 9.0), [](double) { return false; }).empty());
}

TEST(MeshSampler, HolesAreOffAndFlippedTrianglesAreUndercut) {
  mesh::TriangleMesh m = field(4, [](double, double) { return 0.0; });
  const auto at = [&](std::size_t triangle) {
    Vec3 sum = Vec3::Zero();
    for (const std::int32_t v : m.triangles[triangle]) sum += m.vertices[std::size_t(v)] / 3.0;
    return Vec2(sum.head<2>());
  };
  const Vec2 gone = at(31), turned = at(10), rest = at(5);
  std::swap(m.triangles[10][0], m.triangles[10][1]);
  m.triangles.pop_back();
  const auto samples = sampler_on(m).sample({gone, turned, rest});
  EXPECT_EQ(samples[0].state, DimpleState::OffFace);
  EXPECT_EQ(samples[1].state, DimpleState::Undercut);
  EXPECT_EQ(samples[2].state, DimpleState::Cut);
  EXPECT_EQ(MeshSurface(m, Angle::degrees(30)).border().size(), 17u);
}

TEST(MeshSampler, TrianglesWithoutAreaChangeNothing) {
  const mesh::TriangleMesh whole = field(12, waves);
  mesh::TriangleMesh m = whole;
  for (std::int32_t i = 0; i < 100; ++i) m.triangles.push_back({i, i, i + 1});
  for (std::int32_t i = 0; i < 100; ++i) m.triangles.push_back({i, i + 1, i});
  const auto places = random_places(2000, 9.9);
  const auto samples = sampler_on(m).sample(places), expected = sampler_on(whole).sample(places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    ASSERT_EQ(samples[i].state, DimpleState::Cut);
    EXPECT_LT((samples[i].point.position - expected[i].point.position).norm(), 1e-12);
    EXPECT_LT((samples[i].point.normal - expected[i].point.normal).norm(), 1e-12);
  }
  const MeshSurface surface(m, Angle::degrees(30));
  for (const auto& corners : surface.normals())
    for (const Vec3& n : corners) EXPECT_NEAR(n.norm(), 1.0, 1e-12);
}

TEST(MeshSampler, CreasesStaySharp) {
  const mesh::TriangleMesh roof = field(2, [](double x, double) { return -0.5 * std::abs(x); });
  const std::vector<Vec2> places{{-1.0, 0.5}, {1.0, 0.5}};
  const auto sharp = sampler_on(roof, TexturePlane(), 80.0, 30.0).sample(places);
  EXPECT_NEAR(sharp[0].point.normal.x(), -std::sqrt(0.2), 1e-12);
  EXPECT_NEAR(sharp[1].point.normal.x(), std::sqrt(0.2), 1e-12);
  const auto smooth = sampler_on(roof, TexturePlane(), 80.0, 60.0).sample(places);
  EXPECT_LT(std::abs(smooth[1].point.normal.x()), 0.2);
}

TEST(MeshSampler, CoversWhatItsTrianglesCover) {
  mesh::TriangleMesh m = field(5, waves);
  m.vertices.emplace_back(500, 500, 0);  // of no triangle
  const auto [low, high] = sampler_on(m).extent();
  EXPECT_LT((low - Vec2(-kHalf, -kHalf)).norm(), 1e-12);
  EXPECT_LT((high - Vec2(kHalf, kHalf)).norm(), 1e-12);
}

}  // namespace
}  // namespace patchmill::patch

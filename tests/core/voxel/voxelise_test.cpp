// Voxelisation against slow independent references: solid angle for inside, separating axes for
// touch.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/voxel/voxelise.h"

#include "patchmill/geometry/error.h"
#include "patchmill/mesh/triangle_bvh.h"
#include "voxel/shapes.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <tbb/global_control.h>

namespace patchmill::voxel {
namespace {

// Inside by the solid angle that the mesh subtends (van Oosterom & Strackee 1983).
bool inside_by_angle(const mesh::TriangleMesh& mesh, const Vec3& p) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[0]] - p, b = mesh.vertices[t[1]] - p,
               c = mesh.vertices[t[2]] - p;
    sum +=
        2.0 * std::atan2(a.dot(b.cross(c)), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                                b.dot(c) * a.norm() + c.dot(a) * b.norm());
  }
  return sum > 2.0 * kPi;
}

// Does a triangle meet the cube of half side `half` about the origin? Separating axes
// (Akenine-Moeller).
bool meets_cube(const Vec3& a, const Vec3& b, const Vec3& c, double half) {
  std::vector<Vec3> axes{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(), (b - a).cross(c - a)};
  for (const Vec3& e : {Vec3(b - a), Vec3(c - b), Vec3(a - c)})
    for (int k = 0; k < 3; ++k) axes.push_back(e.cross(Vec3::Unit(k)));
  for (const Vec3& n : axes) {
    const double reach = half * n.cwiseAbs().sum();
    const double p = a.dot(n), q = b.dot(n), r = c.dot(n);
    if (std::min({p, q, r}) > reach || std::max({p, q, r}) < -reach) return false;
  }
  return true;
}

mesh::TriangleMesh turned(mesh::TriangleMesh mesh, const Eigen::Quaterniond& q, const Vec3& shift) {
  for (Vec3& v : mesh.vertices) v = q * v + shift;
  return mesh;
}

VoxelOptions pitch(double mm) {
  VoxelOptions options;
  options.pitch = mm;
  return options;
}

void compare_with_references(const mesh::TriangleMesh& stock, const mesh::TriangleMesh& part,
                             double mm) {
  const VoxelGrid grid = voxelise(stock, part, pitch(mm));
  Cell cell;
  int surface = 0;
  for (cell.z() = 0; cell.z() < grid.frame.cells.z(); ++cell.z())
    for (cell.y() = 0; cell.y() < grid.frame.cells.y(); ++cell.y())
      for (cell.x() = 0; cell.x() < grid.frame.cells.x(); ++cell.x()) {
        const Vec3 p = grid.frame.centre(cell);
        const VoxelKind kind = grid.at(cell);
        bool touched = false;
        for (const auto& t : part.triangles)
          touched = touched || meets_cube(part.vertices[t[0]] - p, part.vertices[t[1]] - p,
                                          part.vertices[t[2]] - p, mm / 2);
        const bool in_stock = inside_by_angle(stock, p), in_part = inside_by_angle(part, p);
        ASSERT_EQ(kind == VoxelKind::Surface, in_stock && touched) << cell.transpose();
        surface += kind == VoxelKind::Surface;
        if (kind == VoxelKind::Surface) continue;
        ASSERT_EQ(kind == VoxelKind::Part, in_part) << cell.transpose();
        ASSERT_EQ(kind == VoxelKind::Air, !in_stock && !in_part) << cell.transpose();
      }
  EXPECT_GT(surface, 0);
}

TEST(Voxelise, TurnedBlockInABlockEqualsTheReferences) {
  const Eigen::Quaterniond q(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
  const mesh::TriangleMesh part =
      turned(mesh::box_mesh(Vec3::Constant(-2.4), Vec3(3.1, 2.2, 1.9)), q, Vec3(5, 5, 5));
  compare_with_references(mesh::box_mesh(Vec3::Zero(), Vec3(10, 11, 10)), part, 0.73);
}

TEST(Voxelise, SphereInASphereEqualsTheReferences) {
  compare_with_references(shapes::sphere(Vec3(0.1, 0.2, 0.3), 5, 2),
                          shapes::sphere(Vec3(0.3, 0.1, 0.1), 3, 2), 0.61);
}

RC_GTEST_PROP(Voxelise, ParityEqualsSolidAngle, ()) {
  const auto number = [] { return *rc::gen::inRange(-1000, 1000) / 1000.0; };
  const mesh::TriangleMesh mesh =
      shapes::sphere(Vec3(number(), number(), number()), 2 + number(), 2);
  const mesh::TriangleBvh bvh(mesh);
  for (int i = 0; i < 20; ++i) {
    const Vec3 p(3 * number(), 3 * number(), 3 * number());
    const auto cross = mesh::line_crossings(bvh, p.y(), p.z());
    RC_ASSERT(cross.size() % 2 == 0);
    const auto before = std::upper_bound(cross.begin(), cross.end(), p.x()) - cross.begin();
    RC_ASSERT((before % 2 == 1) == inside_by_angle(mesh, p));
  }
}

// Lines through vertices, along edges and in faces: every line still closes, and volumes are exact.
TEST(Voxelise, LinesThroughEdgesAndVerticesAreCountedOnce) {
  // an octahedron whose corners, edges and diagonal planes lie on voxel centres
  const mesh::TriangleMesh part = shapes::sphere(Vec3(8.5, 8.5, 8.5), 5.0, 0);
  const VoxelGrid grid =
      voxelise(mesh::box_mesh(Vec3::Zero(), Vec3::Constant(17)), part, pitch(1.0));
  Cell c;
  for (c.z() = 0; c.z() < 17; ++c.z())
    for (c.y() = 0; c.y() < 17; ++c.y())
      for (c.x() = 0; c.x() < 17; ++c.x()) {
        const int d = (c - Cell::Constant(8)).cwiseAbs().sum();
        if (d < 4) {
          EXPECT_EQ(grid.at(c), VoxelKind::Part) << c.transpose();
        }
        if (d == 5) {
          EXPECT_EQ(grid.at(c), VoxelKind::Surface) << c.transpose();
        }
        if (d > 6) {
          EXPECT_NE(grid.at(c), VoxelKind::Part) << c.transpose();
        }
        if (d > 6) {
          EXPECT_NE(grid.at(c), VoxelKind::Surface) << c.transpose();
        }
      }
}

TEST(Voxelise, FacesInVoxelPlanesMarkBothSides) {
  const VoxelGrid grid = voxelise(mesh::box_mesh(Vec3::Zero(), Vec3(10, 10, 10)),
                                  mesh::box_mesh(Vec3(3, 3, 0), Vec3(7, 7, 5)), pitch(1.0));
  for (const auto& [cell, kind] :
       std::vector<std::pair<Cell, VoxelKind>>{{{2, 5, 2}, VoxelKind::Surface},
                                               {{3, 5, 2}, VoxelKind::Surface},
                                               {{4, 5, 2}, VoxelKind::Part},
                                               {{1, 5, 2}, VoxelKind::Removal},
                                               {{6, 5, 2}, VoxelKind::Surface},
                                               {{7, 5, 2}, VoxelKind::Surface},
                                               {{8, 5, 2}, VoxelKind::Removal},
                                               {{9, 5, 2}, VoxelKind::Exterior},
                                               {{5, 5, 4}, VoxelKind::Surface},
                                               {{5, 5, 5}, VoxelKind::Surface},
                                               {{5, 5, 9}, VoxelKind::Exterior},
                                               {{0, 0, 0}, VoxelKind::Exterior}})
    EXPECT_EQ(grid.at(cell), kind) << cell.transpose();
}

// Whole bricks of air, part and removal volume, and mixed ones, beside each other and at the box's faces.
TEST(Voxelise, TheSkinIsWhatBordersOnAir) {
  const mesh::TriangleMesh ball = shapes::sphere(Vec3::Zero(), 30, 3);
  const mesh::TriangleMesh block = mesh::box_mesh(Vec3(-33, -20, -24), Vec3(24, 20.5, 30));
  const mesh::TriangleMesh cube = mesh::box_mesh(Vec3::Constant(-16), Vec3::Constant(8));
  for (const mesh::TriangleMesh* stock : {&ball, &block}) {
    const VoxelGrid grid = voxelise(*stock, cube, pitch(1.0));
    std::int64_t wrong = 0, skin = 0;
    Cell c;
    for (c.z() = 0; c.z() < grid.frame.cells.z(); ++c.z())
      for (c.y() = 0; c.y() < grid.frame.cells.y(); ++c.y())
        for (c.x() = 0; c.x() < grid.frame.cells.x(); ++c.x()) {
          const VoxelKind kind = grid.at(c);
          bool beside = false;
          for (int side = 0; side < 6; ++side) {
            Cell near = c;
            near[side / 2] += side % 2 == 0 ? -1 : 1;
            beside = beside || grid.at(near) == VoxelKind::Air;
          }
          skin += kind == VoxelKind::Exterior ? 1 : 0;
          wrong += kind == VoxelKind::Exterior && !beside ? 1 : 0;
          wrong += kind == VoxelKind::Removal && beside ? 1 : 0;
        }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(skin, 5000);
  }
}

TEST(Voxelise, RemovalVolumeConvergesToStockMinusPart) {
  const mesh::TriangleMesh stock = mesh::box_mesh(Vec3::Constant(-10), Vec3::Constant(10));
  const mesh::TriangleMesh part = shapes::sphere(Vec3::Zero(), 7, 4);
  const double exact = mesh::volume(stock) - mesh::volume(part);
  for (const double mm : {1.0, 0.5, 0.25}) {
    const VoxelGrid grid = voxelise(stock, part, pitch(mm));
    std::int64_t solid =
        0;  // by centre: all of the box but the part; surface voxels are asked again
    const mesh::TriangleBvh bvh(part);
    Cell c;
    for (c.z() = 0; c.z() < grid.frame.cells.z(); ++c.z())
      for (c.y() = 0; c.y() < grid.frame.cells.y(); ++c.y())
        for (c.x() = 0; c.x() < grid.frame.cells.x(); ++c.x()) {
          const VoxelKind kind = grid.at(c);
          const Vec3 p = grid.frame.centre(c);
          solid += kind == VoxelKind::Part || (kind == VoxelKind::Surface && p.norm() < 6.99);
        }
    const double removed = mesh::volume(stock) - mm * mm * mm * static_cast<double>(solid);
    EXPECT_NEAR(removed, exact, 4.0 * mm * std::sqrt(mesh::surface_area(part)));
  }
}

TEST(Voxelise, OrderOfTrianglesAndThreadsDoNotMatter) {
  const mesh::TriangleMesh stock = mesh::box_mesh(Vec3::Constant(-10), Vec3::Constant(10));
  mesh::TriangleMesh part = shapes::sphere(Vec3(0.3, -0.7, 0.2), 7, 3);
  const VoxelGrid first = voxelise(stock, part, pitch(0.4));
  std::mt19937 random(1);
  std::shuffle(part.triangles.begin(), part.triangles.end(), random);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const VoxelGrid second = voxelise(stock, part, pitch(0.4));
  EXPECT_EQ(first.kind, second.kind);
  EXPECT_EQ(first.table.at, second.table.at);
}

TEST(Voxelise, InsideFunctionsGiveTheSameRemovalVolume) {
  const mesh::TriangleMesh stock = mesh::box_mesh(Vec3::Constant(-10), Vec3::Constant(10));
  const VoxelGrid mesh = voxelise(stock, shapes::sphere(Vec3::Zero(), 7, 5), pitch(0.5));
  const VoxelGrid function =
      voxelise([](const Vec3& p) { return p.cwiseAbs().maxCoeff() < 10; },
               [](const Vec3& p) { return p.norm() < 7; }, mesh.frame, pitch(0.5));
  Cell c;
  for (c.z() = 0; c.z() < 40; ++c.z())
    for (c.y() = 0; c.y() < 40; ++c.y())
      for (c.x() = 0; c.x() < 40; ++c.x()) {
        const VoxelKind a = mesh.at(c), b = function.at(c);
        if (std::abs(mesh.frame.centre(c).norm() - 7) > 1.0) {
          ASSERT_EQ(a, b) << c.transpose();
        }
      }
}

TEST(Voxelise, BadInputIsNamed) {
  const mesh::TriangleMesh stock = mesh::box_mesh(Vec3::Zero(), Vec3::Constant(10));
  mesh::TriangleMesh part = mesh::box_mesh(Vec3::Constant(2), Vec3::Constant(8));
  const auto property = [&](const mesh::TriangleMesh& s, const mesh::TriangleMesh& p,
                            const VoxelOptions& o) {
    try {
      voxelise(s, p, o);
    } catch (const InputError& e) {
      return e.property() + ": " + e.value();
    }
    return std::string("accepted");
  };
  EXPECT_EQ(property(stock, part, pitch(1)), "accepted");
  EXPECT_EQ(property(stock, part, pitch(0)), "voxel size: 0 mm");
  EXPECT_EQ(property(stock, mesh::box_mesh(Vec3::Constant(2), Vec3::Constant(13)), pitch(1)),
            "part: 3.000 mm outside the stock");
  EXPECT_EQ(property(stock, stock, pitch(1)), "removal volume: 0 voxels");
  VoxelOptions fine = pitch(0.01);
  fine.memory_limit = 1e9;
  EXPECT_NE(property(stock, part, fine).find("of the 954 MiB allowed"), std::string::npos);
  mesh::TriangleMesh open = part;
  open.triangles.pop_back();
  EXPECT_EQ(property(stock, open, pitch(1)), "part: an open shell, 3 unmatched edges");
  for (auto& t : part.triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(property(stock, part, pitch(1)), "part: volume -216 mm3");
}

}  // namespace
}  // namespace patchmill::voxel

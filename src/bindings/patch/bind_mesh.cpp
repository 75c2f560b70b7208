// Surfaces that places of a texture plane are projected on, and triangle meshes as such, for Python.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "bindings/surfaces.h"
#include "patchmill/geometry/require.h"
#include "patchmill/mesh/mesh_region.h"
#include "patchmill/patch/mesh_sampler.h"
#include "patchmill/patch/patch_surface.h"
#include "patchmill/patch/seen_best.h"
#include "patchmill/patch/surface_lattice.h"

#include <algorithm>
#include <limits>

namespace patchmill {
namespace {

using Corners = Eigen::Matrix<std::int64_t, -1, 3, Eigen::RowMajor>;
using Vertices = Eigen::Matrix<double, -1, 3, Eigen::RowMajor>;
using Numbers = Eigen::Matrix<std::int64_t, -1, 1>;
constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max() / 3;  // of triangles

py::object place_dimples(const patch::ProjectedSurface& on, const patch::PatchDivision& division,
                         const patch::TexturePlane& plane, const patch::PatchSurface& surface,
                         const patch::SurfaceLattice* lattice, const py::object& progress) {
  std::optional<patch::Dimples> dimples;
  const bool done = watched(progress, [&](const Progress& report) {
    const patch::SurfaceSampler sample = sampler_of(on);
    dimples = lattice ? patch::sample_patches(division, plane, *lattice, sample, surface, report)
                      : patch::sample_patches(division, plane, sample, surface, report);
  });
  return done && dimples ? py::cast(std::move(*dimples)) : py::none();
}

py::dict hits_dict(const patch::ProjectedSurface& on, const Eigen::Matrix<double, -1, 2>& points) {
  std::vector<Vec2> places;
  for (Eigen::Index i = 0; i < points.rows(); ++i) places.emplace_back(points.row(i));
  std::vector<patch::SurfaceSample> hits;
  watched(py::none(), [&](const Progress&) { hits = on.sample(places); });
  py::dict d;
  d["positions"] = rows_of(hits, [](const patch::SurfaceSample& h) { return h.point.position; });
  d["normals"] = rows_of(hits, [](const patch::SurfaceSample& h) { return h.point.normal; });
  d["states"] = column_of<std::uint8_t>(
      hits, [](const patch::SurfaceSample& h) { return static_cast<std::uint8_t>(h.state); });
  return d;
}

void bind_projected(py::module_& m) {
  py::class_<patch::ProjectedSurface>(
      m, "ProjectedSurface",
      "What places of a texture plane are projected on along its direction: see FaceSampler and "
      "MeshSampler.")
      .def(
          "extent",
          [](const patch::ProjectedSurface& s) {
            const auto [low, high] = s.extent();
            return py::make_tuple(low, high);
          },
          "((x, y) least, (x, y) greatest) that it covers in the texture plane [mm]. Raises "
          "nothing.")
      .def("sample", &hits_dict, py::arg("points"),
           "Projects (n, 2) points; a dict of arrays positions, normals, states (a DimpleState "
           "each: CUT, OFF_FACE, TOO_STEEP or UNDERCUT). Raises nothing.")
      .def("place", &place_dimples, py::arg("division"), py::arg("plane"), py::arg("surface"),
           py::arg("lattice") = py::none(), py::arg("progress") = py::none(),
           "Dimples of the division on it, projected or on a lattice laid on it, or None if "
           "`progress` returned False. Raises InputError naming HeightFactor or ApexLift.");
}

mesh::TriangleMesh mesh_of(const Vertices& vertices, const Corners& triangles) {
  mesh::TriangleMesh mesh;
  if (triangles.rows() > kMost || vertices.rows() > kMost)
    throw InputError("Mesh", std::to_string(triangles.rows()) + " triangles",
                     "give at most " + std::to_string(kMost) + ".");
  const auto corner = [](std::int64_t v) {  // what is no vertex stays none
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(v, -1, kMost));
  };
  watched(py::none(), [&](const Progress&) {
    mesh.vertices.reserve(std::size_t(vertices.rows()));
    mesh.triangles.reserve(std::size_t(triangles.rows()));
    for (Eigen::Index i = 0; i < vertices.rows(); ++i) mesh.vertices.emplace_back(vertices.row(i));
    for (Eigen::Index i = 0; i < triangles.rows(); ++i)
      mesh.triangles.push_back(
          {corner(triangles(i, 0)), corner(triangles(i, 1)), corner(triangles(i, 2))});
    mesh::require_indices(mesh, "Mesh");
    mesh = mesh::join_vertices(mesh);
  });
  return mesh;
}

py::array_t<std::int32_t> corners_of(const mesh::TriangleMesh& mesh) {
  py::array_t<std::int32_t> array(
      {static_cast<py::ssize_t>(mesh.triangles.size()), py::ssize_t{3}});
  auto out = array.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < out.shape(0); ++i)
    for (py::ssize_t k = 0; k < 3; ++k) out(i, k) = mesh.triangles[std::size_t(i)][std::size_t(k)];
  return array;
}

void bind_triangles(py::module_& m) {
  py::class_<mesh::TriangleMesh>(m, "TriangleMesh",
                                 "Triangles over shared vertices, open or closed.")
      .def(py::init(&mesh_of), py::arg("vertices"), py::arg("triangles"),
           "(n, 3) vertices [mm] and (m, 3) corners, indices of vertices, anticlockwise seen from "
           "outside; vertices of equal coordinates are made one. Raises InputError naming Mesh.")
      .def_property_readonly(
          "vertices",
          [](const mesh::TriangleMesh& t) {
            return rows_of(t.vertices, [](const Vec3& v) { return v; });
          },
          "[mm], (n, 3).")
      .def_property_readonly("triangles", &corners_of, "Indices into vertices, (m, 3).")
      .def(
          "__len__", [](const mesh::TriangleMesh& t) { return t.triangles.size(); },
          "Number of triangles. Raises nothing.")
      .def("region",
           interruptible([](const mesh::TriangleMesh& t, std::int32_t seed, double angle) {
             return mesh::region_around(t, seed, Angle::radians(angle));
           }),
           py::arg("seed"), py::arg("angle"),
           "Numbers of the triangles that are reached from triangle `seed` over edges whose two "
           "triangles have normals within `angle` [rad]. Raises InputError naming Seed or Angle.")
      .def("nearest", interruptible([](const mesh::TriangleMesh& t, const Vec3& point) {
             require_finite("Point", point, "mm");
             return mesh::nearest_triangle(t, point);
           }),
           py::arg("point"),
           "Number of the triangle nearest to a point [mm]. Raises InputError naming Point.")
      .def("part", interruptible([](const mesh::TriangleMesh& t, const Numbers& triangles) {
             std::vector<std::int32_t> numbers;
             for (const std::int64_t i : triangles)
               numbers.push_back(static_cast<std::int32_t>(
                   std::clamp<std::int64_t>(i, -1, static_cast<std::int64_t>(t.triangles.size()))));
             return mesh::part_of(t, numbers);
           }),
           py::arg("triangles"),
           "The mesh of some of its triangles, by number. Raises InputError naming Triangles.");
}

void bind_mesh_surface(py::module_& m) {
  using Surface = patch::MeshSurface;
  py::class_<Surface, std::shared_ptr<Surface>>(
      m, "MeshSurface", "A mesh with smoothed normals and a tree over it, to be projected on.")
      .def(py::init([](const mesh::TriangleMesh& mesh, double crease) {
             std::shared_ptr<Surface> made;
             watched(py::none(), [&](const Progress&) {
               made = std::make_shared<Surface>(mesh, Angle::radians(crease));
             });
             return made;
           }),
           py::arg("mesh"), py::arg("crease"),
           "Normals are smoothed over edges whose triangles lie within `crease` [rad] of each "
           "other. Raises InputError naming Mesh or Crease.")
      .def_property_readonly("triangle_count",
                             [](const Surface& s) { return s.mesh().triangles.size(); })
      .def_property_readonly(
          "normal_deviation", [](const Surface& s) { return s.normal_deviation().radians(); },
          "Greatest angle between a triangle's own normal and a smoothed one [rad].")
      .def_property_readonly(
          "chord_height", &Surface::chord_height,
          "How far a smooth surface with these normals rises over the edges at most [mm].")
      .def(
          "seen_best", interruptible([](const Surface& s, const Vec3& preferred) {
            const patch::SeenBest found = patch::seen_best(s.area_vectors(), preferred);
            return std::make_pair(found.direction, found.even);
          }),
          py::arg("preferred"),
          "The direction along which it looks largest, and whether it looks to all sides alike, so "
          "that `preferred` or an axis was chosen. Raises InputError naming Direction.")
      .def("keep_off_border",
           interruptible([](const Surface& s, patch::Dimples& dimples, double margin) {
             if (margin != 0.0) patch::keep_off_edges(dimples, s.border(), margin);
           }),
           py::arg("dimples"), py::arg("margin"),
           "Leaves out dimples nearer than `margin` [mm] to an edge that has one triangle only. "
           "Raises InputError naming Margin.");
  py::class_<patch::MeshSampler, patch::ProjectedSurface>(
      m, "MeshSampler", "Projects points of a texture plane on a mesh along its direction.")
      .def(py::init([](std::shared_ptr<Surface> surface, const patch::TexturePlane& plane,
                       double steepest) {
             return patch::MeshSampler(std::move(surface), plane, Angle::radians(steepest));
           }),
           py::arg("surface").none(false), py::arg("plane"), py::arg("steepest"),
           "`steepest` [rad]: greatest angle of normal and -direction. Raises InputError naming "
           "SteepestSlope.");
}

}  // namespace

patch::SurfaceSampler sampler_of(const patch::ProjectedSurface& on) {
  return [&on](const std::vector<Vec2>& places) { return on.sample(places); };
}

void bind_mesh(py::module_& m) {
  bind_projected(m);
  bind_triangles(m);
  bind_mesh_surface(m);
}

}  // namespace patchmill

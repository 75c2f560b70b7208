// Parts and stocks as triangles, for Python.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "bindings/solid.h"
#include "brep/read_shape.h"
#include "brep/tessellate.h"

namespace patchmill {
namespace {

Solid solid_of_brep(const std::string& brep, double deflection, const std::string& property,
                    bool closed) {
  require_named(property);
  TessellationOptions options;
  options.deflection = deflection;
  Tessellation made = tessellate(read_shape(brep, property.c_str()), options);
  if (closed && !made.closed)
    throw InputError(property, "not a closed solid", made.reason + " Repair the shape.");
  if (made.mesh.triangles.empty())
    throw InputError(property, "no faces", made.reason + " Select a shape with faces.");
  return Solid(std::move(made.mesh));
}

using Points = Eigen::Matrix<double, -1, 3, Eigen::RowMajor>;
using Corners = Eigen::Matrix<std::int32_t, -1, 3, Eigen::RowMajor>;

Solid solid_of_arrays(const Points& vertices, const Corners& triangles,
                      const std::string& property) {
  require_named(property);
  mesh::TriangleMesh mesh;
  for (Eigen::Index i = 0; i < vertices.rows(); ++i) mesh.vertices.emplace_back(vertices.row(i));
  for (Eigen::Index i = 0; i < triangles.rows(); ++i)
    mesh.triangles.push_back({triangles(i, 0), triangles(i, 1), triangles(i, 2)});
  mesh::require_closed(mesh, property.c_str());
  return Solid(std::move(mesh));
}

py::array_t<double> closest_distances(const Solid& solid, const Points& points) {
  std::vector<double> d(static_cast<std::size_t>(points.rows()));
  watched(py::none(), [&](const Progress&) {
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      d[i] = mesh::signed_distance(solid.bvh, points.row(i));
  });
  return column_of<double>(d, [](double v) { return v; });
}

}  // namespace

void bind_solids(py::module_& m) {
  py::class_<Solid>(m, "Solid", "A part or stock as triangles, with a tree over them. mm.")
      .def(py::init(&solid_of_arrays), py::arg("vertices"), py::arg("triangles"),
           py::arg("property") = "mesh",
           "(n, 3) corners [mm] and (m, 3) indices; must be closed. Raises InputError naming "
           "`property`.")
      .def_static(
          "box", [](const Vec3& lo, const Vec3& hi) { return Solid(mesh::box_mesh(lo, hi)); },
          py::arg("low"), py::arg("high"),
          "The box between two corners [mm]. Raises InputError naming Box.")
      .def_property_readonly("bounds",
                             [](const Solid& s) {
                               const mesh::Box b = mesh::bounds(s.mesh);
                               return py::make_tuple(b.lo, b.hi);
                             })
      .def_property_readonly("volume", [](const Solid& s) { return mesh::volume(s.mesh); })
      .def_property_readonly(
          "vertices",
          [](const Solid& s) { return rows_of(s.mesh.vertices, [](const Vec3& v) { return v; }); })
      .def_property_readonly(
          "triangles",
          [](const Solid& s) {
            py::array_t<std::int32_t> a(
                {static_cast<py::ssize_t>(s.mesh.triangles.size()), py::ssize_t{3}});
            auto out = a.mutable_unchecked<2>();
            for (py::ssize_t i = 0; i < out.shape(0); ++i)
              for (py::ssize_t k = 0; k < 3; ++k) out(i, k) = s.mesh.triangles[i][k];
            return a;
          })
      .def_property_readonly("triangle_count",
                             [](const Solid& s) { return s.mesh.triangles.size(); })
      .def("signed_distances", &closest_distances, py::arg("points"),
           "Of (n, 3) points from the surface [mm], negative inside; the solid must be closed. "
           "Raises nothing.");
  m.def("solid_of_brep", interruptible(&solid_of_brep), py::arg("brep"), py::arg("deflection"),
        py::arg("property"), py::arg("closed") = true,
        "BREP text as a Solid; `deflection` [mm]. Raises InputError naming `property`, Deflection "
        "or property.");
}

}  // namespace patchmill

// Texture planes, patch division and dimples for Python.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "core/patch/division.h"

namespace patchmill {
namespace {

SquareDivision division_of(double spacing, int side, int patches_x, int patches_y, bool outward) {
  return {spacing, side, patches_x, patches_y, outward ? HelixOrder::Outward : HelixOrder::Inward};
}

py::dict counts_dict(const Dimples& dimples) {
  const auto counts = count_states(dimples);
  py::dict d;
  for (int s = 0; s < kDimpleStates; ++s)
    d[name(static_cast<DimpleState>(s))] = counts[static_cast<std::size_t>(s)];
  return d;
}

py::array_t<double> outline_array(const SquareDivision& division) {
  const auto all = outlines(division);
  py::array_t<double> array({static_cast<py::ssize_t>(all.size()), py::ssize_t{4}, py::ssize_t{2}});
  auto out = array.mutable_unchecked<3>();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k) {
      out(py::ssize_t(i), py::ssize_t(k), 0) = all[i][k].x();
      out(py::ssize_t(i), py::ssize_t(k), 1) = all[i][k].y();
    }
  return array;
}

void bind_dimples(py::module_& m) {
  py::class_<Dimples>(m, "Dimples", "All lattice points tried, in milling order.")
      .def("__len__", [](const Dimples& d) { return d.size(); })
      .def_property_readonly(
          "positions",
          [](const Dimples& d) {
            return rows_of(d, [](const Dimple& v) { return v.surface.position; });
          },
          "Places on the face [mm], (n, 3).")
      .def_property_readonly(
          "normals",
          [](const Dimples& d) {
            return rows_of(d, [](const Dimple& v) { return v.surface.normal; });
          },
          "Unit normals out of the material, (n, 3).")
      .def_property_readonly(
          "states",
          [](const Dimples& d) {
            return column_of<std::uint8_t>(
                d, [](const Dimple& v) { return static_cast<std::uint8_t>(v.state); });
          },
          "0 cut; other numbers index state_names().")
      .def_property_readonly("patches",
                             [](const Dimples& d) {
                               return column_of<std::int32_t>(
                                   d, [](const Dimple& v) { return v.patch; });
                             })
      .def_property_readonly(
          "lattice",
          [](const Dimples& d) {
            return rows_of(d, [](const Dimple& v) { return Vec3(v.lattice[0], v.lattice[1], 0); });
          },
          "Integer lattice coordinates in the first two columns, (n, 3).")
      .def("counts", &counts_dict, "Number of dimples of each state, by name.");
  m.def("state_names", [] {
    std::vector<std::string> names;
    for (int s = 0; s < kDimpleStates; ++s) names.emplace_back(name(static_cast<DimpleState>(s)));
    return names;
  });
}

}  // namespace

void bind_patch(py::module_& m) {
  py::class_<TexturePlane>(m, "TexturePlane", "Origin, axes and projection direction.")
      .def_readonly("origin", &TexturePlane::origin)
      .def_readonly("x_axis", &TexturePlane::x_axis)
      .def_readonly("y_axis", &TexturePlane::y_axis)
      .def_readonly("direction", &TexturePlane::direction);
  m.def("texture_plane", &texture_plane, py::arg("origin"), py::arg("direction"), py::arg("x_hint"),
        py::arg("rotation") = 0.0,
        "A plane at right angles to `direction`, turned by `rotation` [rad].");
  py::class_<SquareDivision>(m, "SquareDivision",
                             "Square patches of side x side dimples, `spacing` [mm] apart.")
      .def(py::init(&division_of), py::arg("spacing"), py::arg("side"), py::arg("patches_x"),
           py::arg("patches_y"), py::arg("outward") = false)
      .def_readonly("spacing", &SquareDivision::spacing)
      .def_readonly("side", &SquareDivision::side)
      .def_readonly("patches_x", &SquareDivision::patches_x)
      .def_readonly("patches_y", &SquareDivision::patches_y)
      .def("outlines", &outline_array, "Corners in the texture plane [mm], (patches, 4, 2).");
  m.def(
      "patches_to_cover",
      [](double spacing, int side, double width, double height) {
        return patches_to_cover(division_of(spacing, side, 1, 1, false), width, height);
      },
      py::arg("spacing"), py::arg("side"), py::arg("width"), py::arg("height"),
      "(patches along x, along y) that cover width x height [mm].");
  bind_dimples(m);
}

}  // namespace patchmill

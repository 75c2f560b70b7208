// Texture planes, patch division and dimples for Python.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "patchmill/geometry/error.h"
#include "patchmill/patch/boundary.h"
#include "patchmill/patch/cover.h"
#include "patchmill/patch/patch_surface.h"

namespace patchmill {
namespace {

PatchPattern pattern_of(const std::string& shape, double spacing, int size,
                        const std::string& order, const std::string& start) {
  PatchPattern pattern;
  pattern.shape = shape_of(shape);
  pattern.order = choose<HelixOrder>(
      "HelixOrder", order, {{"Inward", HelixOrder::Inward}, {"Outward", HelixOrder::Outward}});
  pattern.start = choose<HelixStart>(
      "HelixStart", start,
      {{"Same corner", HelixStart::SameCorner}, {"Nearest corner", HelixStart::NearestCorner}});
  pattern.spacing = spacing;
  pattern.size = size;
  require_valid(pattern);
  return pattern;
}

PatchSurface surface_of(const std::string& kind, const std::string& fit, double height_factor,
                        double apex_lift) {
  PatchSurface surface;
  surface.kind = choose<SurfaceKind>("SurfaceKind", kind,
                                     {{"Planar", SurfaceKind::Planar},
                                      {"Pyramid", SurfaceKind::Pyramid},
                                      {"Curved", SurfaceKind::Curved}});
  surface.fit = choose<PlaneFit>("PlaneFit", fit,
                                 {{"Best fit", PlaneFit::BestFit}, {"Corners", PlaneFit::Corners}});
  surface.height_factor = height_factor;
  surface.apex_lift = apex_lift;
  return surface;
}

py::array_t<double> polygon_array(const Polygon& polygon) {
  py::array_t<double> array({static_cast<py::ssize_t>(polygon.size()), py::ssize_t{2}});
  auto out = array.mutable_unchecked<2>();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    out(py::ssize_t(i), 0) = polygon[i].x();
    out(py::ssize_t(i), 1) = polygon[i].y();
  }
  return array;
}

py::list outline_list(const PatchDivision& division) {
  py::list list;
  for (const Polygon& outline : outlines(division)) list.append(polygon_array(outline));
  return list;
}

py::list lattice_outline_list(const PatchDivision& division) {
  py::list list;
  for (const PatchCell& cell : division.cells)
    list.append(polygon_array(outline_in_lattice(division.pattern, cell)));
  return list;
}

py::array_t<double> places_of(const PatchDivision& division, const Dimples& dimples) {
  Polygon places;
  places.reserve(dimples.size());
  for (const Dimple& dimple : dimples) places.push_back(place(division, dimple.lattice));
  return polygon_array(places);
}

py::dict counts_dict(const Dimples& dimples) {
  const auto counts = count_states(dimples);
  py::dict d;
  for (int s = 0; s < kDimpleStates; ++s)
    d[name(static_cast<DimpleState>(s))] = counts[static_cast<std::size_t>(s)];
  return d;
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
      .def_property_readonly(
          "depths",
          [](const Dimples& d) {
            return column_of<double>(d, [](const Dimple& v) { return v.depth; });
          },
          "How far below the face the bottoms lie [mm].")
      .def("counts", &counts_dict, "Number of dimples of each state, by name.");
  m.def("state_names", [] {
    std::vector<std::string> names;
    for (int s = 0; s < kDimpleStates; ++s) names.emplace_back(name(static_cast<DimpleState>(s)));
    return names;
  });
}

void bind_division(py::module_& m) {
  py::class_<PatchPattern>(m, "PatchPattern", "Shape, spacing [mm], size and helix of patches.")
      .def(py::init(&pattern_of), py::arg("shape"), py::arg("spacing"), py::arg("size"),
           py::arg("order") = "Inward", py::arg("start") = "Same corner")
      .def_readonly("spacing", &PatchPattern::spacing)
      .def_readonly("size", &PatchPattern::size);
  py::class_<PatchSurface>(m, "PatchSurface", "Planar, pyramid or curved patches.")
      .def(py::init(&surface_of), py::arg("kind"), py::arg("fit") = "Best fit",
           py::arg("height_factor") = 1.0, py::arg("apex_lift") = 0.0)
      .def_property_readonly(
          "planar", [](const PatchSurface& s) { return s.kind != SurfaceKind::Curved; },
          "Whether patches are made of planes.")
      .def("__eq__", [](const PatchSurface& a, const PatchSurface& b) {
        return a.kind == b.kind && a.fit == b.fit && a.height_factor == b.height_factor &&
               a.apex_lift == b.apex_lift;
      });
  py::class_<PatchDivision>(m, "PatchDivision", "Patches in milling order.")
      .def("__len__", [](const PatchDivision& d) { return d.cells.size(); })
      .def_readonly("pattern", &PatchDivision::pattern)
      .def("outlines", &outline_list, "Corners of each patch in the texture plane [mm], (k, 2).")
      .def_readonly("anchor", &PatchDivision::anchor, "Place of lattice point (0, 0) [mm].")
      .def("lattice_outlines", &lattice_outline_list,
           "Corners of each patch in lattice coordinates, (k, 2).")
      .def("places", &places_of, py::arg("dimples"),
           "Texture-plane coordinates [mm] of each lattice point, (n, 2).");
  m.def(
      "cover",
      [](const PatchPattern& pattern, const Vec2& low, const Vec2& high) {
        return cover(pattern, Box2(low, high));
      },
      py::arg("pattern"), py::arg("low"), py::arg("high"),
      "The patches that overlap the rectangle from `low` to `high` [mm].");
  m.def(
      "patch_block",
      [](const PatchPattern& pattern, int nx, int ny) { return patch_block(pattern, nx, ny); },
      py::arg("pattern"), py::arg("patches_x"), py::arg("patches_y"),
      "A block of patches centred on the texture plane's origin.");
  m.def("drop_slivers", &drop_slivers, py::arg("dimples"), py::arg("least"),
        "Leaves out the dimples of patches that have fewer than `least`.");
}

}  // namespace

PatchShape shape_of(const std::string& name) {
  return choose<PatchShape>("PatchShape", name,
                            {{"Square", PatchShape::Square},
                             {"Hexagon", PatchShape::Hexagon},
                             {"Triangle", PatchShape::Triangle}});
}

void bind_patch(py::module_& m) {
  py::class_<TexturePlane>(m, "TexturePlane", "Origin, axes and projection direction.")
      .def_readonly("origin", &TexturePlane::origin)
      .def_readonly("x_axis", &TexturePlane::x_axis)
      .def_readonly("y_axis", &TexturePlane::y_axis)
      .def_readonly("direction", &TexturePlane::direction);
  m.def("texture_plane", &texture_plane, py::arg("origin"), py::arg("direction"), py::arg("x_hint"),
        py::arg("rotation") = 0.0,
        "A plane at right angles to `direction`, turned by `rotation` [rad].");
  bind_division(m);
  bind_dimples(m);
}

}  // namespace patchmill

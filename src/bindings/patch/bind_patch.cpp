// Texture planes, patch division and dimples for Python.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "patchmill/geometry/error.h"
#include "patchmill/patch/boundary.h"
#include "patchmill/patch/cover.h"
#include "patchmill/patch/patch_surface.h"

namespace patchmill {
namespace {

patch::PatchPattern pattern_of(const std::string& shape, double spacing, int size,
                               const std::string& order, const std::string& start, int across) {
  patch::PatchPattern pattern;
  pattern.shape = shape_of(shape);
  pattern.order = choose<patch::HelixOrder>(
      "HelixOrder", order,
      {{"Inward", patch::HelixOrder::Inward}, {"Outward", patch::HelixOrder::Outward}});
  pattern.start = choose<patch::HelixStart>("HelixStart", start,
                                            {{"Same corner", patch::HelixStart::SameCorner},
                                             {"Nearest corner", patch::HelixStart::NearestCorner}});
  pattern.spacing = spacing;
  pattern.size = {size, across};
  patch::require_valid(pattern);
  return pattern;
}

patch::PatchSurface surface_of(const std::string& kind, const std::string& fit,
                               double height_factor, double apex_lift) {
  patch::PatchSurface surface;
  surface.kind = choose<patch::SurfaceKind>("SurfaceKind", kind,
                                            {{"Planar", patch::SurfaceKind::Planar},
                                             {"Pyramid", patch::SurfaceKind::Pyramid},
                                             {"Curved", patch::SurfaceKind::Curved}});
  surface.fit = choose<patch::PlaneFit>(
      "PlaneFit", fit,
      {{"Best fit", patch::PlaneFit::BestFit}, {"Corners", patch::PlaneFit::Corners}});
  surface.height_factor = height_factor;
  surface.apex_lift = apex_lift;
  return surface;
}

py::array_t<double> polygon_array(const patch::Polygon& polygon) {
  py::array_t<double> array({static_cast<py::ssize_t>(polygon.size()), py::ssize_t{2}});
  auto out = array.mutable_unchecked<2>();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    out(py::ssize_t(i), 0) = polygon[i].x();
    out(py::ssize_t(i), 1) = polygon[i].y();
  }
  return array;
}

py::list outline_list(const patch::PatchDivision& division) {
  py::list list;
  for (const patch::Polygon& outline : patch::outlines(division))
    list.append(polygon_array(outline));
  return list;
}

py::list lattice_outline_list(const patch::PatchDivision& division) {
  py::list list;
  for (const patch::PatchCell& cell : division.cells)
    list.append(polygon_array(patch::outline_in_lattice(division.pattern, cell)));
  return list;
}

py::array_t<double> places_of(const patch::PatchDivision& division, const patch::Dimples& dimples) {
  patch::Polygon places;
  places.reserve(dimples.size());
  for (const patch::Dimple& dimple : dimples)
    places.push_back(patch::place(division, dimple.lattice));
  return polygon_array(places);
}

py::dict counts_dict(const patch::Dimples& dimples) {
  const auto counts = patch::count_states(dimples);
  py::dict d;
  for (int s = 0; s < patch::kDimpleStates; ++s)
    d[patch::name(static_cast<patch::DimpleState>(s))] = counts[static_cast<std::size_t>(s)];
  return d;
}

void bind_states(py::module_& m) {
  using patch::DimpleState;
  bind_enum<DimpleState>(
      m, "DimpleState",
      "What became of a lattice point: CUT will be milled, all others are left out. OFF_FACE: no "
      "face "
      "there; TOO_STEEP: the face is steeper than the limit; TOOL_TIP: its normal is so near to "
      "the "
      "tool axis that the tip would rub; UNDERCUT: the face looks away; NEAR_EDGE: within the "
      "margin; SLIVER: its patch has too few; MASKED: by an image or a curve; NO_FACET: its planar "
      "patch would stand along the projection; OFF_NET: the lattice does not reach so far; "
      "CROWDED: "
      "too near to another. state_names() has them as phrases, in this order.",
      {{"CUT", DimpleState::Cut},
       {"OFF_FACE", DimpleState::OffFace},
       {"TOO_STEEP", DimpleState::TooSteep},
       {"TOOL_TIP", DimpleState::ToolTip},
       {"UNDERCUT", DimpleState::Undercut},
       {"NEAR_EDGE", DimpleState::NearEdge},
       {"SLIVER", DimpleState::Sliver},
       {"MASKED", DimpleState::Masked},
       {"NO_FACET", DimpleState::NoFacet},
       {"OFF_NET", DimpleState::OffNet},
       {"CROWDED", DimpleState::Crowded}});
}

void bind_dimples(py::module_& m) {
  bind_states(m);
  py::class_<patch::Dimples>(m, "Dimples", "All lattice points tried, in milling order.")
      .def(
          "__len__", [](const patch::Dimples& d) { return d.size(); },
          "How many lattice points were tried. Raises nothing.")
      .def_property_readonly(
          "positions",
          [](const patch::Dimples& d) {
            return rows_of(d, [](const patch::Dimple& v) { return v.surface.position; });
          },
          "Places on the face [mm], (n, 3).")
      .def_property_readonly(
          "normals",
          [](const patch::Dimples& d) {
            return rows_of(d, [](const patch::Dimple& v) { return v.surface.normal; });
          },
          "Unit normals out of the material, (n, 3).")
      .def_property_readonly(
          "states",
          [](const patch::Dimples& d) {
            return column_of<std::uint8_t>(
                d, [](const patch::Dimple& v) { return static_cast<std::uint8_t>(v.state); });
          },
          "The DimpleState of each.")
      .def_property_readonly("patches",
                             [](const patch::Dimples& d) {
                               return column_of<std::int32_t>(
                                   d, [](const patch::Dimple& v) { return v.patch; });
                             })
      .def_property_readonly(
          "lattice",
          [](const patch::Dimples& d) {
            return rows_of(
                d, [](const patch::Dimple& v) { return Vec3(v.lattice[0], v.lattice[1], 0); });
          },
          "Integer lattice coordinates in the first two columns, (n, 3).")
      .def_property_readonly(
          "depths",
          [](const patch::Dimples& d) {
            return column_of<double>(d, [](const patch::Dimple& v) { return v.depth; });
          },
          "How far below the face the bottoms lie [mm].")
      .def("counts", &counts_dict, "Number of dimples of each state, by name. Raises nothing.");
  m.def(
      "state_names",
      [] {
        std::vector<std::string> names;
        for (int s = 0; s < patch::kDimpleStates; ++s)
          names.emplace_back(patch::name(static_cast<patch::DimpleState>(s)));
        return names;
      },
      "The DimpleStates as phrases, in their order. Raises nothing.");
}

void bind_division(py::module_& m) {
  py::class_<patch::PatchPattern>(m, "PatchPattern",
                                  "Shape, spacing [mm], size and helix of patches.")
      .def(py::init(&pattern_of), py::arg("shape"), py::arg("spacing"), py::arg("size"),
           py::arg("order") = "Inward", py::arg("start") = "Same corner", py::arg("across") = 0,
           "`across` [dimples] is the other side of shapes that have two; 0: as `size`. Raises "
           "InputError naming PatchShape, Spacing, PatchSide, HelixOrder or HelixStart.")
      .def_readonly("spacing", &patch::PatchPattern::spacing)
      .def_property_readonly("size", [](const patch::PatchPattern& p) { return p.size.side; })
      .def_property_readonly("across", [](const patch::PatchPattern& p) { return p.size.across; })
      .def_property_readonly(
          "cell_area",
          [](const patch::PatchPattern& p) {
            return patch::cell_area(patch::lattice_of(p.shape)) * p.spacing * p.spacing;
          },
          "Area of the plane that one lattice point stands for [mm²].");
  py::class_<patch::PatchSurface>(m, "PatchSurface", "Planar, pyramid or curved patches.")
      .def(py::init(&surface_of), py::arg("kind"), py::arg("fit") = "Best fit",
           py::arg("height_factor") = 1.0, py::arg("apex_lift") = 0.0,
           "`kind`: Planar, Pyramid or Curved; `fit`: Best fit or Corners; `apex_lift` [mm]. "
           "Raises InputError naming SurfaceKind or PlaneFit. ProjectedSurface.place refuses its "
           "HeightFactor or ApexLift.")
      .def_property_readonly(
          "planar",
          [](const patch::PatchSurface& s) { return s.kind != patch::SurfaceKind::Curved; },
          "Whether patches are made of planes.")
      .def(
          "__eq__",
          [](const patch::PatchSurface& a, const patch::PatchSurface& b) {
            return a.kind == b.kind && a.fit == b.fit && a.height_factor == b.height_factor &&
                   a.apex_lift == b.apex_lift;
          },
          "Whether kind, fit, factor and lift are the same. Raises nothing.");
  py::class_<patch::PatchDivision>(m, "PatchDivision", "Patches in milling order.")
      .def(
          "__len__", [](const patch::PatchDivision& d) { return d.cells.size(); },
          "How many patches there are. Raises nothing.")
      .def_readonly("pattern", &patch::PatchDivision::pattern)
      .def("outlines", &outline_list,
           "Corners of each patch in the texture plane [mm], (k, 2). Raises nothing.")
      .def_readonly("anchor", &patch::PatchDivision::anchor, "Place of lattice point (0, 0) [mm].")
      .def("lattice_outlines", &lattice_outline_list,
           "Corners of each patch in lattice coordinates, (k, 2). Raises nothing.")
      .def("places", &places_of, py::arg("dimples"),
           "Texture-plane coordinates [mm] of each lattice point, (n, 2). Raises nothing.");
  m.def(
      "cover",
      [](const patch::PatchPattern& pattern, const Vec2& low, const Vec2& high) {
        return patch::cover(pattern, patch::Box2(low, high));
      },
      py::arg("pattern"), py::arg("low"), py::arg("high"),
      "The patches that overlap the rectangle from `low` to `high` [mm]. Raises InputError naming "
      "Area or Spacing.");
  m.def(
      "patch_block",
      [](const patch::PatchPattern& pattern, int nx, int ny) {
        return patch::patch_block(pattern, nx, ny);
      },
      py::arg("pattern"), py::arg("patches_x"), py::arg("patches_y"),
      "A block of patches centred on the texture plane's origin. Raises InputError naming PatchesX "
      "or PatchesY.");
  m.def("drop_slivers", &patch::drop_slivers, py::arg("dimples"), py::arg("least"),
        "Leaves out the dimples of patches that have fewer than `least`. Raises InputError naming "
        "MinimumDimples.");
}

}  // namespace

patch::PatchShape shape_of(const std::string& name) {
  std::vector<std::pair<const char*, patch::PatchShape>> choices;
  for (const patch::PatchShape shape : patch::all_patch_shapes())
    choices.emplace_back(patch::traits(shape).name, shape);
  return choose<patch::PatchShape>("PatchShape", name, choices);
}

namespace {

void bind_shapes(py::module_& m) {
  m.def(
      "patch_shapes",
      [] {
        std::vector<std::string> names;
        for (const patch::PatchShape shape : patch::all_patch_shapes())
          names.emplace_back(patch::traits(shape).name);
        return names;
      },
      "The names of all patch shapes, in the order in which they are offered. Raises nothing.");
  m.def(
      "row_pitch", [](const std::string& shape) { return patch::row_pitch(shape_of(shape)); },
      py::arg("shape"),
      "Distance of neighbouring rows of dimples over the spacing. Raises InputError naming "
      "PatchShape.");
  m.def(
      "two_sided",
      [](const std::string& shape) { return patch::traits(shape_of(shape)).two_sided; },
      py::arg("shape"),
      "Whether patches have a side across that may differ from the other. Raises InputError naming "
      "PatchShape.");
  m.def(
      "least_patch_side",
      [](const std::string& shape) { return patch::traits(shape_of(shape)).least.side; },
      py::arg("shape"),
      "The smallest side that a patch may have. Raises InputError naming PatchShape.");
}

}  // namespace

void bind_patch(py::module_& m) {
  py::class_<patch::TexturePlane>(m, "TexturePlane", "Origin, axes and projection direction.")
      .def_readonly("origin", &patch::TexturePlane::origin)
      .def_readonly("x_axis", &patch::TexturePlane::x_axis)
      .def_readonly("y_axis", &patch::TexturePlane::y_axis)
      .def_readonly("direction", &patch::TexturePlane::direction);
  m.def("texture_plane", &patch::texture_plane, py::arg("origin"), py::arg("direction"),
        py::arg("x_hint"), py::arg("rotation") = 0.0,
        "A plane at right angles to `direction`, turned by `rotation` [rad]. Raises InputError "
        "naming Origin, Direction or Rotation.");
  bind_shapes(m);
  bind_division(m);
  bind_dimples(m);
}

}  // namespace patchmill

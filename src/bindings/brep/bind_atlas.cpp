// Lattices laid on faces by their own parameters, and distances of dimples, for Python.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "brep/atlas_faces.h"
#include "brep/face_sampler.h"
#include "brep/read_shape.h"
#include "patchmill/geometry/require.h"
#include "patchmill/patch/atlas/laid_lattice.h"

namespace patchmill {
namespace {

// What Python holds: the lattice, looked along a direction, and what it says of itself.
struct LaidOnFaces {
  std::shared_ptr<const patch::LaidLattice> laid;
  patch::SurfaceLattice lattice;
};

std::vector<TopoDS_Face> all_faces(const std::vector<std::string>& breps) {
  std::vector<TopoDS_Face> faces;
  for (const std::string& brep : breps)
    for (const TopoDS_Face& face : read_faces(brep)) faces.push_back(face);
  return faces;
}

std::optional<LaidOnFaces> lay_on_faces(const patch::PatchPattern& pattern,
                                        const std::vector<std::string>& breps,
                                        const patch::TexturePlane& plane,
                                        const FaceSampler& sampler, double steepest,
                                        double rotation, const std::optional<Vec3>& start,
                                        const Progress& report) {
  require_in_range("SteepestSlope", Angle::radians(steepest).degrees(), 0.01, 90.0, "degrees");
  require_in_range("Rotation", Angle::radians(rotation).degrees(), -1e6, 1e6, "degrees");
  if (start) require_finite("Origin", *start, "mm");
  const std::vector<TopoDS_Face> faces = all_faces(breps);
  patch::AtlasStart begin;
  begin.rotation = Angle::radians(rotation);
  if (start) {
    begin.at = find_on_faces(faces, *start);
    if (!begin.at)
      throw InputError("Origin", "off the faces",
                       "a texture on the surface begins there: move it on one of the faces.");
  }
  std::optional<patch::Atlas> atlas =
      patch::make_atlas(atlas_faces(faces), pattern.spacing, begin, report);
  if (!atlas) return std::nullopt;
  const auto laid = std::make_shared<patch::LaidLattice>(std::move(*atlas), pattern, !start);
  laid->look_along(
      plane, [&](const std::vector<Vec2>& p) { return sampler.sample(p); },
      Angle::radians(steepest));
  return LaidOnFaces{laid, patch::as_surface_lattice(laid, plane)};
}

std::optional<LaidOnFaces> watched_lay_on_faces(const patch::PatchPattern& pattern,
                                                const std::vector<std::string>& breps,
                                                const patch::TexturePlane& plane,
                                                const FaceSampler& sampler, double steepest,
                                                double rotation, const std::optional<Vec3>& start,
                                                const py::object& progress) {
  std::optional<LaidOnFaces> laid;
  const bool done = watched(progress, [&](const Progress& report) {
    laid = lay_on_faces(pattern, breps, plane, sampler, steepest, rotation, start, report);
  });
  return done ? std::move(laid) : std::nullopt;
}

}  // namespace

void bind_atlas(py::module_& m) {
  py::class_<LaidOnFaces>(m, "LaidOnFaces", "A lattice laid on faces by their own parameters.")
      .def_property_readonly(
          "lattice", [](const LaidOnFaces& l) { return l.lattice; }, "The SurfaceLattice.")
      .def("cover", interruptible([](const LaidOnFaces& l) { return l.laid->cover(); }),
           "The patches that have lattice points. Raises nothing.")
      .def_property_readonly(
          "area", [](const LaidOnFaces& l) { return l.laid->atlas().area; },
          "Of the faces, inside their trimming [mm²].")
      .def_property_readonly(
          "pieces", [](const LaidOnFaces& l) { return l.laid->atlas().charts.size(); },
          "Parts of the faces that were rolled out, each for itself.")
      .def_property_readonly(
          "rounds",
          [](const LaidOnFaces& l) {
            std::vector<std::pair<int, double>> rounds;
            for (const patch::PlacedChart& c : l.laid->atlas().charts)
              if (c.chart.round_count() > 0)
                rounds.emplace_back(c.chart.round_count(), c.chart.round_spacing());
            return rounds;
          },
          "Of each closed face that comes back to itself: dimples round it, and their distance "
          "[mm].")
      .def_property_readonly(
          "crowded", [](const LaidOnFaces& l) { return l.laid->crowded(); },
          "Lattice points too near to others where parts meet.");
  m.def("lay_on_faces", &watched_lay_on_faces, py::arg("pattern"), py::arg("breps"),
        py::arg("plane"), py::arg("sampler"), py::arg("steepest"), py::arg("rotation") = 0.0,
        py::arg("start") = py::none(), py::arg("progress") = py::none(),
        "The pattern's lattice on the faces, turned by `rotation` [rad] against their own lines, "
        "from "
        "the point `start` [mm] or the middle of the largest part. None if `progress` returned "
        "False. Raises InputError naming Origin, Base, Spacing, SteepestSlope or Rotation.");
  m.def("keep_apart", interruptible(&patch::keep_apart), py::arg("dimples"), py::arg("least"),
        "Leaves out dimples nearer than `least` [mm] to one before them; returns how many. Raises "
        "InputError naming LeastDistance.");
  m.def(
      "nearest_distances",
      [](const patch::Dimples& dimples) {
        const std::vector<double> found = patch::nearest_distances(dimples);
        return column_of<double>(found, [](double d) { return d; });
      },
      py::arg("dimples"),
      "Distance of each cut dimple to the nearest other one, in space [mm]. Raises nothing.");
}

}  // namespace patchmill

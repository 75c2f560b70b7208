// Face sampling for Python. Shapes come as BREP text.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "brep/edges.h"
#include "brep/face_sampler.h"
#include "brep/facing.h"
#include "brep/read_shape.h"
#include "patchmill/patch/patch_surface.h"
#include "patchmill/patch/surface_lattice.h"

namespace patchmill {
namespace {

std::vector<TopoDS_Face> faces_of(const std::vector<std::string>& breps) {
  std::vector<TopoDS_Face> faces;
  for (const std::string& brep : breps)
    for (const TopoDS_Face& face : read_faces(brep)) faces.push_back(face);
  return faces;
}

FaceSampler sampler_of(const std::vector<std::string>& breps, const patch::TexturePlane& plane,
                       double steepest) {
  return FaceSampler(faces_of(breps), plane, Angle::radians(steepest));
}

py::object place_dimples(const FaceSampler& sampler, const patch::PatchDivision& division,
                         const patch::TexturePlane& plane, const patch::PatchSurface& surface,
                         const patch::SurfaceLattice* lattice, const py::object& progress) {
  std::optional<patch::Dimples> dimples;
  const bool done = watched(progress, [&](const Progress& report) {
    const patch::SurfaceSampler sample = [&](const std::vector<Vec2>& places) {
      return sampler.sample(places);
    };
    dimples = lattice ? patch::sample_patches(division, plane, *lattice, sample, surface, report)
                      : patch::sample_patches(division, plane, sample, surface, report);
  });
  return done && dimples ? py::cast(std::move(*dimples)) : py::none();
}

void keep_off_borders(patch::Dimples& dimples, const std::vector<std::string>& breps,
                      double margin) {
  if (margin == 0.0) return;
  if (breps.empty()) throw InputError("Base", "no faces", "give those whose border is meant.");
  patch::keep_off_edges(dimples, border_segments(faces_of(breps), 0.01), margin);
}

py::dict hits_dict(const FaceSampler& sampler, const Eigen::Matrix<double, -1, 2>& points) {
  std::vector<Vec2> places;
  for (Eigen::Index i = 0; i < points.rows(); ++i) places.emplace_back(points.row(i));
  std::vector<patch::SurfaceSample> hits;
  watched(py::none(), [&](const Progress&) { hits = sampler.sample(places); });
  py::dict d;
  d["positions"] = rows_of(hits, [](const patch::SurfaceSample& h) { return h.point.position; });
  d["normals"] = rows_of(hits, [](const patch::SurfaceSample& h) { return h.point.normal; });
  d["states"] = column_of<std::uint8_t>(
      hits, [](const patch::SurfaceSample& h) { return static_cast<std::uint8_t>(h.state); });
  return d;
}

}  // namespace

void bind_brep(py::module_& m) {
  py::class_<FaceSampler>(
      m, "FaceSampler", "Projects points of a texture plane on trimmed faces along its direction.")
      .def(py::init(&sampler_of), py::arg("breps"), py::arg("plane"), py::arg("steepest"),
           "Faces as BREP texts; `steepest` [rad]: greatest angle of normal and -direction. Raises "
           "InputError naming Base or SteepestSlope.")
      .def(
          "extent",
          [](const FaceSampler& s) {
            const auto [low, high] = s.extent();
            return py::make_tuple(low, high);
          },
          "((x, y) least, (x, y) greatest) that the faces cover in the texture plane [mm]. Raises "
          "nothing.")
      .def("sample", &hits_dict, py::arg("points"),
           "Projects (n, 2) points; a dict of arrays positions, normals, states (a DimpleState "
           "each: CUT, OFF_FACE, TOO_STEEP or UNDERCUT). Raises nothing.")
      .def("place", &place_dimples, py::arg("division"), py::arg("plane"), py::arg("surface"),
           py::arg("lattice") = py::none(), py::arg("progress") = py::none(),
           "Dimples of the division on the faces, projected or on a lattice laid on them, or None "
           "if `progress` returned False. Raises InputError naming HeightFactor or ApexLift.");
  m.def("facing", interruptible([](const std::vector<std::string>& breps) {
          return facing(faces_of(breps));
        }),
        py::arg("breps"),
        "Unit vector to the side from which the faces look largest. Raises InputError naming "
        "AutoDirection or Base.");
  m.def(
      "seen_best",
      [](const std::vector<std::string>& breps, const Vec3& preferred) {
        if (breps.empty()) throw InputError("Base", "no faces", "give those to be seen.");
        SeenBest found;
        watched(py::none(),
                [&](const Progress&) { found = seen_best(faces_of(breps), preferred); });
        py::dict d;
        d["direction"] = found.direction;
        d["even"] = found.even;
        return d;
      },
      py::arg("breps"), py::arg("preferred"),
      "The direction along which the faces look largest, and whether they look to all sides alike, "
      "so that `preferred` or an axis was chosen: a dict of direction and even. Raises InputError "
      "naming Base or Direction.");
  m.def("keep_off_borders", interruptible(&keep_off_borders), py::arg("dimples"), py::arg("breps"),
        py::arg("margin"),
        "Leaves out dimples nearer than `margin` [mm] to the border of the faces together. Raises "
        "InputError naming Base or Margin.");
}

}  // namespace patchmill

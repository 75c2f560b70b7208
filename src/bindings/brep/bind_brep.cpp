// Face sampling for Python. Shapes come as BREP text.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "brep/edges.h"
#include "brep/face_sampler.h"
#include "brep/facing.h"
#include "brep/read_shape.h"
#include "patchmill/patch/boundary.h"

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

void keep_off_borders(patch::Dimples& dimples, const std::vector<std::string>& breps,
                      double margin) {
  if (margin == 0.0) return;
  if (breps.empty()) throw InputError("Base", "no faces", "give those whose border is meant.");
  patch::keep_off_edges(dimples, border_segments(faces_of(breps), 0.01), margin);
}

}  // namespace

void bind_brep(py::module_& m) {
  py::class_<FaceSampler, patch::ProjectedSurface>(
      m, "FaceSampler", "Projects points of a texture plane on trimmed faces along its direction.")
      .def(py::init(&sampler_of), py::arg("breps"), py::arg("plane"), py::arg("steepest"),
           "Faces as BREP texts; `steepest` [rad]: greatest angle of normal and -direction. Raises "
           "InputError naming Base or SteepestSlope.");
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
        patch::SeenBest found;
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

// Face sampling for Python. Shapes come as BREP text.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "brep/face_sampler.h"
#include "brep/read_shape.h"
#include "core/patch/division.h"

namespace patchmill {
namespace {

FaceSampler sampler_of(const std::vector<std::string>& breps, const TexturePlane& plane,
                       double steepest) {
  std::vector<TopoDS_Face> faces;
  for (const std::string& brep : breps)
    for (const TopoDS_Face& face : read_faces(brep)) faces.push_back(face);
  return FaceSampler(faces, plane, Angle::radians(steepest));
}

py::object place_dimples(const FaceSampler& sampler, const SquareDivision& division,
                         const py::object& progress) {
  const Progress report = progress_of(progress);
  Dimples dimples;
  bool done = false;
  {
    const py::gil_scoped_release release;
    dimples = lattice_points(division);
    std::vector<Vec2> places;
    places.reserve(dimples.size());
    for (const Dimple& dimple : dimples) places.push_back(place(division, dimple.lattice));
    done = sampler.sample(places, dimples, report);
  }
  return done ? py::cast(std::move(dimples)) : py::none();
}

py::dict hits_dict(const FaceSampler& sampler, const Eigen::Matrix<double, -1, 2>& points) {
  std::vector<Vec2> places;
  for (Eigen::Index i = 0; i < points.rows(); ++i) places.emplace_back(points.row(i));
  std::vector<SurfaceHit> hits;
  {
    const py::gil_scoped_release release;
    hits = sampler.sample(places);
  }
  py::dict d;
  d["positions"] = rows_of(hits, [](const SurfaceHit& h) { return h.point.position; });
  d["normals"] = rows_of(hits, [](const SurfaceHit& h) { return h.point.normal; });
  d["faces"] = column_of<int>(hits, [](const SurfaceHit& h) { return h.face; });
  d["states"] = column_of<std::uint8_t>(
      hits, [](const SurfaceHit& h) { return static_cast<std::uint8_t>(h.state); });
  return d;
}

}  // namespace

void bind_brep(py::module_& m) {
  py::class_<FaceSampler>(
      m, "FaceSampler", "Projects points of a texture plane on trimmed faces along its direction.")
      .def(py::init(&sampler_of), py::arg("breps"), py::arg("plane"), py::arg("steepest"),
           "Faces as BREP texts; `steepest` [rad]: greatest angle of normal and -direction.")
      .def(
          "extent",
          [](const FaceSampler& s) {
            const auto [low, high] = s.extent();
            return py::make_tuple(low, high);
          },
          "((x, y) least, (x, y) greatest) that the faces cover in the texture plane [mm].")
      .def("sample", &hits_dict, py::arg("points"),
           "Projects (n, 2) points; a dict of arrays positions, normals, faces (-1: none), states.")
      .def("place", &place_dimples, py::arg("division"), py::arg("progress") = py::none(),
           "Dimples of the division on the faces, or None if `progress` returned False.");
}

}  // namespace patchmill

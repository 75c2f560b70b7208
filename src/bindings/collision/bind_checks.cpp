// Gouge and collision checks for Python: the part as closed meshes, the tool with all that is above its end.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "brep/read_shape.h"
#include "brep/tessellate.h"
#include "patchmill/collision/clearance.h"
#include "patchmill/collision/mesh_distance.h"
#include "patchmill/geometry/error.h"

#include <algorithm>

#include <TopExp_Explorer.hxx>
#include <fmt/format.h>

namespace patchmill {
namespace {

/// The solids of the job's models. Not known if one of them could not be meshed.
struct PartModel {
  collision::PartShape shape;
  bool known = false;
  std::string reason;
  std::int64_t triangles = 0;
};

PartModel part_model(const std::vector<std::string>& breps, double deflection) {
  PartModel part;
  std::vector<collision::PartShape> solids;
  const auto add = [&](const TopoDS_Shape& shape) {
    const Tessellation made = tessellate(shape, {deflection, Angle::degrees(20)});
    part.triangles += static_cast<std::int64_t>(made.mesh.triangles.size());
    if (made.closed)
      solids.push_back(collision::shape_from_mesh(made.mesh));
    else if (part.reason.empty())
      part.reason = made.reason;
  };
  for (const std::string& brep : breps) {
    const TopoDS_Shape shape = read_shape(brep, "Model");
    TopExp_Explorer solid(shape, TopAbs_SOLID);
    if (!solid.More()) add(shape);
    for (; solid.More(); solid.Next()) add(solid.Current());
  }
  if (solids.empty() && part.reason.empty()) part.reason = "There is no part.";
  part.known = part.reason.empty();
  if (part.known) part.shape = collision::join(std::move(solids));
  return part;
}

PartModel part_model_of_mesh(const mesh::TriangleMesh& given) {
  PartModel part;
  const mesh::TriangleMesh mesh = mesh::weld(given);
  part.triangles = static_cast<std::int64_t>(mesh.triangles.size());
  try {
    mesh::require_closed(mesh, "Mesh");
    part.shape = collision::shape_from_mesh(mesh);
    part.known = true;
  } catch (const InputError& e) {
    part.reason = fmt::format("The mesh is no closed solid ({}).", e.value());
  }
  return part;
}

const char* name(collision::ClearanceOutcome outcome) {
  switch (outcome) {
    case collision::ClearanceOutcome::Clear:
      return "clear";
    case collision::ClearanceOutcome::Violated:
      return "violated";
    default:
      return "unknown";
  }
}

py::dict check(const ToolPath& path, const PartModel& part, double tolerance, double clearance,
               double resolution, std::size_t most_findings, std::size_t first_move, bool cutting,
               const py::object& progress) {
  collision::ClearanceReport report;
  const bool done = watched(progress, [&](const Progress& say) {
    report = collision::check_clearance(
        path, part.shape, {tolerance, clearance, resolution, most_findings, first_move, cutting},
        say);
  });
  if (!done) {
    report = {};
    report.reason = "The check was stopped before its end.";
  }
  if (!part.known) report.reason = part.reason;
  const auto& f = report.findings;
  py::dict d;
  d["outcome"] = name(report.outcome);
  d["reason"] = report.reason;
  d["unknown_moves"] = report.unknown_moves;
  std::vector<std::string> parts;
  for (const collision::ClearanceFinding& finding : f) parts.emplace_back(name(finding.part));
  d["parts"] = parts;
  d["moves"] =
      column_of<std::int64_t>(f, [](const collision::ClearanceFinding& v) { return v.move; });
  d["places"] = rows_of(f, [](const collision::ClearanceFinding& v) { return v.place; });
  d["depths"] = column_of<double>(f, [](const collision::ClearanceFinding& v) { return v.depth; });
  return d;
}

}  // namespace

void bind_checks(py::module_& m) {
  py::class_<Tessellation>(m, "Tessellation", "A shape as triangles.")
      .def_readonly("closed", &Tessellation::closed)
      .def_readonly("reason", &Tessellation::reason, "Why it is no closed solid.")
      .def_property_readonly(
          "vertices",
          [](const Tessellation& t) {
            return rows_of(t.mesh.vertices, [](const Vec3& v) { return v; });
          },
          "[mm], (n, 3).")
      .def_property_readonly(
          "triangles",
          [](const Tessellation& t) {
            py::array_t<std::int32_t> array({t.mesh.triangles.size(), std::size_t{3}});
            auto out = array.mutable_unchecked<2>();
            for (std::size_t i = 0; i < t.mesh.triangles.size(); ++i)
              for (std::size_t k = 0; k < 3; ++k)
                out(py::ssize_t(i), py::ssize_t(k)) = t.mesh.triangles[i][k];
            return array;
          },
          "Indices into vertices, (m, 3).");
  m.def("tessellate", interruptible([](const std::string& brep, double deflection, double angle) {
          return tessellate(read_shape(brep, "Shape"), {deflection, Angle::radians(angle)});
        }),
        py::arg("brep"), py::arg("deflection"), py::arg("angle") = 0.35,
        "A shape, given as BREP text, as one mesh; `deflection` [mm], `angle` [rad]. Raises "
        "InputError naming Shape, Deflection or DeflectionAngle.");
  py::class_<PartModel>(m, "PartModel",
                        "The part as closed meshes; known is False if it could not be.")
      .def_readonly("known", &PartModel::known)
      .def_readonly("reason", &PartModel::reason)
      .def_readonly("triangles", &PartModel::triangles)
      .def(
          "distances",
          interruptible([](const PartModel& part, const Eigen::Matrix<double, -1, 3>& points) {
            if (!part.known) throw InputError("Part", "unknown", part.reason);
            Eigen::VectorXd out(points.rows());
            for (Eigen::Index i = 0; i < points.rows(); ++i)
              out[i] = part.shape.distance(points.row(i));
            return out;
          }),
          py::arg("points"),
          "Signed distances [mm] of (n, 3) points, positive outside. Raises InputError naming Part "
          "if the model is not known.");
  m.def("part_model", interruptible(&part_model), py::arg("breps"), py::arg("deflection"),
        "Meshes the solids of shapes given as BREP texts. Raises InputError naming Model or "
        "Deflection.");
  m.def("part_model_of_mesh", interruptible(&part_model_of_mesh), py::arg("mesh"),
        "The part as a TriangleMesh; not known if that is not closed. Raises nothing.");
  m.def("check_clearance", &check, py::arg("path"), py::arg("part"), py::arg("tolerance"),
        py::arg("clearance"), py::arg("resolution"), py::arg("most_findings") = 1000,
        py::arg("first_move") = 0, py::arg("cutting") = true, py::arg("progress") = py::none(),
        "Gouges and collisions of a path with its tool: outcome 'clear', 'violated' or 'unknown', "
        "and arrays. `cutting`: whether its end and flutes are looked at, too. Raises InputError "
        "naming Tolerance, Clearance or Resolution.");
}

}  // namespace patchmill

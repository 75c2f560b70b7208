// Voxel model, fields and their sections for Python.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "bindings/solid.h"
#include "bindings/voxel/voxel_materials.h"
#include "patchmill/dcm/field_reader.h"
#include "patchmill/dcm/field_view.h"
#include "patchmill/dcm/voxel_file.h"
#include "patchmill/geometry/require.h"
#include "patchmill/voxel/foreseen_memory.h"
#include "patchmill/voxel/transient.h"
#include "patchmill/voxel/voxelise.h"

namespace patchmill {
namespace {
const char* const kKindNames[voxel::kVoxelKinds] = {"air", "part", "removal", "surface",
                                                    "exterior"};

dcm::ExteriorRule exterior_rule(const std::string& name) {
  if (name == "Held") return dcm::ExteriorRule::Held;
  if (name == "Free") return dcm::ExteriorRule::Free;
  throw InputError("Exterior", "'" + name + "'", "give Held or Free.");
}

dcm::PostureOptions posture_options(const std::string& form, const std::string& exterior,
                                    double limit, double crease) {
  dcm::PostureOptions options;
  if (form != "Angles" && form != "Unit vector")
    throw InputError("PostureForm", "'" + form + "'", "give Angles or Unit vector.");
  options.form = form == "Angles" ? dcm::PostureForm::Angles : dcm::PostureForm::UnitVector;
  options.exterior = exterior_rule(exterior);
  options.limit = Angle::radians(limit);
  options.crease = Angle::radians(crease);
  return options;
}

py::dict counts(const voxel::VoxelGrid& grid) {
  const auto count = voxel::count_kinds(grid);
  py::dict d;
  for (int k = 0; k < voxel::kVoxelKinds; ++k)
    d[kKindNames[k]] = count[static_cast<std::size_t>(k)];
  return d;
}

// Components of a posture that is stored for each voxel; 0 if there is none.
int fields_of(int posture_fields) {
  if (posture_fields != 0 && posture_fields != 2 && posture_fields != 3)
    throw InputError("posture_fields", std::to_string(posture_fields),
                     "give 0, for no posture, 2, for angles, or 3, for a vector's components.");
  return posture_fields;
}

py::dict estimate_dict(const voxel::MemoryEstimate& need) {
  py::dict d;
  d["grid"] = need.grid;
  d["fields"] = need.fields;
  d["solver"] = need.solver;
  d["total"] = need.total();
  return d;
}

template <class T>
py::array_t<T> image(const dcm::GridSection& s, const std::vector<T>& values) {
  py::array_t<T> array({py::ssize_t{s.rows}, py::ssize_t{s.columns}});
  std::copy(values.begin(), values.end(), array.mutable_data());
  return array;
}

py::dict section_dict(const voxel::VoxelGrid& grid, int axis, double place,
                      const dcm::FeedField* feed, const Vec3& direction,
                      const dcm::PostureField* posture) {
  if (feed) dcm::require_over(grid, *feed);
  if (posture) dcm::require_over(grid, *posture);
  const Vec3 along = unit_along("Direction", direction);
  const dcm::GridSection s = dcm::section_of(grid, axis, place);
  py::dict d;
  std::vector<std::uint8_t> kinds;
  for (const voxel::VoxelKind kind : s.kind) kinds.push_back(static_cast<std::uint8_t>(kind));
  d["kind"] = image(s, kinds);
  d["origin"] = s.origin;
  d["pitch"] = s.pitch;
  d["place"] = s.place;
  if (feed) d["feed"] = image(s, dcm::feed_on(s, *feed, along));
  if (posture)
    d["axis"] = rows_of(dcm::axes_on(s, *posture), [](const Vec3& v) {
                  return v;
                }).reshape(std::vector<py::ssize_t>{s.rows, s.columns, 3});
  return d;
}

py::tuple arrows_tuple(const voxel::VoxelGrid& grid, const dcm::PostureField& posture, int stride) {
  dcm::require_over(grid, posture);
  const auto arrows = dcm::arrows_of(grid, posture, stride);
  return py::make_tuple(rows_of(arrows, [](const dcm::FieldArrow& a) { return a.place; }),
                        rows_of(arrows, [](const dcm::FieldArrow& a) { return a.axis; }));
}

// The paper's explicit steps of the feed along x, y and z to a time.
std::pair<dcm::FeedField, int> transient_feed(const voxel::VoxelGrid& grid,
                                              const dcm::FeedLimits& limits,
                                              const std::string& exterior,
                                              const voxel::TransientOptions& options) {
  const auto role = dcm::roles(grid, exterior_rule(exterior));
  dcm::FeedField field;
  field.limits = limits;
  int steps = 0;
  for (int k = 0; k < 3; ++k) {
    field.along[k] = dcm::initial_feed(grid, limits);
    steps = voxel::diffuse_transient(grid.table, role, static_cast<voxel::DiffusionAxes>(k),
                                     grid.frame.pitch, options, field.along[k]);
  }
  return {std::move(field), steps};
}

void bind_grid(py::module_& m) {
  py::class_<voxel::VoxelGrid>(m, "VoxelGrid", "The removal volume: stock less part, in cubes.")
      .def_property_readonly("pitch", [](const voxel::VoxelGrid& g) { return g.frame.pitch; })
      .def_property_readonly("origin", [](const voxel::VoxelGrid& g) { return g.frame.origin; })
      .def_property_readonly("cells", [](const voxel::VoxelGrid& g) { return g.frame.cells; })
      .def_property_readonly("counts", &counts, "Stored voxels by kind.")
      .def_property_readonly(
          "memory",
          [](const voxel::VoxelGrid& g) { return estimate_dict(voxel::memory_of(g.table)); },
          "Bytes of the model, its fields and the solver.")
      .def("section", &section_dict, py::arg("axis"), py::arg("place"), py::arg("feed") = nullptr,
           py::arg("direction") = Vec3(Vec3::UnitX()), py::arg("posture") = nullptr,
           "One layer at right angles to axis 0, 1 or 2: kind (rows, columns), a VoxelKind each, "
           "origin, pitch, and feed [mm/s] and unit axis (rows, columns, 3) of the fields given; "
           "NaN elsewhere. Raises InputError naming axis, place, FeedField, Direction or "
           "PostureField. `place` [mm].")
      .def("arrows", &arrows_tuple, py::arg("posture"), py::arg("stride") = 2,
           "(places, unit axes), both (n, 3), of every stride-th voxel to be removed. Raises "
           "InputError naming PostureField or stride.");
  m.def(
      "estimate_voxels",
      [](const Solid& stock, const Solid& part, double pitch, int posture_fields, bool materials) {
        const voxel::GridFrame frame = voxel::frame_over(mesh::bounds(stock.mesh), pitch);
        voxel::MemoryEstimate need;
        watched(py::none(), [&](const Progress&) {
          need = voxel::foreseen_memory(stock.mesh, part.mesh, frame, fields_of(posture_fields),
                                        materials);
        });
        return estimate_dict(need);
      },
      py::arg("stock"), py::arg("part"), py::arg("pitch"), py::arg("posture_fields") = 2,
      py::arg("materials") = false,
      "Bytes foreseen, hardly any allocated. `posture_fields`: 2 angles, 3 components or 0; "
      "`materials`: "
      "whether there are other than the stock's own. Raises InputError naming voxel size or "
      "posture_fields.");
  m.def("voxelise",
        interruptible([](const Solid& stock, const Solid& part, double pitch, double limit,
                         int posture_fields, bool materials) {
          return voxel::voxelise(stock.mesh, part.mesh,
                                 {pitch, limit, fields_of(posture_fields), materials});
        }),
        py::arg("stock"), py::arg("part"), py::arg("pitch"),
        py::arg("memory_limit") = voxel::VoxelOptions().memory_limit, py::arg("posture_fields") = 2,
        py::arg("materials") = false,
        "VoxelGrid with cubes of side `pitch` [mm]. Raises InputError naming part, voxel size, "
        "posture_fields or removal volume.");
  m.def("save_voxels",
        interruptible([](const std::string& path, const std::string& key,
                         const voxel::VoxelGrid& grid, const dcm::PostureField* posture,
                         const VoxelMaterials* materials) {
          if (posture) dcm::require_over(grid, *posture);
          if (materials) dcm::require_over(grid, materials->number);
          dcm::VoxelModel model{grid, std::nullopt, {}};
          if (posture) model.posture = *posture;
          if (materials) model.material = materials->number;
          dcm::write_voxel_model(path, key, model);
        }),
        py::arg("path"), py::arg("key"), py::arg("grid"), py::arg("posture") = nullptr,
        py::arg("materials") = nullptr,
        "Writes a model to the file `path`; `key` says what it was made from. Raises InputError "
        "naming voxel file, PostureField or Materials.");
  m.def(
      "load_voxels",
      [](const std::string& path, const std::string& key) -> py::object {
        std::optional<dcm::VoxelModel> model;
        watched(py::none(), [&](const Progress&) { model = dcm::read_voxel_model(path, key); });
        if (!model) return py::none();
        const py::object posture =
            model->posture ? py::cast(std::move(*model->posture)) : py::none();
        const py::object materials = model->material.empty()
                                         ? py::object(py::none())
                                         : py::cast(VoxelMaterials{std::move(model->material)});
        return py::make_tuple(std::move(model->grid), posture, materials);
      },
      py::arg("path"), py::arg("key"),
      "(grid, posture or None, materials or None), or None if made of other input. Raises "
      "nothing.");
}

}  // namespace

void bind_dcm(py::module_& m) {
  py::class_<dcm::FeedField>(m, "FeedField", "V_x, V_y, V_z over a VoxelGrid [mm/s].")
      .def_property_readonly("low", [](const dcm::FeedField& f) { return f.limits.low; })
      .def_property_readonly("high", [](const dcm::FeedField& f) { return f.limits.high; });
  py::class_<dcm::PostureField>(m, "PostureField", "Tool axis over a VoxelGrid.")
      .def_property_readonly("converged",
                             [](const dcm::PostureField& p) { return p.outcome.converged; })
      .def_property_readonly("cancelled",
                             [](const dcm::PostureField& p) { return p.outcome.cancelled; })
      .def_property_readonly("iterations",
                             [](const dcm::PostureField& p) { return p.outcome.iterations; })
      .def_property_readonly(
          "history", [](const dcm::PostureField& p) { return p.outcome.history; },
          "Relative residual before the first iteration and after each.")
      .def_property_readonly("residual",
                             [](const dcm::PostureField& p) { return p.outcome.true_residual; });
  bind_grid(m);
  m.def(
      "steady_feed",
      interruptible(
          [](const voxel::VoxelGrid& grid, double low, double high, const std::string& exterior) {
            return dcm::steady_feed(grid, {low, high}, exterior_rule(exterior));
          }),
      py::arg("grid"), py::arg("low"), py::arg("high"), py::arg("exterior") = "Held",
      "FeedField between V_Lo and V_Hi [mm/s]. Raises InputError naming lower feed, upper feed or "
      "Exterior.");
  m.def(
      "diffuse_feed",
      interruptible([](const voxel::VoxelGrid& grid, double low, double high, double time,
                       double step, double diffusivity, bool substep, const std::string& exterior) {
        return transient_feed(grid, {low, high}, exterior, {time, step, diffusivity, substep});
      }),
      py::arg("grid"), py::arg("low"), py::arg("high"), py::arg("time"), py::arg("step"),
      py::arg("diffusivity"), py::arg("substep") = false, py::arg("exterior") = "Held",
      "(FeedField after `time` [s], steps taken); steps beyond the limit are refused or divided. "
      "Raises InputError naming lower feed, upper feed, Exterior, diffusion time, time step, "
      "number of time steps or diffusion coefficient.");
  m.def(
      "steady_posture",
      [](const voxel::VoxelGrid& grid, const Solid& part, const std::string& form,
         const std::string& exterior, double limit, double crease, const py::object& progress) {
        const dcm::PostureOptions options = posture_options(form, exterior, limit, crease);
        dcm::PostureField made;
        const bool done = watched(progress, [&](const Progress& report) {
          made = dcm::steady_posture(grid, part.mesh, part.bvh, options, report);
        });
        if (!done) made.outcome.cancelled = true;
        return made;
      },
      py::arg("grid"), py::arg("part"), py::arg("form") = "Angles", py::arg("exterior") = "Held",
      py::arg("limit") = dcm::PostureOptions().limit.radians(),
      py::arg("crease") = dcm::PostureOptions().crease.radians(), py::arg("progress") = py::none(),
      "PostureField; `limit` and `crease` [rad]. Raises InputError naming PostureForm, Exterior, "
      "posture limit or crease.");
}

}  // namespace patchmill

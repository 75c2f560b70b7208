// The cutting load along a path, for Python.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "patchmill/dcm/apply_dcm.h"
#include "patchmill/load/path_load.h"

namespace patchmill {
namespace {

template <class T, class Get>
py::array_t<T> column(const std::vector<load::LoadAt>& steps, Get get) {
  return column_of<T>(steps, get);
}

py::dict along(const ToolPath& path, const voxel::VoxelGrid& grid, double specific, double exponent,
               double normal) {
  std::vector<load::LoadAt> steps;
  watched(py::none(), [&](const Progress&) {
    steps = load::load_along(path, grid, {specific, exponent, normal});
  });
  using Step = load::LoadAt;
  py::dict d;
  d["move"] = column<std::int64_t>(steps, [](const Step& s) { return s.move; });
  d["at"] = column<double>(steps, [](const Step& s) { return s.at; });
  d["length"] = column<double>(steps, [](const Step& s) { return s.length; });
  d["feed"] = column<double>(steps, [](const Step& s) { return s.feed; });
  d["section"] = column<double>(steps, [](const Step& s) { return s.engagement.section; });
  d["removal"] = column<double>(steps, [](const Step& s) { return s.load.removal; });
  d["chip"] = column<double>(steps, [](const Step& s) { return s.load.chip; });
  d["force"] = column<double>(steps, [](const Step& s) { return s.load.force; });
  d["power"] = column<double>(steps, [](const Step& s) { return s.load.power; });
  return d;
}

py::tuple limited(const ToolPath& path, const voxel::VoxelGrid& grid, double specific,
                  double exponent, double normal, double chip, double force, double power,
                  double acceleration) {
  if (!(acceleration > 0.0)) require_positive("acceleration", acceleration, "mm/s2");
  std::vector<std::int64_t> source;
  ToolPath out;
  watched(py::none(), [&](const Progress&) {
    out = load::limit_load(path, grid, {specific, exponent, normal}, {chip, force, power}, &source);
    dcm::limit_acceleration(out, acceleration);
  });
  return py::make_tuple(std::move(out),
                        column_of<std::int64_t>(source, [](std::int64_t v) { return v; }));
}

}  // namespace

void bind_load(py::module_& m) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const load::Resistance steel;
  m.def("load_along", &along, py::arg("path"), py::arg("grid"),
        py::arg("specific") = steel.specific, py::arg("exponent") = steel.exponent,
        py::arg("normal") = steel.normal,
        "The cutting load every quarter of a voxel, arrays of one length: move, at (0 .. 1 on it), "
        "length [mm], feed [mm/s], section [mm^2], removal [mm^3/s], chip (mean thickness) [mm], "
        "force (largest in a turn) [N] and power [W]. `specific`: k_c1.1 [N/mm^2], `exponent`: "
        "m_c, `normal`: force normal to the surface over the cutting force. Raises InputError "
        "naming tool radius, spindle speed, flutes, SpecificForce, ForceExponent or NormalForce.");
  m.def("limit_load", &limited, py::arg("path"), py::arg("grid"),
        py::arg("specific") = steel.specific, py::arg("exponent") = steel.exponent,
        py::arg("normal") = steel.normal, py::arg("chip") = kNone, py::arg("force") = kNone,
        py::arg("power") = kNone, py::arg("acceleration") = kNone,
        "(path whose moves are divided and slowed down to keep the mean chip thickness [mm], the "
        "force [N] and the power [W], and the acceleration [mm/s^2] on the way, number of the "
        "given move of each). Raises InputError naming tool radius, spindle speed, flutes, "
        "SpecificForce, ForceExponent, NormalForce, ChipLimit, ForceLimit, PowerLimit, "
        "acceleration or base operation.");
}

}  // namespace patchmill

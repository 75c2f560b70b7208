// G-code reading and FreeCAD text for Python.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "bindings/path_text.h"
#include "core/machine/freecad_text.h"
#include "core/machine/gcode_reader.h"

namespace patchmill {

void bind_machine(py::module_& m) {
  py::class_<PathText>(m, "PathText", "Lines for Path.Path(), in parts; str() gives the whole.")
      .def("__len__", &PathText::parts)
      .def("__getitem__",
           [](const PathText& text, std::size_t i) {
             if (i >= text.parts()) throw py::index_error();
             return py::str(text.part(i).data(), text.part(i).size());
           })
      .def("__str__", &PathText::whole);
  m.def(
      "freecad_text",
      [](const ToolPath& path, double feed, int decimals) {
        return PathText(freecad_text(path, feed, Decimals(decimals)));
      },
      py::arg("path"), py::arg("feed"), py::arg("decimals"),
      py::call_guard<py::gil_scoped_release>(),
      "A constant-feed path as text for Path.Path(text); `feed` [mm/s].");
  py::class_<ProgramSection>(m, "ProgramSection", "One tool, spindle speed and sense of a program.")
      .def_readonly("tool_number", &ProgramSection::tool_number)
      .def_readonly("path", &ProgramSection::path)
      .def_readonly("unplaced", &ProgramSection::unplaced,
                    "Moves at the beginning that start nobody knows where.")
      .def_readonly("lines", &ProgramSection::lines);
  m.def(
      "read_gcode",
      [](const std::string& text, const BallEndMill& tool) {
        return read_gcode(text, tool).sections;
      },
      py::arg("text"), py::arg("tool"), py::call_guard<py::gil_scoped_release>(),
      "The sections of a three-axis program. Raises InputError for anything not understood.");
  py::class_<PlanMatch>(m, "PlanMatch", "How a path read back compares with its plan.")
      .def_readonly("complete", &PlanMatch::complete)
      .def_readonly("found", &PlanMatch::found)
      .def_readonly("largest_miss", &PlanMatch::largest_miss)
      .def_readonly("extra_moves", &PlanMatch::extra_moves)
      .def_readonly("lost_moves", &PlanMatch::lost_moves);
  m.def("match_plan", &match_plan, py::arg("read"), py::arg("plan"), py::arg("tolerance"),
        "Gives the moves of `read` the kinds and dimple numbers of `plan`, in place.");
}

}  // namespace patchmill

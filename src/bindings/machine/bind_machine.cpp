// G-code reading and writing, and FreeCAD text, for Python.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "bindings/path/path_text.h"
#include "core/machine/freecad_text.h"
#include "core/machine/gcode_reader.h"
#include "core/machine/program_writer.h"

namespace patchmill {
namespace {

std::string program_of(const std::vector<std::string>& texts, const std::string& dialect,
                       int precision, bool line_numbers, bool comments, bool modal, bool axis_modal,
                       bool tool_length, const std::string& name,
                       const std::vector<std::string>& header, const std::string& preamble,
                       const std::string& postamble, const std::string& smoothing_on,
                       const std::string& smoothing_off) {
  ProgramStyle style;
  style.dialect = dialect_of(dialect);
  style.precision = precision;
  style.line_numbers = line_numbers;
  style.comments = comments;
  style.modal = modal;
  style.axis_modal = axis_modal;
  style.tool_length = tool_length;
  style.name = name;
  style.header = header;
  style.preamble = preamble;
  style.postamble = postamble;
  style.smoothing_on = smoothing_on;
  style.smoothing_off = smoothing_off;
  return write_program(texts, style);
}

void bind_text(py::module_& m) {
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
      [](const ToolPath& path, std::optional<double> feed, int decimals, bool exact_stop) {
        const Decimals d(decimals);
        return PathText((exact_stop ? "G61\n" : "") +
                        (feed ? freecad_text(path, *feed, d) : freecad_text(path, d)));
      },
      py::arg("path"), py::arg("feed"), py::arg("decimals"), py::arg("exact_stop") = false,
      py::call_guard<py::gil_scoped_release>(),
      "A constant-feed path as text for Path.Path(text); `feed` [mm/s], or None for a path whose "
      "moves have their own. `exact_stop`: G61 first.");
}

void bind_reader(py::module_& m) {
  py::class_<ProgramSection>(m, "ProgramSection", "One tool, spindle speed and sense of a program.")
      .def_readonly("tool_number", &ProgramSection::tool_number)
      .def_readonly("path", &ProgramSection::path)
      .def_readonly("unplaced", &ProgramSection::unplaced,
                    "Moves at the beginning that start nobody knows where.")
      .def_readonly("lines", &ProgramSection::lines)
      .def_property_readonly(
          "angles",
          [](const ProgramSection& s) {
            return rows_of(s.angles,
                           [](const std::array<double, 3>& a) { return Vec3(a[0], a[1], a[2]); });
          },
          "A, B and C at the start and at the end of each move [rad], (n + 1, 3).")
      .def_property_readonly("tcp", [](const ProgramSection& s) {
        return column_of<bool>(s.tcp, [](bool on) { return on; });
      });
  m.def(
      "read_gcode",
      [](const std::string& text, const BallEndMill& tool, const std::string& dialect,
         bool rotary) {
        return read_gcode(text, tool, {dialect_of(dialect), rotary}).sections;
      },
      py::arg("text"), py::arg("tool"), py::arg("dialect") = "linuxcnc", py::arg("rotary") = false,
      py::call_guard<py::gil_scoped_release>(),
      "The sections of a program; with `rotary` its points as programmed, and the angles beside "
      "them. "
      "Raises InputError for anything not understood.");
  py::class_<PlanMatch>(m, "PlanMatch", "How a path read back compares with its plan.")
      .def_readonly("complete", &PlanMatch::complete)
      .def_readonly("found", &PlanMatch::found)
      .def_readonly("largest_miss", &PlanMatch::largest_miss)
      .def_readonly("extra_moves", &PlanMatch::extra_moves)
      .def_readonly("lost_moves", &PlanMatch::lost_moves);
  m.def("match_plan", &match_plan, py::arg("read"), py::arg("plan"), py::arg("tolerance"),
        "Gives the moves of `read` the kinds and dimple numbers of `plan`, in place.");
}

void bind_writer(py::module_& m) {
  m.def("write_program", &program_of, py::arg("texts"), py::arg("dialect"), py::kw_only(),
        py::arg("precision") = 3, py::arg("line_numbers") = false, py::arg("comments") = true,
        py::arg("modal") = false, py::arg("axis_modal") = false, py::arg("tool_length") = true,
        py::arg("name") = "PATCHMILL", py::arg("header") = std::vector<std::string>(),
        py::arg("preamble") = "", py::arg("postamble") = "", py::arg("smoothing_on") = "",
        py::arg("smoothing_off") = "", py::call_guard<py::gil_scoped_release>(),
        "The program of FreeCAD's path texts (Path.toGCode()) in a dialect.");
}

}  // namespace

void bind_machine(py::module_& m) {
  bind_text(m);
  bind_reader(m);
  bind_writer(m);
}

}  // namespace patchmill

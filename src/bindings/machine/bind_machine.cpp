// G-code reading and writing, and FreeCAD text, for Python.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "bindings/path/path_text.h"
#include "patchmill/gcode/freecad_text.h"
#include "patchmill/gcode/gcode_reader.h"
#include "patchmill/gcode/path_feeds.h"
#include "patchmill/gcode/program_writer.h"
#include "patchmill/geometry/error.h"

#include <algorithm>
#include <clocale>

namespace patchmill {
namespace {

std::string program_of(const std::vector<std::string>& texts, const std::string& dialect,
                       int precision, bool line_numbers, bool comments, bool modal, bool axis_modal,
                       bool tool_length, const std::string& name,
                       const std::vector<std::string>& header, const std::string& preamble,
                       const std::string& postamble, const std::string& smoothing_on,
                       const std::string& smoothing_off, const std::string& tcp_on,
                       const std::string& tcp_off, int number,
                       const std::vector<std::pair<std::string, double>>& retract,
                       const std::optional<std::pair<Vec3, Vec3>>& stock,
                       const std::vector<bool>& own) {
  gcode::ProgramStyle style;
  style.control = &gcode::control_of(dialect);
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
  style.tcp_on = tcp_on;
  style.tcp_off = tcp_off;
  style.number = number;
  for (const auto& [axis, value] : retract) {
    if (axis.size() != 1 || std::string("XYZ").find(axis) == std::string::npos)
      throw InputError("retract", "'" + axis + "'", "give X, Y or Z.");
    require_in_range("retract", value, -1e5, 1e5, "mm");
    style.retract.emplace_back(axis[0], value);
  }
  style.stock = stock;
  style.own = own;
  return gcode::write_program(texts, style);
}

void bind_text(py::module_& m) {
  py::class_<PathText>(m, "PathText", "Lines for Path.Path(), in parts; str() gives the whole.")
      .def("__len__", &PathText::parts, "How many parts it is in. Raises nothing.")
      .def(
          "__getitem__",
          [](const PathText& text, std::size_t i) {
            if (i >= text.parts()) throw py::index_error();
            return py::str(text.part(i).data(), text.part(i).size());
          },
          "A part of the text. Raises IndexError beyond the last.")
      .def("__str__", &PathText::whole, "All parts, one after the other. Raises nothing.");
  m.def(
      "freecad_text",
      interruptible([](const ToolPath& path, std::optional<double> feed, int decimals,
                       bool exact_stop) {
        const Decimals d(decimals);
        return PathText((exact_stop ? "G61\n" : "") + (feed ? gcode::freecad_text(path, *feed, d)
                                                            : gcode::freecad_text(path, d)));
      }),
      py::arg("path"), py::arg("feed"), py::arg("decimals"), py::arg("exact_stop") = false,
      "A constant-feed path as text for Path.Path(text); `feed` [mm/s], or None for a path whose "
      "moves have their own. `exact_stop`: G61 first. Raises InputError naming Feed or Decimals.");
}

gcode::ProgramSection section_part(const gcode::ProgramSection& whole, std::size_t first,
                                   std::size_t end, const Tool& tool) {
  const std::vector<Move>& moves = whole.path.moves;
  if (first > end || end > moves.size())
    throw InputError("first", std::to_string(first), "give moves of the section, in order.");
  const auto cut = [&](auto values, std::size_t more) {
    values.erase(values.begin() + static_cast<std::ptrdiff_t>(end + more), values.end());
    values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(first));
    return values;
  };
  gcode::ProgramSection part = whole;
  part.path.tool = tool;
  if (first > 0) part.path.start = moves[first - 1].end;
  part.path.moves = cut(moves, 0);
  part.lines = cut(whole.lines, 0);
  part.feeds = cut(whole.feeds, 0);
  part.inverse = cut(whole.inverse, 0);
  if (!whole.angles.empty()) part.angles = cut(whole.angles, 1);
  if (!whole.tcp.empty()) part.tcp = cut(whole.tcp, 0);
  part.unplaced = std::max<std::int64_t>(0, whole.unplaced - static_cast<std::int64_t>(first));
  part.unplaced = std::min(part.unplaced, static_cast<std::int64_t>(end - first));
  return part;
}

void bind_reader(py::module_& m) {
  py::class_<gcode::ProgramSection>(m, "ProgramSection",
                                    "One tool, spindle speed and sense of a program.")
      .def_readonly("tool_number", &gcode::ProgramSection::tool_number)
      .def_readonly("offset", &gcode::ProgramSection::offset,
                    "Work offset in force: 'G55', 'G54.1 P3'; '' while the program has named none.")
      .def_readonly("path", &gcode::ProgramSection::path)
      .def_readonly("unplaced", &gcode::ProgramSection::unplaced,
                    "Moves at the beginning that start nobody knows where.")
      .def_readonly("lines", &gcode::ProgramSection::lines)
      .def_property_readonly(
          "feeds",
          [](const gcode::ProgramSection& s) {
            return column_of<double>(s.feeds, [](double f) { return f; });
          },
          "F of each move [mm/min, or 1/min where `inverse`]; nan for rapids, dwells and G33.")
      .def_property_readonly("inverse",
                             [](const gcode::ProgramSection& s) {
                               return column_of<bool>(s.inverse, [](bool on) { return on; });
                             })
      .def_property_readonly(
          "angles",
          [](const gcode::ProgramSection& s) {
            return rows_of(s.angles,
                           [](const std::array<double, 3>& a) { return Vec3(a[0], a[1], a[2]); });
          },
          "A, B and C at the start and at the end of each move [rad], (n + 1, 3).")
      .def_property_readonly("tcp",
                             [](const gcode::ProgramSection& s) {
                               return column_of<bool>(s.tcp, [](bool on) { return on; });
                             })
      .def("part", &section_part, py::arg("first"), py::arg("end"), py::arg("tool"),
           "The moves from `first` to before `end` alone, of `tool`. Raises InputError naming "
           "first.");
  m.def(
      "read_gcode",
      interruptible([](const std::string& text, const Tool& tool, const std::string& dialect,
                       bool rotary, const std::string& tcp_on, const std::string& tcp_off) {
        return gcode::read_gcode(text, tool, {&gcode::control_of(dialect), rotary, tcp_on, tcp_off})
            .sections;
      }),
      py::arg("text"), py::arg("tool"), py::arg("dialect") = "linuxcnc", py::arg("rotary") = false,
      py::arg("tcp_on") = "", py::arg("tcp_off") = "",
      "The sections of a program; with `rotary` its points as programmed, and the angles beside "
      "them. "
      "Raises InputError for anything not understood.");
  m.def(
      "program_lines",
      [](const std::string& text, const std::string& dialect) {
        std::vector<std::pair<long, std::vector<std::pair<std::string, double>>>> lines;
        for (const gcode::ProgramLine& line :
             gcode::program_lines(text, gcode::control_of(dialect))) {
          lines.push_back({line.number, {}});
          for (const gcode::GcodeWord& w : line.words)
            lines.back().second.emplace_back(std::string(1, w.letter), w.value);
        }
        return lines;
      },
      py::arg("text"), py::arg("dialect") = "linuxcnc",
      "[(line, [(letter, value), ...]), ...] of every line that has words, in the common tongue: "
      "G4 P in seconds, "
      "offsets as G54 to G59.3, TCP as G43.4 and G49. Raises InputError for a word that the "
      "control would refuse.");
  py::class_<gcode::PlanMatch>(m, "PlanMatch", "How a path read back compares with its plan.")
      .def_readonly("complete", &gcode::PlanMatch::complete)
      .def_readonly("found", &gcode::PlanMatch::found)
      .def_readonly("largest_miss", &gcode::PlanMatch::largest_miss)
      .def_readonly("extra_moves", &gcode::PlanMatch::extra_moves)
      .def_readonly("lost_moves", &gcode::PlanMatch::lost_moves);
  m.def("match_plan", &gcode::match_plan, py::arg("read"), py::arg("plan"), py::arg("tolerance"),
        "Gives the moves of `read` the kinds and dimple numbers of `plan`, in place. Raises "
        "InputError naming Tolerance.");
}

py::dict control_dict(const gcode::Control& control) {
  py::dict d;
  d["name"] = std::string(control.name);
  d["title"] = std::string(control.title);
  d["file_ending"] = std::string(control.file_ending);
  d["max_decimals"] = control.can.max_decimals;
  d["tcp"] = control.can.tcp;
  d["inverse_time"] = control.can.inverse_time;
  d["spindle_lock"] = control.can.lead != gcode::LeadRule::None;
  d["cycles"] = control.can.cycles;
  std::vector<std::string> offsets;
  for (const gcode::CodeWord& word : control.codes)
    if (word.letter == 'G' && word.means >= 540 && word.means <= 593 && word.means != 541)
      offsets.push_back(gcode::code_text('G', word.means));
  d["offsets"] = offsets;
  return d;
}

// A call during which this thread's numbers have decimal points, whatever locale the process has.
py::object with_decimal_points(const py::function& call) {
  struct Plain {
    locale_t own = newlocale(LC_NUMERIC_MASK, "C", duplocale(LC_GLOBAL_LOCALE));
    locale_t before = uselocale(own);
    ~Plain() {
      uselocale(before);
      freelocale(own);
    }
  } const plain;
  return call();
}

void bind_writer(py::module_& m) {
  m.def("write_program", interruptible(&program_of), py::arg("texts"), py::arg("dialect"),
        py::kw_only(), py::arg("precision") = 3, py::arg("line_numbers") = false,
        py::arg("comments") = true, py::arg("modal") = false, py::arg("axis_modal") = false,
        py::arg("tool_length") = true, py::arg("name") = "PATCHMILL",
        py::arg("header") = std::vector<std::string>(), py::arg("preamble") = "",
        py::arg("postamble") = "", py::arg("smoothing_on") = "", py::arg("smoothing_off") = "",
        py::arg("tcp_on") = "", py::arg("tcp_off") = "", py::arg("number") = 1,
        py::arg("retract") = std::vector<std::pair<std::string, double>>(),
        py::arg("stock") = py::none(), py::arg("own") = std::vector<bool>(),
        "The program of FreeCAD's path texts (Path.toGCode()) for a control. Raises InputError "
        "naming Dialect, "
        "PostProcessorArgs, Strategy, ProgramForm, Machine or Path.");
  m.def(
      "controls",
      [] {
        std::vector<py::dict> all;
        for (const gcode::Control* control : gcode::controls())
          all.push_back(control_dict(*control));
        return all;
      },
      "What each control can do, as dicts: name, title, file_ending, max_decimals, tcp, "
      "inverse_time, spindle_lock, cycles, offsets. Raises nothing.");
  m.def(
      "feeds_of", [](const std::string& text) { return gcode::feeds_of(text); }, py::arg("text"),
      "The values of all F words of a path's text, in their order. Raises nothing.");
  m.def("with_feeds", interruptible(&gcode::with_feeds), py::arg("text"), py::arg("feeds"),
        "A path's text with its F words replaced by `feeds`, where they are the same but for "
        "FreeCAD's six decimals. Raises InputError naming feeds.");
  m.def("with_decimal_points", &with_decimal_points, py::arg("call"),
        "call() with decimal points in this thread, whatever locale the process has. Raises what "
        "call() does.");
  m.def(
      "safe_comment",
      [](const std::string& dialect, const std::string& text) {
        return gcode::safe_comment(gcode::control_of(dialect).comments, text);
      },
      py::arg("dialect"), py::arg("text"),
      "`text` as a comment that the control never acts on. Raises InputError naming Dialect.");
}

}  // namespace

void bind_machine(py::module_& m) {
  bind_text(m);
  bind_reader(m);
  bind_writer(m);
}

}  // namespace patchmill

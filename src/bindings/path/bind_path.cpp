// ToolPath, tools and spindles for Python.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "patchmill/geometry/require.h"
#include "patchmill/path/tool_path.h"

#include <algorithm>
#include <cmath>

namespace patchmill {
namespace {

Spindle spindle_of(double speed, const std::string& sense) {
  if (sense != "M3" && sense != "M4")
    throw InputError("SpindleDirection", "'" + sense + "'", "give M3 or M4.");
  require_positive("SpindleSpeed", speed * 60.0, "rpm");
  return {speed, sense == "M3" ? SpindleSense::M3 : SpindleSense::M4};
}

using Rows = Eigen::Matrix<double, -1, 3, Eigen::RowMajor>;

ToolPath make_path(const Tool& tool, const Spindle& spindle, const Vec3& start, const Rows& tips,
                   const std::optional<Rows>& axes, const std::vector<std::uint8_t>& kinds,
                   const std::vector<double>& turns) {
  const auto n = static_cast<std::size_t>(tips.rows());
  if (kinds.size() != n || turns.size() != n || (axes && axes->rows() != tips.rows()))
    throw InputError("path", "arrays of different length", "give one row for each move.");
  constexpr double kFarthest = 1e6;  // mm
  if (!(start.cwiseAbs().maxCoeff() <= kFarthest) ||
      (n > 0 && !(tips.cwiseAbs().maxCoeff() <= kFarthest)) || !start.allFinite() ||
      !tips.allFinite())
    throw InputError("path", "a tip that is not finite, or far off",
                     "keep within 1e6 mm of the work's zero.");
  ToolPath path;
  path.tool = tool;
  path.spindle = spindle;
  path.start.tip = start;
  for (std::size_t i = 0; i < n; ++i) {
    Move move;
    move.end.tip = tips.row(static_cast<Eigen::Index>(i));
    if (axes) move.end.axis = unit_along("axes", axes->row(static_cast<Eigen::Index>(i)));
    if (turns[i] < 0.0 || std::isinf(turns[i]))
      throw InputError("turns", std::to_string(turns[i]),
                       "give 0 or more, or NaN where nobody knows.");
    if (kinds[i] > static_cast<std::uint8_t>(MoveKind::Cut))
      throw InputError("kind", std::to_string(kinds[i]), "give a MoveKind: 0, 1 or 2.");
    move.kind = static_cast<MoveKind>(kinds[i]);
    move.turns = turns[i];
    path.moves.push_back(move);
  }
  if (axes && n > 0) path.start.axis = path.moves.front().end.axis;
  return path;
}

ToolPath with_dimples(ToolPath path, const std::vector<std::int32_t>& dimples) {
  if (dimples.size() != path.moves.size())
    throw InputError("dimples", std::to_string(dimples.size()) + " numbers",
                     "give one for each of " + std::to_string(path.moves.size()) + " moves.");
  for (std::size_t i = 0; i < dimples.size(); ++i) {
    if (dimples[i] < 0 && dimples[i] != kNoDimple)
      throw InputError("dimples", std::to_string(dimples[i]), "give 0 or more, or NO_DIMPLE.");
    path.moves[i].dimple = dimples[i];
  }
  return path;
}

ToolPath with_turns(ToolPath path, const std::vector<double>& turns) {
  if (turns.size() != path.moves.size())
    throw InputError("turns", std::to_string(turns.size()) + " numbers",
                     "give one for each of " + std::to_string(path.moves.size()) + " moves.");
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const bool rapid = path.moves[i].kind == MoveKind::Rapid;
    if (rapid && std::isnan(turns[i])) continue;  // as the path itself says it
    if (!(turns[i] > 0.0) || std::isinf(turns[i]))
      throw InputError("turns", std::to_string(turns[i]), "give a number greater than zero.");
    if (!rapid) path.moves[i].turns = turns[i];
  }
  return path;
}

// What keeps the time of timed moves, and the tolerances of the corners at their ends, as another path of as many has
// them.
ToolPath with_pacing_of(ToolPath path, const ToolPath& other) {
  const auto is_timed = [](const Move& move) { return move.kind != MoveKind::Rapid; };
  const auto timed = [&](const ToolPath& p) {
    return std::count_if(p.moves.begin(), p.moves.end(), is_timed);
  };
  if (timed(path) != timed(other))
    throw InputError("other", std::to_string(timed(other)) + " timed moves",
                     "give a path of " + std::to_string(timed(path)) + ".");
  auto from = other.moves.begin();
  for (Move& move : path.moves) {
    if (!is_timed(move)) continue;
    from = std::find_if(from, other.moves.end(), is_timed);
    move.tolerance = from->tolerance;
    move.pace = (from++)->pace;
  }
  return path;
}

py::dict statistics_dict(const ToolPath& path) {
  const PathStatistics s = statistics(path);
  py::dict d;
  d["cut_length_mm"] = s.cut_length;
  d["link_length_mm"] = s.link_length;
  d["rapid_length_mm"] = s.rapid_length;
  d["timed_seconds"] = s.timed_seconds;
  d["cut_turns"] = s.cut_turns;
  d["link_turns"] = s.link_turns;
  d["dimples"] = s.dimples;
  d["untimed_moves"] = s.untimed_moves;
  return d;
}

using FrustumTuple = std::tuple<double, double, double, double>;
using SectionTuple = std::tuple<std::string, double, double, double, double>;

Tool make_tool(double radius, int flutes, std::optional<double> corner_radius, double taper,
               double cutting_length, double shank_radius, double stick_out,
               const std::vector<FrustumTuple>& holder) {
  require_positive("BallRadius", radius, "mm");
  require_in_range("Flutes", flutes, 1, 32, "flutes");
  Tool tool{radius, flutes, corner_radius, Angle::radians(taper)};
  tool.shaft = {cutting_length, shank_radius, stick_out, {}};
  for (const auto& [from, to, radius_from, radius_to] : holder)
    tool.shaft.holder.push_back({from, to, radius_from, radius_to});
  require_valid(tool);
  return tool;
}

std::vector<SectionTuple> section_tuples(const Tool& tool) {
  std::vector<SectionTuple> out;
  for (const ToolSection& s : tool.sections())
    out.emplace_back(name(s.part), s.from, s.to, s.radius_from, s.radius_to);
  return out;
}

void bind_tool(py::module_& m) {
  py::class_<Tool>(
      m, "Tool",
      "A cutter: radius [mm], > 0; flutes, 1 to 32; radius of its corner [mm], 0 (flat) to the "
      "radius (a ball, as without one); angle between flank and axis [rad]. Above its end, 0 where "
      "it is not known [mm]: the height to which its edges go, the radius of its shank, how far it "
      "stands out of its holder; the holder as (from, to, radius_from, radius_to), heights above "
      "the tip. Raises InputError naming BallRadius, Flutes, CornerRadius, TaperAngle, "
      "CuttingLength, ShankRadius, StickOut or ToolSection.")
      .def(py::init(&make_tool), py::arg("radius"), py::arg("flutes"),
           py::arg("corner_radius") = py::none(), py::arg("taper") = 0.0,
           py::arg("cutting_length") = 0.0, py::arg("shank_radius") = 0.0,
           py::arg("stick_out") = 0.0, py::arg("holder") = std::vector<FrustumTuple>(),
           "Lengths in mm, `taper` [rad]. Raises InputError naming BallRadius, Flutes, "
           "CornerRadius, TaperAngle, CuttingLength, ShankRadius, StickOut or ToolSection.")
      .def(
          "__eq__", [](const Tool& a, const Tool& b) { return a == b; },
          "Whether all its lengths are the same. Raises nothing.")
      .def_readonly("radius", &Tool::radius)
      .def_readonly("flutes", &Tool::flutes)
      .def_property_readonly("corner_radius", &Tool::corner,
                             "[mm]; so far is the tool's centre above its tip.")
      .def_property_readonly("taper", [](const Tool& t) { return t.taper.radians(); })
      .def_property_readonly("is_ball", &Tool::is_ball)
      .def_property_readonly("cutting_length", [](const Tool& t) { return t.shaft.cutting_length; })
      .def_property_readonly("shank_radius", [](const Tool& t) { return t.shaft.shank_radius; })
      .def_property_readonly("stick_out", [](const Tool& t) { return t.shaft.stick_out; })
      .def_property_readonly("sections", &section_tuples,
                             "What is above its end, as (part, from, to, radius_from, radius_to), "
                             "heights above the tip [mm]; part: 'flute', 'shank' or 'holder'.")
      .def_property_readonly("name", [](const Tool& t) { return name(t.shape()); })
      .def("scallop_height", &scallop_height, py::arg("cross_feed"),
           "Ridge that it leaves on a flat between passes [mm]. Raises InputError naming "
           "CrossFeed.");
  m.attr("BallEndMill") = m.attr("Tool");  // as it was called while there was no other
}

}  // namespace

void bind_path(py::module_& m) {
  bind_tool(m);
  bind_enum<MoveKind>(
      m, "MoveKind",
      "What a move is for: RAPID, G0, its time is the machine's affair; LINK, timed and clear of "
      "the part; CUT, timed and near or in the part.",
      {{"RAPID", MoveKind::Rapid}, {"LINK", MoveKind::Link}, {"CUT", MoveKind::Cut}});
  m.attr("NO_DIMPLE") = kNoDimple;
  py::class_<Spindle>(m, "Spindle", "Speed [revolutions per second], > 0, and sense, 'M3' or 'M4'.")
      .def(py::init(&spindle_of), py::arg("speed"), py::arg("sense"),
           "Speed [revolutions per second] and sense. Raises InputError naming SpindleSpeed or "
           "SpindleDirection.")
      .def(
          "__eq__",
          [](const Spindle& a, const Spindle& b) {
            return a.speed == b.speed && a.sense == b.sense;
          },
          "Whether speed and sense are the same. Raises nothing.")
      .def_readonly("speed", &Spindle::speed)
      .def_property_readonly("sign", &Spindle::sign)
      .def_property_readonly(
          "sense", [](const Spindle& s) { return s.sense == SpindleSense::M3 ? "M3" : "M4"; });
  py::class_<ToolPath>(m, "ToolPath", "An ordered list of timed moves of the tool tip.")
      .def(
          "__len__", [](const ToolPath& p) { return p.moves.size(); },
          "How many moves it has. Raises nothing.")
      .def_readonly("tool", &ToolPath::tool)
      .def_readonly("spindle", &ToolPath::spindle)
      .def_property_readonly("start", [](const ToolPath& p) { return p.start.tip; })
      .def_property_readonly(
          "tips",
          [](const ToolPath& p) {
            return rows_of(p.moves, [](const Move& v) { return v.end.tip; });
          },
          "End of each move [mm], (n, 3).")
      .def_property_readonly(
          "axes",
          [](const ToolPath& p) {
            return rows_of(p.moves, [](const Move& v) { return v.end.axis; });
          },
          "Unit tool axis at the end of each move, (n, 3).")
      .def_property_readonly(
          "turns",
          [](const ToolPath& p) {
            return column_of<double>(p.moves, [](const Move& v) { return v.turns; });
          },
          "Planned spindle turns of each move; NaN where unknown.")
      .def_property_readonly(
          "dimples",
          [](const ToolPath& p) {
            return column_of<std::int32_t>(p.moves, [](const Move& v) { return v.dimple; });
          },
          "Number of the dimple on which each move ends, or NO_DIMPLE.")
      .def_property_readonly(
          "kinds",
          [](const ToolPath& p) {
            return column_of<std::uint8_t>(
                p.moves, [](const Move& v) { return static_cast<std::uint8_t>(v.kind); });
          },
          "The MoveKind of each move.")
      .def("statistics", &statistics_dict,
           "Lengths [mm], seconds, turns and counts. Raises nothing.");
  m.def("make_path", &make_path, py::arg("tool"), py::arg("spindle"), py::arg("start"),
        py::arg("tips"), py::arg("axes"), py::arg("kinds"), py::arg("turns"),
        "ToolPath from arrays as ToolPath gives them: tips [mm], axes of any length or None for an "
        "upright tool, "
        "a MoveKind for each, spindle turns or NaN. Raises InputError naming path, axes, kind or "
        "turns.");
  m.def("with_dimples", &with_dimples, py::arg("path"), py::arg("dimples"),
        "The path with the number of the dimple on which each move ends, or NO_DIMPLE. Raises "
        "InputError naming dimples.");
  m.def(
      "with_turns", &with_turns, py::arg("path"), py::arg("turns"),
      "The path with other turns of the spindle on each move that is no rapid, of which NaN may be "
      "given. Raises InputError naming turns.");
  m.def("with_pacing_of", &with_pacing_of, py::arg("path"), py::arg("other"),
        "The path with the pace of moves and the tolerances of corners of another one with as many "
        "timed moves. Raises InputError naming other.");
}

}  // namespace patchmill

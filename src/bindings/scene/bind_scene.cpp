// Displays for Python: made in any thread, in chunks of bytes that Coin reads, so that big arrays never become
// Python lists.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "patchmill/geometry/require.h"
#include "patchmill/path/tool_path.h"
#include "scene/colours.h"
#include "scene/dimple_nodes.h"
#include "scene/field_nodes.h"
#include "scene/grid_nodes.h"
#include "scene/path_nodes.h"

namespace patchmill {
namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// One object to Python; chunks stay in C++.
struct HeldDisplay {
  scene::Display chunks;
};

/// Chunk `i`, an Open Inventor file.
py::bytes chunk(const HeldDisplay& display, std::size_t number) {
  if (number >= display.chunks.size())
    throw InputError("number", std::to_string(number),
                     "give one from 0 to below the display's length.");
  return py::bytes(display.chunks[number]);
}

std::vector<Vec3> vectors_of(const Rows& rows) {
  std::vector<Vec3> vectors;
  vectors.reserve(static_cast<std::size_t>(rows.rows()));
  for (Eigen::Index i = 0; i < rows.rows(); ++i) vectors.emplace_back(rows.row(i));
  return vectors;
}

void require_scale(double low, double high) {
  require_finite("low", low, "");
  require_finite("high", high, "");
}

HeldDisplay grid_display_of(const Array& points, const Array& values, double low, double high) {
  if (points.ndim() != 3 || points.shape(2) != 3 || values.ndim() != 2 ||
      values.shape(0) != points.shape(0) || values.shape(1) != points.shape(1))
    throw InputError("points", "an array of another shape",
                     "give points as (rows, columns, 3) and values as (rows, columns).");
  require_scale(low, high);
  scene::Grid grid;
  grid.rows = static_cast<std::size_t>(points.shape(0));
  grid.columns = static_cast<std::size_t>(points.shape(1));
  grid.points = points.data();
  grid.values = values.data();
  grid.low = low;
  grid.high = high;
  const py::gil_scoped_release release;
  return {scene::grid_display(grid)};
}

HeldDisplay outline_display_of(const std::vector<Rows>& outlines) {
  std::vector<std::vector<Vec3>> lines;
  for (const Rows& outline : outlines) lines.push_back(vectors_of(outline));
  return {scene::outline_display(lines)};
}

py::tuple channels(scene::Rgba colour) {
  return py::make_tuple(colour >> 24, (colour >> 16) & 0xffu, (colour >> 8) & 0xffu);
}

py::dict state_colours() {
  py::dict colours;
  for (int s = 0; s < patch::kDimpleStates; ++s) {
    const auto state = static_cast<patch::DimpleState>(s);
    colours[patch::name(state)] = channels(scene::state_colour(state));
  }
  return colours;
}

void bind_fields(py::module_& m) {
  m.def("grid_display", &grid_display_of, py::arg("points"), py::arg("values"), py::arg("low"),
        py::arg("high"),
        "A surface of (rows, columns, 3) points [mm], coloured by (rows, columns) values. Raises "
        "InputError naming points, values, low or high.");
  m.def(
      "slice_display",
      [](const Rows& centres, const std::vector<double>& values, double side, int axis, double low,
         double high) {
        require_scale(low, high);
        require_positive("side", side, "mm");
        return HeldDisplay{
            scene::slice_display(vectors_of(centres), values, side, axis, low, high)};
      },
      py::arg("centres"), py::arg("values"), py::arg("side"), py::arg("axis"), py::arg("low"),
      py::arg("high"),
      "Squares of `side` [mm] at right angles to axis 0, 1 or 2. Raises InputError naming values, "
      "side, axis, low or high.");
  m.def(
      "arrow_display",
      [](const Rows& places, const Rows& vectors, double scale, const std::vector<double>& values,
         double low, double high) {
        require_scale(low, high);
        require_finite("scale", scale, "");
        return HeldDisplay{scene::arrow_display(vectors_of(places), vectors_of(vectors), scale,
                                                values, low, high)};
      },
      py::arg("places"), py::arg("vectors"), py::arg("scale"), py::arg("values"), py::arg("low"),
      py::arg("high"),
      "Arrows of length `scale` times the (n, 3) vectors. Raises InputError naming vectors, scale, "
      "values, low or high.");
  m.def(
      "scale_colour", [](double share) { return channels(scene::scale_colour(share)); },
      py::arg("share"),
      "Red, green, blue (0 to 255) of the colour scale at a share of 0 to 1. Raises nothing.");
}

void bind_texture_displays(py::module_& m) {
  const auto released = py::call_guard<py::gil_scoped_release>();
  m.def(
      "dimple_display",
      [](const patch::Dimples& dimples, double radius) {
        require_positive("radius", radius, "mm");
        return HeldDisplay{scene::dimple_display(dimples, radius)};
      },
      py::arg("dimples"), py::arg("radius"), released,
      "Discs of `radius` [mm] on the surface, coloured by state. Raises InputError naming radius.");
  m.def(
      "order_display",
      [](const patch::Dimples& dimples, double spacing) {
        require_positive("spacing", spacing, "mm");
        return HeldDisplay{scene::order_display(dimples, spacing)};
      },
      py::arg("dimples"), py::arg("spacing"), released,
      "The order in which dimples are milled, with arrowheads. Raises InputError naming spacing.");
  m.def("outline_display", &outline_display_of, py::arg("outlines"),
        "Polylines, each (k, 3) [mm]; rows of NaN interrupt them. Raises nothing.");
  m.def("state_colours", &state_colours,
        "Red, green, blue (0 to 255) in which dimple_display draws each state, by name. Raises "
        "nothing.");
}

}  // namespace

void bind_scene(py::module_& m) {
  py::class_<HeldDisplay>(m, "Display", "Something to show, in chunks; made in any thread.")
      .def(
          "__len__", [](const HeldDisplay& d) { return d.chunks.size(); },
          "How many chunks there are. Raises nothing.")
      .def("chunk", &chunk, py::arg("number"),
           "A chunk as the bytes of an Open Inventor file, for coin.SoDB.readAll. Raises "
           "InputError naming number.");
  bind_texture_displays(m);
  const auto released = py::call_guard<py::gil_scoped_release>();
  m.def(
      "path_display",
      [](const ToolPath& path) {
        return HeldDisplay{scene::path_display(path, 0, path.moves.size())};
      },
      py::arg("path"), released, "The tool tip's way, coloured by kind of move. Raises nothing.");
  m.def(
      "path_axis_display",
      [](const ToolPath& path, double length, std::size_t most) {
        require_positive("length", length, "mm");
        return HeldDisplay{scene::path_axis_display(path, length, most)};
      },
      py::arg("path"), py::arg("length"), py::arg("most") = 2000, released,
      "Tool axes at ends of moves, at most `most` of them. Raises InputError naming length.");
  bind_fields(m);
}

}  // namespace patchmill

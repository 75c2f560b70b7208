// Display for Python: fills groups of Coin nodes that pivy made and named. Coin's node names are global in
// the process, so big arrays never become Python lists.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "core/geometry/error.h"
#include "core/path/tool_path.h"
#include "scene/colours.h"
#include "scene/dimple_nodes.h"
#include "scene/field_nodes.h"
#include "scene/grid_nodes.h"
#include "scene/path_nodes.h"

#include <Inventor/SbName.h>
#include <Inventor/nodes/SoGroup.h>
#include <Inventor/nodes/SoSeparator.h>

namespace patchmill {
namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Puts `made` in the group named `group` in place of what it held.
void fill(const std::string& group, SoSeparator* made) {
  made->ref();
  SoNode* node = SoNode::getByName(SbName(group.c_str()));
  if (!node || !node->isOfType(SoGroup::getClassTypeId())) {
    made->unref();
    throw InputError("group", "'" + group + "'", "name a Coin group that exists.");
  }
  auto* parent = static_cast<SoGroup*>(node);
  parent->removeAllChildren();
  parent->addChild(made);
  made->unref();
}

std::vector<Vec3> vectors_of(const Rows& rows) {
  std::vector<Vec3> vectors;
  vectors.reserve(static_cast<std::size_t>(rows.rows()));
  for (Eigen::Index i = 0; i < rows.rows(); ++i) vectors.emplace_back(rows.row(i));
  return vectors;
}

void show_grid(const std::string& group, const Array& points, const Array& values, double low,
               double high) {
  if (points.ndim() != 3 || points.shape(2) != 3 || values.ndim() != 2 ||
      values.shape(0) != points.shape(0) || values.shape(1) != points.shape(1))
    throw InputError("points", "an array of another shape",
                     "give points as (rows, columns, 3) and values as (rows, columns).");
  scene::Grid grid;
  grid.rows = static_cast<std::size_t>(points.shape(0));
  grid.columns = static_cast<std::size_t>(points.shape(1));
  grid.points = points.data();
  grid.values = values.data();
  grid.low = low;
  grid.high = high;
  fill(group, scene::grid_node(grid));
}

void show_outlines(const std::string& group, const std::vector<Rows>& outlines) {
  std::vector<std::vector<Vec3>> lines;
  for (const Rows& outline : outlines) lines.push_back(vectors_of(outline));
  fill(group, scene::outline_node(lines));
}

void bind_fields(py::module_& m) {
  m.def("show_grid", &show_grid, py::arg("group"), py::arg("points"), py::arg("values"),
        py::arg("low"), py::arg("high"),
        "A surface of (rows, columns, 3) points [mm], coloured by (rows, columns) values.");
  m.def(
      "show_slice",
      [](const std::string& group, const Rows& centres, const std::vector<double>& values,
         double side, int axis, double low, double high) {
        fill(group, scene::slice_node(vectors_of(centres), values, side, axis, low, high));
      },
      py::arg("group"), py::arg("centres"), py::arg("values"), py::arg("side"), py::arg("axis"),
      py::arg("low"), py::arg("high"), "Squares of `side` [mm] at right angles to axis 0, 1 or 2.");
  m.def(
      "show_arrows",
      [](const std::string& group, const Rows& places, const Rows& vectors, double scale,
         const std::vector<double>& values, double low, double high) {
        fill(group,
             scene::arrow_node(vectors_of(places), vectors_of(vectors), scale, values, low, high));
      },
      py::arg("group"), py::arg("places"), py::arg("vectors"), py::arg("scale"), py::arg("values"),
      py::arg("low"), py::arg("high"), "Arrows of length `scale` times the (n, 3) vectors.");
  m.def(
      "scale_colour",
      [](double share) {
        const scene::Rgba c = scene::scale_colour(share);
        return py::make_tuple(c >> 24, (c >> 16) & 0xffu, (c >> 8) & 0xffu);
      },
      py::arg("share"), "Red, green, blue (0 to 255) of the colour scale at a share of 0 to 1.");
}

void bind_texture_nodes(py::module_& m) {
  m.def(
      "show_dimples",
      [](const std::string& group, const Dimples& dimples, double radius) {
        fill(group, scene::dimple_node(dimples, radius));
      },
      py::arg("group"), py::arg("dimples"), py::arg("radius"),
      "Discs of `radius` [mm] on the surface, coloured by state.");
  m.def(
      "show_order",
      [](const std::string& group, const Dimples& dimples, double spacing) {
        fill(group, scene::order_node(dimples, spacing));
      },
      py::arg("group"), py::arg("dimples"), py::arg("spacing"),
      "The order in which dimples are milled, with arrowheads.");
  m.def(
      "show_axes",
      [](const std::string& group, const Dimples& dimples, const Rows& axes, double length,
         std::size_t most) {
        fill(group, scene::axis_node(dimples, vectors_of(axes), length, most));
      },
      py::arg("group"), py::arg("dimples"), py::arg("axes"), py::arg("length"),
      py::arg("most") = 2000, "Tool axes at the dimples.");
  m.def("show_outlines", &show_outlines, py::arg("group"), py::arg("outlines"),
        "Polylines, each (k, 3) [mm]; rows of NaN interrupt them.");
  m.def(
      "state_colours",
      [] {
        py::dict colours;
        for (int s = 0; s < kDimpleStates; ++s) {
          const auto state = static_cast<DimpleState>(s);
          const scene::Rgba c = scene::state_colour(state);
          colours[name(state)] = py::make_tuple(c >> 24, (c >> 16) & 0xffu, (c >> 8) & 0xffu);
        }
        return colours;
      },
      "Red, green, blue (0 to 255) in which show_dimples draws each state, by name.");
}

}  // namespace

void bind_scene(py::module_& m) {
  bind_texture_nodes(m);
  m.def(
      "show_path",
      [](const std::string& group, const ToolPath& path, std::size_t first, std::size_t last) {
        fill(group, scene::path_node(path, first, last));
      },
      py::arg("group"), py::arg("path"), py::arg("first") = 0,
      py::arg("last") = std::numeric_limits<std::size_t>::max(),
      "The tool tip's way, coloured by kind of move.");
  m.def(
      "show_path_axes",
      [](const std::string& group, const ToolPath& path, double length, std::size_t most) {
        fill(group, scene::path_axis_node(path, length, most));
      },
      py::arg("group"), py::arg("path"), py::arg("length"), py::arg("most") = 2000,
      "Tool axes at ends of moves.");
  bind_fields(m);
}

}  // namespace patchmill

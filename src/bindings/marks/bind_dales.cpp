// Dales of measured surfaces for Python.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "patchmill/marks/dales.h"

namespace patchmill {
namespace {

using Heights = py::array_t<float, py::array::c_style | py::array::forcecast>;

py::dict dales_dict(const Heights& heights, const Vec2& step, double least_depth) {
  if (heights.ndim() != 2) throw InputError("Heights", "no grid", "give rows of heights.");
  if (heights.shape(0) > std::numeric_limits<int>::max() ||
      heights.shape(1) > std::numeric_limits<int>::max())
    throw InputError("Heights", "more than 2^31 rows or columns", "give a smaller grid.");
  marks::HeightGrid grid;
  grid.rows = static_cast<int>(heights.shape(0));
  grid.columns = static_cast<int>(heights.shape(1));
  grid.step = step;
  grid.height.assign(heights.data(), heights.data() + heights.size());
  std::vector<marks::Dale> found;
  watched(py::none(), [&](const Progress&) { found = marks::dales(grid, least_depth); });
  py::dict d;
  d["pits"] = column_of<std::int64_t>(found, [](const marks::Dale& v) { return v.pit; });
  d["bottoms"] = column_of<double>(found, [](const marks::Dale& v) { return v.bottom; });
  d["depths"] = column_of<double>(found, [](const marks::Dale& v) { return v.depth; });
  d["areas"] = column_of<double>(found, [](const marks::Dale& v) { return v.area; });
  d["closed_areas"] = column_of<double>(found, [](const marks::Dale& v) { return v.closed_area; });
  d["volumes"] = column_of<double>(found, [](const marks::Dale& v) { return v.volume; });
  d["at_edge"] = column_of<bool>(found, [](const marks::Dale& v) { return v.at_edge; });
  return d;
}

}  // namespace

void bind_dales(py::module_& m) {
  m.def("dales", &dales_dict, py::arg("heights"), py::arg("step"), py::arg("least_depth"),
        "Dales of (rows, columns) heights [mm] by watershed and Wolf pruning, arrays of one entry "
        "each: pits (row * "
        "columns + column), bottoms, depths [mm], areas, closed_areas [mm²], volumes [mm³], "
        "at_edge. Raises "
        "InputError naming Heights, GridStep or LeastDepth.");
}

}  // namespace patchmill

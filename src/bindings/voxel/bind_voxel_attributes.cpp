// What the voxel model says at any place, and its materials, for Python.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "bindings/solid.h"
#include "bindings/voxel/voxel_materials.h"
#include "patchmill/dcm/field_reader.h"
#include "patchmill/geometry/require.h"

namespace patchmill {
namespace {

constexpr int kNoMaterial = -1;
constexpr int kStockMaterial = 0;
using Points = Eigen::Matrix<double, -1, 3, Eigen::RowMajor>;

VoxelMaterials make_materials(const voxel::VoxelGrid& grid,
                              const std::vector<std::pair<const Solid*, double>>& bodies) {
  std::vector<dcm::MaterialBody> list;
  for (const auto& [solid, depth] : bodies) list.push_back({&solid->mesh, &solid->bvh, depth});
  const py::gil_scoped_release release;
  return {dcm::materials_of(grid, list)};
}

// Zero rows where the field has no axis.
py::array_t<double> axes_at(const voxel::VoxelGrid& grid, const dcm::PostureField& posture,
                            const Points& points) {
  dcm::require_over(grid, posture);
  std::vector<Vec3> axes;
  watched(py::none(), [&](const Progress&) {
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      axes.push_back(dcm::read_axis(grid, posture, points.row(i)).value_or(Vec3::Zero()));
  });
  return rows_of(axes, [](const Vec3& v) { return v; });
}

py::array_t<double> feed_at(const voxel::VoxelGrid& grid, const dcm::FeedField& feed,
                            const Points& points, const Vec3& direction) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  dcm::require_over(grid, feed);
  const Vec3 d = unit_along("Direction", direction);
  std::vector<double> values;
  watched(py::none(), [&](const Progress&) {
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      values.push_back(dcm::read_feed(grid, feed, points.row(i), d).value_or(kNone));
  });
  return column_of<double>(values, [](double v) { return v; });
}

voxel::Cell cell_of(const voxel::VoxelGrid& grid, const Vec3& p) {
  const Vec3 u = grid.frame.in_cells(p);
  const bool near = (u.array() >= -1.0).all() && (u.array() < 65536.0).all();
  return near ? voxel::Cell(u.array().floor().cast<int>()) : voxel::Cell(-1, -1, -1);
}

py::array_t<std::uint8_t> kinds_at(const voxel::VoxelGrid& grid, const Points& points) {
  std::vector<voxel::VoxelKind> kinds;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    kinds.push_back(grid.at(cell_of(grid, points.row(i))));
  return column_of<std::uint8_t>(kinds,
                                 [](voxel::VoxelKind k) { return static_cast<std::uint8_t>(k); });
}

py::array_t<int> materials_at(const voxel::VoxelGrid& grid, const VoxelMaterials& materials,
                              const Points& points) {
  dcm::require_over(grid, materials.number);
  std::vector<int> found;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const voxel::Cell cell = cell_of(grid, points.row(i));
    const voxel::VoxelKind kind = grid.at(cell);
    const bool none = kind == voxel::VoxelKind::Air || kind == voxel::VoxelKind::Part;
    found.push_back(none ? kNoMaterial : materials.number[voxel::cell_index(grid.table, cell)]);
  }
  return column_of<int>(found, [](int m) { return m; });
}

}  // namespace

void bind_voxel_attributes(py::module_& m) {
  using voxel::VoxelKind;
  bind_enum<VoxelKind>(
      m, "VoxelKind",
      "What a voxel is: AIR, its centre is outside the stock; PART, inside the part, without "
      "product surface; REMOVAL, to be removed; SURFACE, with product surface in it; EXTERIOR, to "
      "be removed, and the skin of the stock.",
      {{"AIR", VoxelKind::Air},
       {"PART", VoxelKind::Part},
       {"REMOVAL", VoxelKind::Removal},
       {"SURFACE", VoxelKind::Surface},
       {"EXTERIOR", VoxelKind::Exterior}});
  m.attr("NO_MATERIAL") = kNoMaterial;
  m.attr("STOCK_MATERIAL") = kStockMaterial;
  py::class_<VoxelMaterials>(m, "VoxelMaterials", "The number of the material of each voxel.")
      .def_property_readonly(
          "count", [](const VoxelMaterials& v) { return v.number.size(); }, "Voxels stored.");
  m.def("materials_of", &make_materials, py::arg("grid"), py::arg("bodies"),
        "VoxelMaterials: STOCK_MATERIAL, 0, the stock's own, else 1 + the number of the last of "
        "`bodies`, pairs of Solid and depth below its surface [mm], that holds the voxel's centre. "
        "Raises InputError naming Materials.");
  m.def("scale_feed",
        interruptible([](const dcm::FeedField& feed, const VoxelMaterials& materials,
                         const std::vector<double>& factors) {
          dcm::FeedField scaled = feed;
          dcm::scale_feed(scaled, materials.number, factors);
          return scaled;
        }),
        py::arg("feed"), py::arg("materials"), py::arg("factors"),
        "The FeedField times the factor of each voxel's material. Raises InputError naming "
        "Materials.");
  m.def("axes_at", &axes_at, py::arg("grid"), py::arg("posture"), py::arg("points"),
        "Unit axes at (n, 3) points [mm], interpolated; upright in air, zero inside the part. "
        "Raises InputError naming PostureField.");
  m.def("feed_at", &feed_at, py::arg("grid"), py::arg("feed"), py::arg("points"),
        py::arg("direction"),
        "Feed [mm/s] in a direction at (n, 3) points [mm], interpolated; NaN inside the part. "
        "Raises InputError naming FeedField or Direction.");
  m.def("kinds_at", &kinds_at, py::arg("grid"), py::arg("points"),
        "The VoxelKind of the voxels that hold (n, 3) points [mm]. Raises nothing.");
  m.def("materials_at", &materials_at, py::arg("grid"), py::arg("materials"), py::arg("points"),
        "Numbers of the materials of the voxels that hold (n, 3) points [mm]; NO_MATERIAL where "
        "there is nothing to remove. Raises InputError naming Materials.");
}

}  // namespace patchmill

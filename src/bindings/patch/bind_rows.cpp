// Rows as another milling order, for Python.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "patchmill/geometry/require.h"
#include "patchmill/patch/division.h"
#include "patchmill/patch/patch_order.h"
#include "patchmill/patch/row_order.h"

namespace patchmill {

void bind_rows(py::module_& m) {
  m.def("milled_patches", &patch::milled_patches, py::arg("dimples"),
        "Numbers of the patches that have dimples to be cut, in milling order. Raises nothing.");
  m.def("from_patch", interruptible(&patch::from_patch), py::arg("dimples"), py::arg("first"),
        "The dimples from patch `first` (1: all) in milling order on. Raises InputError naming "
        "FirstPatch.");
  m.def("up_to_patch", interruptible(&patch::up_to_patch), py::arg("dimples"), py::arg("last"),
        "The dimples up to the last one of patch `last` in milling order. Raises InputError naming "
        "LastPatch.");
  m.def("in_rows",
        interruptible([](const patch::Dimples& dimples, const patch::PatchPattern& pattern,
                         std::size_t direction, bool one_way, bool whole_face) {
          const patch::RowExtent extent =
              whole_face ? patch::RowExtent::WholeFace : patch::RowExtent::EachPatch;
          return patch::in_rows(dimples, patch::lattice_of(pattern.shape),
                                {extent, direction, one_way});
        }),
        py::arg("dimples"), py::arg("pattern"), py::arg("direction"), py::arg("one_way"),
        py::arg("whole_face"),
        "The dimples in rows along one of the lattice's steps, those left out last. On the whole "
        "face the patches become rows. Raises InputError naming RowDirection.");
  m.def(
      "row_directions",
      [](const patch::PatchPattern& pattern) {
        return patch::neighbour_steps(patch::lattice_of(pattern.shape)).size();
      },
      py::arg("pattern"),
      "How many directions rows can have on the pattern's lattice. Raises nothing.");
  m.def(
      "nearest_row_direction",
      [](const patch::PatchPattern& pattern, const Vec2& direction) {
        unit_along("Direction", Vec3(direction.x(), direction.y(), 0.0));  // finite, and not zero
        return patch::nearest_step(patch::lattice_of(pattern.shape), direction);
      },
      py::arg("pattern"), py::arg("direction"),
      "Which of the lattice's steps goes nearest to a direction of the texture plane. Raises "
      "InputError naming Direction.");
  m.def("flattest_row_direction",
        interruptible([](const patch::Dimples& dimples, const patch::PatchPattern& pattern) {
          return patch::flattest_step(dimples, patch::lattice_of(pattern.shape));
        }),
        py::arg("dimples"), py::arg("pattern"),
        "Which of the lattice's steps bends least over the dimples that are to be cut. Raises "
        "nothing.");
}

}  // namespace patchmill

// Arrays of vectors and joints between numpy and the core.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "bindings/bindings.h"
#include "patchmill/geometry/error.h"
#include "patchmill/machine/kinematics.h"

namespace patchmill {

using Points = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// The rows of an (n, 3) array. Errors: InputError naming `name` for another shape.
inline std::vector<Vec3> points_of(const Points& array, const char* name) {
  if (array.ndim() != 2 || array.shape(1) != 3)
    throw InputError(name, std::to_string(array.ndim()) + " dimensions", "give an (n, 3) array.");
  const auto in = array.unchecked<2>();
  std::vector<Vec3> out(static_cast<std::size_t>(in.shape(0)));
  for (py::ssize_t i = 0; i < in.shape(0); ++i)
    out[static_cast<std::size_t>(i)] = Vec3(in(i, 0), in(i, 1), in(i, 2));
  return out;
}

/// (n, 2) array of joints [rad].
inline py::array_t<double> joints_array(const std::vector<machine::Joints>& joints) {
  py::array_t<double> array({static_cast<py::ssize_t>(joints.size()), py::ssize_t{2}});
  auto out = array.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < out.shape(0); ++i)
    for (py::ssize_t k = 0; k < 2; ++k)
      out(i, k) = joints[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
  return array;
}

}  // namespace patchmill

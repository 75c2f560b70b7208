// Dimples from arrays, for Python: of lattices that are laid by a formula of their own.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/arrays.h"
#include "bindings/bindings.h"
#include "patchmill/geometry/require.h"
#include "patchmill/patch/dimple.h"

#include <cmath>

#include <fmt/format.h>

namespace patchmill {
namespace {

constexpr double kFarthest = 1e6;  // mm

void require_alike(std::size_t wanted, std::size_t given, const char* name) {
  if (given != wanted)
    throw InputError(name, std::to_string(given) + " rows", "give one row for each position.");
}

patch::DimpleState state_of(std::uint8_t number) {
  if (number >= patch::kDimpleStates)
    throw InputError("states", std::to_string(number), "give a DimpleState for each position.");
  return static_cast<patch::DimpleState>(number);
}

std::int32_t coordinate(double value) {
  constexpr double kMost = 1e9;
  if (!(std::abs(value) <= kMost) || value != std::round(value))
    throw InputError("lattice", fmt::format("{}", value), "give whole numbers of 1e9 at most.");
  return static_cast<std::int32_t>(value);
}

patch::Dimples dimples_at(const Points& positions, const Points& normals, const Points& lattice,
                          const std::vector<std::int32_t>& patches,
                          const std::vector<std::uint8_t>& states) {
  const std::vector<Vec3> places = points_of(positions, "positions");
  const std::vector<Vec3> directions = points_of(normals, "normals");
  require_alike(places.size(), directions.size(), "normals");
  require_alike(places.size(), patches.size(), "patches");
  require_alike(places.size(), states.size(), "states");
  if (lattice.ndim() != 2 || lattice.shape(1) != 2)
    throw InputError("lattice", std::to_string(lattice.ndim()) + " dimensions",
                     "give an (n, 2) array of whole numbers.");
  require_alike(places.size(), static_cast<std::size_t>(lattice.shape(0)), "lattice");
  const auto points = lattice.unchecked<2>();
  patch::Dimples dimples(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    patch::Dimple& dimple = dimples[i];
    const auto row = static_cast<py::ssize_t>(i);
    if (!(places[i].cwiseAbs().maxCoeff() <= kFarthest))
      throw InputError("positions", fmt::format("row {}", i),
                       "keep within 1e6 mm of the work's zero.");
    if (patches[i] < 0)
      throw InputError("patches", std::to_string(patches[i]), "count patches from 0.");
    dimple.surface = {places[i], unit_along("normals", directions[i])};
    dimple.lattice = {coordinate(points(row, 0)), coordinate(points(row, 1))};
    dimple.patch = patches[i];
    dimple.state = state_of(states[i]);
  }
  return dimples;
}

}  // namespace

void bind_dimples_at(py::module_& m) {
  m.def(
      "dimples_at", &dimples_at, py::arg("positions"), py::arg("normals"), py::arg("lattice"),
      py::arg("patches"), py::arg("states"),
      "Dimples in milling order at (n, 3) positions [mm] with normals of any length out of the "
      "material, (n, 2) whole lattice coordinates, the number of each one's patch, from 0, and its "
      "DimpleState. Raises InputError naming positions, normals, lattice, patches or states.");
}

}  // namespace patchmill

// Explicit diffusion in time; see transient.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/voxel/transient.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/large_vector.h"
#include "patchmill/voxel/brick_halo.h"

#include <cmath>

#include <fmt/format.h>

namespace patchmill::voxel {
namespace {

constexpr double kMostSteps = 1e6;  // each goes over all voxels

// The change of one cell for r = 1, over the axes [first, last].
double balance(const BrickHalo<double>& value, const BrickHalo<CellRole>& role, int at, int first,
               int last) {
  static constexpr int step[3] = {1, BrickHalo<double>::kRow, BrickHalo<double>::kSlab};
  double sum = 0.0;
  for (int axis = first; axis <= last; ++axis)
    for (const int near : {at - step[axis], at + step[axis]})
      if (role.value[near] != CellRole::Outside) sum += value.value[near] - value.value[at];
  return sum;
}

}  // namespace

double stability_limit(DiffusionAxes axes) {
  return axes == DiffusionAxes::All ? 1.0 / 6.0 : 0.5;
}

int transient_steps(DiffusionAxes axes, double pitch, const TransientOptions& options) {
  require_positive("voxel size", pitch, "mm");
  require_positive("diffusion time", options.time, "s");
  require_positive("time step", options.step, "s");
  require_positive("diffusion coefficient", options.diffusivity, "mm2/s");
  const double longest = stability_limit(axes) * pitch * pitch / options.diffusivity;
  double step = options.step;
  if (step > longest * (1.0 + 1e-12)) {
    if (!options.substep)
      throw InputError(
          "time step",
          fmt::format("{} s, r = D dt / dx^2 = {:.4g}", step,
                      options.diffusivity * step / (pitch * pitch)),
          fmt::format("explicit steps are stable up to r = {:.4g}: use at most {:.4g} s, or allow "
                      "sub-steps.",
                      stability_limit(axes), longest));
    step = longest;
  }
  const double count = std::ceil(options.time / step - 1e-9);
  require_in_range("number of time steps", count, 1.0, kMostSteps, "");
  return static_cast<int>(count);
}

void explicit_step(const BrickTable& table, const std::vector<CellRole>& role, DiffusionAxes axes,
                   double r, const std::vector<double>& from, std::vector<double>& to) {
  const int first = axes == DiffusionAxes::All ? 0 : static_cast<int>(axes);
  const int last = axes == DiffusionAxes::All ? 2 : static_cast<int>(axes);
  patchmill::parallel_for(std::size_t{0}, table.size(), [&](std::size_t brick) {
    BrickHalo<double> value;
    BrickHalo<CellRole> kind;
    load_halo(from.data(), table, brick, value);
    load_halo(role.data(), table, brick, kind);
    for (int n = 0; n < kBrickCells; ++n) {
      const int at = BrickHalo<double>::index(n % 8, n / 8 % 8, n / 64);
      const double old = value.value[at];
      to[brick * kBrickCells + n] = kind.value[at] == CellRole::Unknown
                                        ? old + r * balance(value, kind, at, first, last)
                                        : old;
    }
  });
}

int diffuse_transient(const BrickTable& table, const std::vector<CellRole>& role,
                      DiffusionAxes axes, double pitch, const TransientOptions& options,
                      std::vector<double>& field) {
  const int steps = transient_steps(axes, pitch, options);
  const double r = options.diffusivity * options.time / steps / (pitch * pitch);
  auto next = large_vector<double>(field.size(), [](std::size_t) { return 0.0; });
  for (int i = 0; i < steps; ++i) {
    explicit_step(table, role, axes, r, field, next);
    field.swap(next);
  }
  return steps;
}

}  // namespace patchmill::voxel

// Machines of every kind for the kinematics tests, with axes off the work's zero.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/angle.h"
#include "patchmill/machine/kinematics.h"

#include <random>

namespace patchmill::machine {

struct NamedMachine {
  const char* name;
  Kinematics kinematics;
};

inline RotaryAxis axis_of(char letter, AxisSide side, const Vec3& direction, const Vec3& point) {
  RotaryAxis axis;
  axis.letter = letter;
  axis.side = side;
  axis.direction = direction.normalized();
  axis.point = point;
  return axis;
}

inline Kinematics machine_of(const RotaryAxis& first, const RotaryAxis& second) {
  Kinematics k;
  k.rotary = {first, second};
  k.work_zero = {12.0, -7.0, 30.0};
  k.tool_length = 80.0;
  return k;
}

inline std::vector<NamedMachine> machines_of_every_kind() {
  const auto table = AxisSide::Table, head = AxisSide::Head;
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  const Vec3 p(3.0, 40.0, -25.0), q(3.0, 41.5, -60.0), pivot(0.0, 1.0, 150.0);
  return {
      {"table-table A/C", machine_of(axis_of('C', table, z, p), axis_of('A', table, x, q))},
      {"table-table B/C, ISO senses",
       machine_of(axis_of('C', table, -z, p), axis_of('B', table, -y, q))},
      {"table-table A/B", machine_of(axis_of('B', table, y, p), axis_of('A', table, x, q))},
      {"head-head C/A fork",
       machine_of(axis_of('C', head, z, pivot), axis_of('A', head, x, pivot))},
      {"head-head C/B", machine_of(axis_of('C', head, z, pivot), axis_of('B', head, y, pivot))},
      {"head B, table C", machine_of(axis_of('C', table, z, p), axis_of('B', head, y, pivot))},
      {"head B, table A", machine_of(axis_of('A', table, x, p), axis_of('B', head, y, pivot))},
      {"nutating table B 45, C",
       machine_of(axis_of('C', table, z, p), axis_of('B', table, y + z, q))},
      {"nutating head B 45, C head",
       machine_of(axis_of('C', head, z, pivot), axis_of('B', head, y + z, pivot))},
      {"nutating head B 45, table C",
       machine_of(axis_of('C', table, -z, p), axis_of('B', head, x - z, pivot))},
      {"skew axes", machine_of(axis_of('C', table, Vec3(0.1, 0.2, 1.0), p),
                               axis_of('A', head, Vec3(1.0, -0.2, 0.3), pivot))},
  };
}

/// Uniform on the sphere.
inline Vec3 random_axis(std::mt19937& generator) {
  std::normal_distribution<double> normal;
  Vec3 v(normal(generator), normal(generator), normal(generator));
  return v.normalized();
}

}  // namespace patchmill::machine

// Somebody else's program: a height on a mesh, and an error that names its property.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <cstdio>
#include <patchmill/copy/drop_cutter.h>
#include <patchmill/gcode/gcode_reader.h>
#include <patchmill/geometry/error.h>

int main() {
  using namespace patchmill;
  const mesh::TriangleBvh box(mesh::box_mesh({0, 0, 0}, {10, 10, 5}));
  const double height = copy::drop_ball(box, 5.0, 5.0, 2.0);
  std::printf("the ball's centre is at %.3f mm\n", height);
  try {
    gcode::read_gcode("G1 X1 Y1 Q1\n", Tool{1.0, 2});
  } catch (const InputError& error) {
    std::printf("%s\n", error.what());
    return std::abs(height - 7.0) < 1e-9 ? 0 : 1;
  }
  return 1;
}

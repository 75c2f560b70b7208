// Copy milling of a hill with a bull nose end mill, checked for gouges.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <cstdio>
#include <patchmill/collision/clearance.h>
#include <patchmill/collision/mesh_distance.h>
#include <patchmill/copy/copy_milling.h>
#include <patchmill/geometry/error.h>

using namespace patchmill;

namespace {

// A closed solid: the hill z = 5 + 3 cos cos over a square of 40 mm, its sides and its bottom.
mesh::TriangleMesh hill() {
  constexpr int kSteps = 40;
  mesh::TriangleMesh loose;
  const auto top = [](int i, int j) {
    const double x = i * 40.0 / kSteps, y = j * 40.0 / kSteps;
    return Vec3(x, y, 5.0 - 3.0 * std::cos(x * kPi / 20.0) * std::cos(y * kPi / 20.0));
  };
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto n = static_cast<std::int32_t>(loose.vertices.size());
    for (const Vec3& v : {a, b, c}) loose.vertices.push_back(v);
    loose.triangles.push_back({n, n + 1, n + 2});
  };
  const auto wall = [&](const Vec3& a, const Vec3& b) {
    const Vec3 c(a.x(), a.y(), 0), d(b.x(), b.y(), 0);
    add(a, d, c);
    add(a, b, d);
  };
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      add(top(i, j), top(i + 1, j), top(i + 1, j + 1));
      add(top(i, j), top(i + 1, j + 1), top(i, j + 1));
      Vec3 a = top(i, j), b = top(i + 1, j + 1);
      a.z() = b.z() = 0.0;
      add(a, b, {b.x(), a.y(), 0});
      add(a, {a.x(), b.y(), 0}, b);
    }
    wall(top(i + 1, 0), top(i, 0));
    wall(top(i, kSteps), top(i + 1, kSteps));
    wall(top(0, i), top(0, i + 1));
    wall(top(kSteps, i + 1), top(kSteps, i));
  }
  return mesh::weld(loose);
}

int run() {
  const mesh::TriangleMesh part = hill();
  copy::CopyOptions options;
  options.tool = {3.0, 2, 1.0};  // R 3 mm, two flutes, corners of 1 mm
  options.spindle.speed = 100.0;
  options.feed = 10.0;
  options.radial_depth = 2.0;
  options.axial_depth = 4.0;
  options.tolerance = 0.01;
  options.stock = mesh::bounds(part);
  const ToolPath path = copy::copy_mill(mesh::TriangleBvh(part), options).path;
  collision::ClearanceOptions limits;
  limits.tolerance = 0.02;
  limits.resolution = 0.005;
  const auto found = collision::check_clearance(path, collision::shape_from_mesh(part), limits);
  std::printf("%zu moves, %.0f mm cut; ridges of %.3f mm on a flat; %s\n", path.moves.size(),
              statistics(path).cut_length, scallop_height(options.tool, options.radial_depth),
              found.outcome == collision::ClearanceOutcome::Clear ? "no gouge" : "gouges");
  return found.outcome == collision::ClearanceOutcome::Clear ? 0 : 1;
}

}  // namespace

int main() {
  try {
    return run();
  } catch (const InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

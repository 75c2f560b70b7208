// The reliefs shown in docs/cutter-marks.md, as raw float32 with a header line: name rows columns
// step x y. Built and run by cutter_marks.py.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patch/table1_surface.h"
#include "patchmill/marks/alignment.h"
#include "patchmill/marks/dimple_marks.h"
#include "patchmill/marks/simulate.h"
#include "patchmill/sync/constant_feed.h"
#include "patchmill/sync/contact_azimuth.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

using namespace patchmill;

namespace {

const std::string* folder = nullptr;

void write(const std::string& name, const marks::Relief& relief) {
  std::ofstream out(*folder + "/" + name + ".relief", std::ios::binary);
  out << name << ' ' << relief.grid.rows << ' ' << relief.grid.columns << ' ' << relief.grid.step
      << ' ' << relief.grid.first.x() << ' ' << relief.grid.first.y() << '\n';
  out.write(reinterpret_cast<const char*>(relief.height.data()),
            static_cast<std::streamsize>(relief.height.size() * sizeof(float)));
}

/// Straight rows with a two-flute mill, R = 1, f = 0.5; row j + 1 shifted against row j.
template <class Shift>
ToolPath rows(double cross_feed, Shift&& shift) {
  const int marks = 13, count = static_cast<int>(6.6 / cross_feed);
  const Vec3 axis = Vec3(0, 1, 1).normalized();
  ToolPath path;
  path.tool = {1.0, 2};
  path.spindle = {20.0, SpindleSense::M3};
  const auto pose = [&](double x, int j, double z) {
    return pose_of_ball({x, j * cross_feed, z + 1.0}, axis, 1.0);
  };
  const double x0 = -0.6, x1 = x0 + 0.5 * marks;
  path.start = pose(x0, 0, 0.0);
  for (int j = 0; j < count; ++j) {
    if (j > 0) {
      path.moves.push_back({pose(x1, j - 1, 0.5), 1.0, kNoDimple, MoveKind::Link});
      path.moves.push_back({pose(x0, j, 0.5), 2.0 - 0.5 * shift(j - 1), kNoDimple, MoveKind::Link});
      path.moves.push_back({pose(x0, j, 0.0), 1.0, kNoDimple, MoveKind::Link});
    }
    path.moves.push_back({pose(x1, j, 0.0), 0.5 * marks, kNoDimple, MoveKind::Cut});
  }
  return path;
}

template <class Shift>
void array(const std::string& name_of_it, double cross_feed, Shift&& shift,
           std::vector<double> runout = {}) {
  const ToolPath path = rows(cross_feed, shift);
  const marks::SurfaceGrid grid =
      marks::flat_grid(patch::TexturePlane{}, {0.0, 0.0}, {5.5, 5.5}, 0.01);
  const marks::Relief relief =
      marks::simulate_marks(marks::motion_of(path), {path.tool, {}, runout}, grid, {0.08}).relief;
  std::vector<Vec2> places;
  for (const marks::DimpleMark& mark : marks::find_dimples(relief))
    if (!mark.at_edge) places.push_back(mark.place);
  const marks::AlignmentResult result =
      marks::classify_alignment(places, {Vec2::UnitX(), 0.5, cross_feed});
  std::printf("%s: %zu dimples, %s, shift %.3f, agreement %.3f\n", name_of_it.c_str(),
              places.size(), name(result.state), result.shift, result.agreement);
  write(name_of_it, relief);
}

/// A corner of the experiment of Xu & Sasahara 2016: Tables 1 and 2, constant feed, vertical tool.
void experiment() {
  patch::Dimples dimples = patch::table1_dimples(14, 8, 8);
  sync::mark_tool_tip(dimples, Vec3::UnitZ(), Angle::degrees(1));
  const Tool tool{1.0, 2};
  const Spindle spindle{1000.0 / 60.0, SpindleSense::M3};
  const sync::ConstantFeed rule{434.413 / 60.0, {sync::FluteChoice::Same, 5.0, {}}, 40.0, 42.0};
  marks::MotionOptions options;
  options.wanted_phase = sync::wanted_phases(dimples, rule.phase, spindle);
  const marks::ToolMotion motion = marks::motion_of(
      sync::constant_feed_path(dimples, tool, spindle, rule, Decimals(3)), options);
  const patch::SurfaceSampler sampler = [](const std::vector<Vec2>& places) {
    std::vector<patch::SurfaceSample> samples;
    for (const Vec2& p : places)
      samples.push_back({patch::table1_point(p.x(), p.y()), patch::DimpleState::Cut});
    return samples;
  };
  const marks::SurfaceGrid grid = marks::curved_grid(
      marks::flat_grid(patch::TexturePlane{}, {-13.0, -13.0}, {-6.0, -6.0}, 0.0175), sampler);
  write("experiment", marks::simulate_marks(motion, {tool, {}, {}}, grid, {0.08}).relief);
}

}  // namespace

int main(int, char** arguments) {
  const std::string to = arguments[1];
  folder = &to;
  experiment();
  array("square", 0.5, [](int) { return 0.0; });
  array("staggered", 0.5, [](int) { return 0.5; });
  array("drifting", 0.5, [](int j) { return 0.06 * j; });
  array("runout", 0.5, [](int) { return 0.0; }, {0.0, -0.005});
}

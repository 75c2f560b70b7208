// Paths for the simulator's tests: a one-flute mill that makes one mark at each of some places of
// the plane z = 0 and moves on while its flute is away.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/marks/simulate.h"

#include <cmath>

namespace patchmill::test {

/// Unit tool axis, tilted from the plane's normal by `tilt` towards azimuth `towards` [rad].
inline Vec3 tilted_axis(double tilt, double towards) {
  return {std::sin(tilt) * std::cos(towards), std::sin(tilt) * std::sin(towards), std::cos(tilt)};
}

struct MarkMaker {
  Tool ball{1.0, 1};
  Spindle spindle{10.0, SpindleSense::M3};
  Vec3 axis = tilted_axis(kPi / 6, 0.3);
  Vec3 creep = Vec3::Zero();  ///< motion of the ball while it makes a mark [mm per turn]
  double height = 0.0;        ///< of the marks' bottoms over the plane

  /// Half a turn about each place at `creep`, the other half to the next place.
  ToolPath path(const std::vector<Vec2>& places) const {
    ToolPath out;
    out.tool = ball;
    out.spindle = spindle;
    const auto pose = [&](const Vec2& p, double turns) {
      const Vec3 centre(p.x(), p.y(), height + ball.radius);
      return pose_of_ball(centre + turns * creep, axis, ball.radius);
    };
    out.start = pose(places.front(), -0.25);
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (k > 0) out.moves.push_back({pose(places[k], -0.25), 0.5, kNoDimple, MoveKind::Link});
      out.moves.push_back({pose(places[k], 0.0), 0.25, static_cast<int>(k), MoveKind::Cut});
      out.moves.push_back({pose(places[k], 0.25), 0.25, kNoDimple, MoveKind::Cut});
    }
    return out;
  }

  /// Flute 0 at the contact point at every dimple: azimuth of -n about the axis.
  marks::MotionOptions locked(std::size_t dimples) const {
    marks::MotionOptions options;
    const Vec3 x = marks::default_housing_x(axis), y = axis.cross(x);
    const Angle at = Angle::radians(std::atan2(-y.z(), -x.z()));
    options.wanted_phase.assign(dimples, at);
    return options;
  }
};

inline patch::TexturePlane plane_z0() {
  patch::TexturePlane plane;
  plane.direction = -Vec3::UnitZ();
  return plane;
}

/// Rows of `columns` places a distance f apart, rows p apart, row j shifted by shift(j) * f.
template <class Shift>
std::vector<Vec2> rows_of_places(int columns, int rows, double f, double p, Shift&& shift) {
  std::vector<Vec2> places;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) places.push_back({(i + shift(j)) * f, j * p});
  return places;
}

inline marks::SimulatedRelief mark(const MarkMaker& maker, const std::vector<Vec2>& places,
                                   const marks::SurfaceGrid& grid, double stock) {
  const ToolPath path = maker.path(places);
  return marks::simulate_marks(marks::motion_of(path, maker.locked(places.size())),
                               {path.tool, {}, {}}, grid, {stock});
}

}  // namespace patchmill::test

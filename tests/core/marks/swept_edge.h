// A slow, independent reference for the simulator: the edges are stepped through time, the surface
// that each of them sweeps is cut into triangles, and every grid point takes the lowest triangle
// above or below it. Shares nothing with the simulator but the grid.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/marks/relief.h"

#include <cmath>
#include <functional>
#include <vector>

namespace patchmill::test {

/// Tool at one moment.
struct ToolAt {
  Vec3 tip, axis, housing_x;
  double spindle;  ///< azimuth of flute 0 [rad]
};

struct SweptEdge {
  double radius = 1.0;
  int flutes = 2;
  double sense = -1.0, helix = 0.0;  // tan(helix) / R [rad/mm]
  std::vector<double> runout;
  int time_steps = 1000, edge_steps = 60;

  /// Point of a flute's edge at angle kappa from the tip.
  Vec3 edge(const ToolAt& tool, int flute, double kappa) const {
    const double r = radius + (runout.empty() ? 0.0 : runout[static_cast<std::size_t>(flute)]);
    const double up = radius - r * std::cos(kappa);  // above the tip
    const double azimuth =
        tool.spindle + 2.0 * 3.14159265358979323846 * flute / flutes - sense * helix * up;
    const Vec3 y = tool.axis.cross(tool.housing_x);
    return tool.tip + up * tool.axis +
           r * std::sin(kappa) * (std::cos(azimuth) * tool.housing_x + std::sin(azimuth) * y);
  }

  /// Lowers `height` of a flat grid at z = 0 by the sweep of all flutes from time 0 to 1.
  void mill(const std::function<ToolAt(double)>& motion, double most_kappa,
            marks::Relief& relief) const {
    std::vector<Vec3> before, now;
    for (int flute = 0; flute < flutes; ++flute)
      for (int i = 0; i <= time_steps; ++i) {
        const ToolAt tool = motion(static_cast<double>(i) / time_steps);
        now.clear();
        // closer together towards the tip, where the sweep is most twisted
        for (int k = 0; k <= edge_steps; ++k)
          now.push_back(edge(tool, flute, most_kappa * k * k / (edge_steps * edge_steps)));
        if (i > 0)
          for (std::size_t k = 1; k < now.size(); ++k) {
            triangle(before[k - 1], before[k], now[k - 1], relief);
            triangle(now[k - 1], before[k], now[k], relief);
          }
        before.swap(now);
      }
  }

 private:
  static void triangle(const Vec3& a, const Vec3& b, const Vec3& c, marks::Relief& relief) {
    if (std::min({a.z(), b.z(), c.z()}) > relief.stock) return;
    const marks::SurfaceGrid& grid = relief.grid;
    const Vec3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    const auto index = [&](double x, int axis) { return (x - grid.first[axis]) / grid.step; };
    const double area = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
    if (area == 0.0) return;
    for (int j = std::max(0, int(std::ceil(index(low.y(), 1))));
         j <= std::min(grid.rows - 1, int(std::floor(index(high.y(), 1)))); ++j)
      for (int i = std::max(0, int(std::ceil(index(low.x(), 0))));
           i <= std::min(grid.columns - 1, int(std::floor(index(high.x(), 0)))); ++i) {
        const Vec2 p = grid.plane_point(i, j);
        const double v =
            ((p.x() - a.x()) * (c.y() - a.y()) - (p.y() - a.y()) * (c.x() - a.x())) / area;
        const double w =
            ((b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x())) / area;
        if (v < -1e-9 || w < -1e-9 || v + w > 1.0 + 1e-9) continue;
        float& h = relief.height[static_cast<std::size_t>(grid.number(i, j))];
        h = std::min(h, static_cast<float>(a.z() + v * (b.z() - a.z()) + w * (c.z() - a.z())));
      }
  }
};

}  // namespace patchmill::test

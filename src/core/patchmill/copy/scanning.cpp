// Probe profiles, layers and offset sections in a plane; see scanning.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/copy/scanning.h"

#include "patchmill/copy/tool_drop.h"

#include <algorithm>
#include <cmath>

namespace patchmill::copy {
namespace {

double ball_radius(const CopyOptions& options) {
  return options.tool.radius + options.allowance;
}

// Chords of an arc of radius R leave it by the tolerance at this step.
double chord_step(const CopyOptions& options) {
  return std::sqrt(8.0 * options.tool.radius * options.tolerance);
}

struct Probe {
  ToolProbe drop;
  double y, floor, tolerance;

  Vec2 operator()(double x) {
    // the probe is thicker by the allowance; its centre is that of the tool
    return {x, std::max(floor, drop(x, y))};
  }

  // Points after `a` up to and with `b`. Two places inside must lie on the chord.
  void refine(const Vec2& a, const Vec2& b, std::vector<Vec2>& out) {
    const double width = b.x() - a.x();
    if (width > 0.5 * tolerance) {
      const Vec2 p = (*this)(a.x() + 0.4 * width), q = (*this)(a.x() + 0.7 * width);
      const double off_p = std::abs(p.y() - (a.y() + 0.4 * (b.y() - a.y())));
      const double off_q = std::abs(q.y() - (a.y() + 0.7 * (b.y() - a.y())));
      if (std::max(off_p, off_q) > 0.8 * tolerance) {
        const Vec2 mid = (*this)(a.x() + 0.5 * width);
        refine(a, mid, out);
        refine(mid, b, out);
        return;
      }
    }
    out.push_back(b);
  }
};

Vec2 at_height(const Vec2& a, const Vec2& b, double z) {
  return {a.x() + (b.x() - a.x()) * (z - a.y()) / (b.y() - a.y()), z};
}

}  // namespace

std::vector<Vec2> probe_profile(const mesh::TriangleBvh& part, double y, double x0, double x1,
                                double floor, const CopyOptions& options) {
  Probe probe{ToolProbe(part, options.tool, options.allowance), y, floor, options.tolerance};
  const int steps = std::max(1, static_cast<int>(std::ceil((x1 - x0) / chord_step(options))));
  std::vector<Vec2> profile{probe(x0)};
  for (int i = 1; i <= steps; ++i)
    probe.refine(Vec2(profile.back()), probe(x0 + (x1 - x0) * i / steps), profile);
  return profile;
}

std::vector<std::vector<Vec2>> layer_of(const std::vector<Vec2>& profile, double above,
                                        double level) {
  std::vector<std::vector<Vec2>> runs;
  const auto add = [&](const Vec2& p) {
    auto& run = runs.back();
    const Vec2 q(p.x(), std::max(p.y(), level));
    // neighbours on the level are one straight cut
    const std::size_t n = run.size();
    if (n > 1 && run[n - 2].y() == level && run[n - 1].y() == level && q.y() == level)
      run.back() = q;
    else
      run.push_back(q);
  };
  bool open = false;
  for (std::size_t i = 1; i < profile.size(); ++i) {
    const Vec2 &a = profile[i - 1], &b = profile[i];
    const bool in_a = a.y() < above, in_b = b.y() < above;
    if (!in_a && !in_b) continue;
    if (!open) {
      runs.emplace_back();
      add(in_a ? a : at_height(a, b, above));
    }
    if ((a.y() < level) != (b.y() < level)) add(at_height(a, b, level));
    add(in_b ? b : at_height(a, b, above));
    open = in_b;
  }
  return runs;
}

std::vector<Polyline> offset_section(const mesh::TriangleBvh& part, double y,
                                     const CopyOptions& options) {
  const double radius = ball_radius(options), margin = 2.0 * radius;
  const mesh::BvhNode& all = part.nodes()[0];
  const PlanarGrid grid =
      planar_grid({all.lo.x() - margin, all.lo.z() - margin},
                  {all.hi.x() + margin, all.hi.z() + margin}, 0.7 * chord_step(options));
  const auto distance = [&](const Vec2& p) {
    const Vec3 c(p.x(), y, p.y());
    return mesh::inside(part, c) ? -1.0 : mesh::closest_point(part, c).distance - radius;
  };
  return level_curves(grid, distance, 0.1 * options.tolerance);
}

std::vector<std::vector<Vec2>> free_intervals(const std::vector<Polyline>& section, double height,
                                              double x0, double x1) {
  std::vector<double> cross;
  for (const Polyline& curve : section) {
    const std::size_t n = curve.points.size();
    for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i) {
      const Vec2 &a = curve.points[i], &b = curve.points[(i + 1) % n];
      if ((a.y() < height) != (b.y() < height)) cross.push_back(at_height(a, b, height).x());
    }
  }
  std::sort(cross.begin(), cross.end());
  std::vector<std::vector<Vec2>> free;
  double from = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i <= cross.size(); i += 2) {
    const double to = i < cross.size() ? cross[i] : std::numeric_limits<double>::infinity();
    const double a = std::max(from, x0), b = std::min(to, x1);
    if (b > a) free.push_back({Vec2(a, height), Vec2(b, height)});
    if (i + 1 < cross.size()) from = cross[i + 1];
  }
  return free;
}

}  // namespace patchmill::copy

// Contours of the ball's height and the curves around them; see contouring.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/copy/contouring.h"

#include "patchmill/copy/tool_drop.h"

#include <cmath>

#include <tbb/enumerable_thread_specific.h>

namespace patchmill::copy {
namespace {

// As far beyond the stock as the tool, with its flank up to the stock's top, may be kept away.
PlanarGrid level_grid(const CopyOptions& options, double pitch) {
  const double flank = options.stock.size().z() * std::tan(options.tool.taper.radians());
  const Vec2 reach = Vec2::Constant(2.0 * options.tool.radius + options.allowance + flank);
  return planar_grid(options.stock.lo.head<2>() - reach, options.stock.hi.head<2>() + reach, pitch);
}

double chord_step(const CopyOptions& options) {
  return 0.7 * std::sqrt(8.0 * options.tool.radius * options.tolerance);
}

// The segments of curves as triangles of no width, so that the tree finds the nearest one.
mesh::TriangleMesh ribbons(const std::vector<Polyline>& curves) {
  mesh::TriangleMesh mesh;
  for (const Polyline& curve : curves) {
    const auto first = static_cast<std::int32_t>(mesh.vertices.size());
    const auto n = static_cast<std::int32_t>(curve.points.size());
    for (const Vec2& p : curve.points) mesh.vertices.emplace_back(p.x(), p.y(), 0.0);
    for (std::int32_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i)
      mesh.triangles.push_back({first + i, first + (i + 1) % n, first + (i + 1) % n});
  }
  return mesh;
}

// The runs of a curve that lie over the stock, a little beyond its edge.
void clip_to_stock(const Polyline& curve, const mesh::Box& stock, double beyond,
                   std::vector<Polyline>& out) {
  const auto over = [&](const Vec2& p) {
    return (p.array() >= stock.lo.head<2>().array() - beyond).all() &&
           (p.array() <= stock.hi.head<2>().array() + beyond).all();
  };
  const std::size_t n = curve.points.size();
  std::size_t start = 0;  // begin where a run begins, so that none is cut in two at the seam
  while (start < n && over(curve.points[start])) ++start;
  if (start == n) {
    out.push_back(curve);
    return;
  }
  if (!curve.closed) start = 0;
  Polyline run;
  for (std::size_t i = 0; i <= n; ++i) {
    const bool last = i == n;
    const Vec2& p = curve.points[(start + i) % n];
    if (!last && over(p)) {
      run.points.push_back(p);
      continue;
    }
    if (run.points.size() > 1) out.push_back(run);
    run.points.clear();
  }
}

// A probe for each thread; places that follow each other are near.
using Probes = tbb::enumerable_thread_specific<ToolProbe>;

Probes probes(const mesh::TriangleBvh& part, const CopyOptions& options) {
  return Probes(ToolProbe(part, options.tool, options.allowance));
}

}  // namespace

std::vector<Polyline> ball_contours(const mesh::TriangleBvh& part, double z,
                                    const CopyOptions& options) {
  Probes probe = probes(part, options);
  const auto height = [&](const Vec2& p) { return z - probe.local()(p.x(), p.y()); };
  // free where positive: the part on the left of curves with f < 0 there; turned round below
  std::vector<Polyline> curves =
      level_curves(level_grid(options, chord_step(options)), height, 0.1 * options.tolerance);
  for (Polyline& curve : curves) std::reverse(curve.points.begin(), curve.points.end());
  return curves;
}

std::vector<Polyline> around_contours(const std::vector<Polyline>& contours,
                                      const mesh::TriangleBvh& part, double z, double distance,
                                      const CopyOptions& options) {
  const mesh::TriangleMesh mesh = ribbons(contours);
  if (mesh.triangles.empty()) return {};
  const mesh::TriangleBvh tree(mesh);
  Probes probe = probes(part, options);
  const auto beyond = [&](const Vec2& p) {
    const double d = mesh::closest_point(tree, Vec3(p.x(), p.y(), 0.0)).distance;
    return probe.local()(p.x(), p.y()) > z ? -distance - d : d - distance;
  };
  std::vector<Polyline> inside;
  for (Polyline& curve : level_curves(level_grid(options, 2.0 * chord_step(options)), beyond,
                                      0.1 * options.tolerance)) {
    std::reverse(curve.points.begin(), curve.points.end());
    clip_to_stock(curve, options.stock, 0.5 * options.radial_depth, inside);
  }
  return inside;
}

}  // namespace patchmill::copy

// Layers and passes of copy milling; see copy_milling.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/copy/copy_milling.h"

#include "patchmill/copy/contouring.h"
#include "patchmill/copy/drop_probe.h"
#include "patchmill/copy/path_builder.h"
#include "patchmill/copy/scanning.h"
#include "patchmill/copy/tool_drop.h"
#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace patchmill::copy {

// mm. Lines go a radius over the part's edges, so that the work grows with it without an end.
constexpr double kLargestRadius = 1e4;

void require_valid(const CopyOptions& o) {
  require_positive("tool radius", o.tool.radius, "mm");
  require_in_range("tool radius", o.tool.radius, 0.0, kLargestRadius, "mm");
  require_valid(o.tool);
  if (o.mode == CopyMode::ScanningUndercut) require_ball(o.tool, "undercuts are scanned");
  require_positive("spindle speed", o.spindle.speed, "1/s");
  require_positive("feed", o.feed, "mm/s");
  require_positive("radial depth of cut", o.radial_depth, "mm");
  require_positive("axial depth of cut", o.axial_depth, "mm");
  require_positive("clearance", o.clearance, "mm");
  require_in_range("tolerance", o.tolerance, 1e-4, o.tool.radius, "mm");
  require_in_range("overlap", o.overlap, 0.0, o.tool.radius, "mm");
  require_in_range("allowance", o.allowance, 0.0, 1e3, "mm");
  if (!((o.stock.size().array() > 0.0).all() && o.stock.size().allFinite()))
    throw InputError("stock", "no volume", "give a stock with length, width and height.");
  const double passes = o.stock.size().y() / o.radial_depth,
               layers = o.stock.size().z() / o.axial_depth;
  if (passes * layers > 1e7)
    throw InputError("depth of cut",
                     fmt::format("{} mm radial, {} mm axial", o.radial_depth, o.axial_depth),
                     "enlarge it: there would be more than ten million passes.");
}

namespace {

// Levels of the tool's centre: one axial depth below the top, and so on down to the tip at the
// bottom.
std::vector<double> levels(const CopyOptions& o) {
  const double top = o.stock.hi.z() + o.tool.corner(), bottom = o.stock.lo.z() + o.tool.corner();
  std::vector<double> z;
  for (int k = 1; top - k * o.axial_depth > bottom + 1e-9; ++k)
    z.push_back(top - k * o.axial_depth);
  z.push_back(bottom);
  return z;
}

// Planes from one edge of the stock to the other and the overlap, at most the radial depth apart.
std::vector<double> planes(const CopyOptions& o) {
  const double width = o.stock.size().y();
  const int n = std::max(1, static_cast<int>(std::ceil(width / o.radial_depth - 1e-9)));
  std::vector<double> y;
  const int beyond = static_cast<int>(std::ceil(o.overlap / o.radial_depth - 1e-9));
  for (int j = beyond; j > 0; --j) y.push_back(o.stock.lo.y() - o.overlap * j / beyond);
  for (int j = 0; j <= n; ++j) y.push_back(o.stock.lo.y() + width * j / n);
  for (int j = 1; j <= beyond; ++j) y.push_back(o.stock.hi.y() + o.overlap * j / beyond);
  return y;
}

using Runs = std::vector<std::vector<Vec2>>;

// Every other plane is cut backwards, so that the tool goes to and fro.
void cut_runs(const Runs& runs, double y, bool backwards, PathBuilder& builder) {
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto& run = runs[backwards ? runs.size() - 1 - r : r];
    std::vector<Vec3> centres;
    for (const Vec2& p : run) centres.emplace_back(p.x(), y, p.y());
    if (backwards) std::reverse(centres.begin(), centres.end());
    builder.cut(centres);
  }
}

CopiedPath scan(const mesh::TriangleBvh& part, const CopyOptions& o, const Progress& progress) {
  PathBuilder builder(o);
  const std::vector<double> level = levels(o), y = planes(o);
  const double x0 = o.stock.lo.x() - o.tool.radius, x1 = o.stock.hi.x() + o.tool.radius;
  // planes side by side, asked to stop between blocks of them; probing is most of the work
  constexpr std::size_t kBlock = 32;
  std::vector<std::vector<Vec2>> profile(y.size());
  for (std::size_t first = 0; first < y.size(); first += kBlock) {
    if (!go_on(progress, 0.9 * double(first) / double(y.size()))) return builder.finish();
    patchmill::parallel_for(first, std::min(first + kBlock, y.size()), [&](std::size_t j) {
      profile[j] = probe_profile(part, y[j], x0, x1, level.back(), o);
    });
  }
  double above = o.stock.hi.z() + o.tool.corner();
  for (std::size_t k = 0; k < level.size(); ++k) {
    if (!go_on(progress, 0.9 + 0.1 * double(k) / double(level.size()))) break;
    for (std::size_t j = 0; j < y.size(); ++j)
      cut_runs(layer_of(profile[j], above, level[k]), y[j], j % 2 == 1, builder);
    above = level[k];
  }
  return builder.finish();
}

// The runs of a section that a cutter can follow: over the stock and not below its bottom.
Runs usable(const std::vector<Polyline>& section, double bottom, double x0, double x1) {
  Runs runs;
  for (const Polyline& curve : section) {
    const auto good = [&](const Vec2& p) { return p.y() >= bottom && p.x() >= x0 && p.x() <= x1; };
    const std::size_t n = curve.points.size();
    std::size_t start = 0;
    while (curve.closed && start < n && good(curve.points[start])) ++start;
    if (start == n) start = 0;
    std::vector<Vec2> run;
    for (std::size_t i = 0; i < n + (curve.closed ? 1 : 0); ++i) {
      const Vec2& p = curve.points[(start + i) % n];
      if (good(p)) run.push_back(p);
      if (!good(p) && run.size() > 1) runs.push_back(run);
      if (!good(p)) run.clear();
    }
    if (run.size() > 1) runs.push_back(run);
  }
  // the section has the part on its left: reversed, it runs over the part towards +x
  for (auto& run : runs) std::reverse(run.begin(), run.end());
  return runs;
}

// Points are inserted so that none is further than `step` from the next.
Runs refined(Runs runs, double step) {
  for (auto& run : runs) {
    std::vector<Vec2> fine{run.front()};
    for (std::size_t i = 1; i < run.size(); ++i) {
      const Vec2 a = run[i - 1], b = run[i];
      const int n = std::max(1, static_cast<int>(std::ceil((b - a).norm() / step)));
      for (int k = 1; k <= n; ++k) fine.push_back(a + (b - a) * k / n);
    }
    run = std::move(fine);
  }
  return runs;
}

CopiedPath scan_undercut(const mesh::TriangleBvh& part, const CopyOptions& o,
                         const Progress& progress) {
  DropProbe probe(part, o.tool.radius + o.allowance);
  PathBuilder builder(
      o, [&](const Vec3& c) { return probe(c.x(), c.y()) <= c.z() + 0.5 * o.tolerance; });
  const std::vector<double> level = levels(o), y = planes(o);
  const double x0 = o.stock.lo.x() - o.tool.radius, x1 = o.stock.hi.x() + o.tool.radius;
  std::vector<std::vector<Polyline>> section;
  for (std::size_t j = 0; j < y.size(); ++j) {
    if (!go_on(progress, 0.9 * double(j) / double(y.size()))) return builder.finish();
    section.push_back(offset_section(part, y[j], o));
  }
  for (const double z : level)
    for (std::size_t j = 0; j < y.size(); ++j)
      cut_runs(refined(free_intervals(section[j], z, x0, x1), o.tool.radius), y[j], j % 2 == 1,
               builder);
  for (std::size_t j = 0; j < y.size(); ++j)
    cut_runs(usable(section[j], level.back(), x0, x1), y[j], j % 2 == 1, builder);
  return builder.finish();
}

void cut_curve(const Polyline& curve, double z, PathBuilder& builder) {
  std::vector<Vec3> centres;
  for (const Vec2& p : curve.points) centres.emplace_back(p.x(), p.y(), z);
  if (curve.closed && !centres.empty()) centres.push_back(Vec3(centres.front()));
  builder.cut(centres);
}

CopiedPath contour(const mesh::TriangleBvh& part, const CopyOptions& o, const Progress& progress) {
  PathBuilder builder(o);
  const std::vector<double> level = levels(o), y = planes(o);
  for (std::size_t k = 0; k < level.size(); ++k) {
    if (!go_on(progress, double(k) / double(level.size()))) break;
    const std::vector<Polyline> inner = ball_contours(part, level[k], o);
    if (inner.empty()) {  // all of the level is free: straight lines; or nothing of it is
      const Vec3 middle = 0.5 * (o.stock.lo + o.stock.hi);
      if (drop_tool(part, middle.x(), middle.y(), o.tool, o.allowance) > level[k]) continue;
      for (std::size_t j = 0; j < y.size(); ++j)
        cut_runs({{{o.stock.lo.x(), level[k]}, {o.stock.hi.x(), level[k]}}}, y[j], j % 2 == 1,
                 builder);
      continue;
    }
    std::vector<std::vector<Polyline>> rings{inner};
    for (int m = 1; !rings.back().empty() && m < 100000; ++m)
      rings.push_back(around_contours(inner, part, level[k], m * o.radial_depth, o));
    for (std::size_t m = rings.size(); m-- > 0;)
      for (const Polyline& curve : rings[m]) cut_curve(curve, level[k], builder);
  }
  return builder.finish();
}

}  // namespace

CopiedPath copy_mill(const mesh::TriangleBvh& part, const CopyOptions& options,
                     const Progress& progress) {
  require_valid(options);
  if (options.mode == CopyMode::Contour) return contour(part, options, progress);
  if (options.mode == CopyMode::ScanningUndercut) return scan_undercut(part, options, progress);
  return scan(part, options, progress);
}

}  // namespace patchmill::copy

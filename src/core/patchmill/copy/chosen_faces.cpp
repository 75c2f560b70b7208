// Clipping of a path to chosen faces; see chosen_faces.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/copy/chosen_faces.h"

#include "patchmill/copy/path_builder.h"
#include "patchmill/copy/tool_drop.h"
#include "patchmill/geometry/stop.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace patchmill::copy {
namespace {

// Cosine of how far the ball rolls over an edge of the faces: as far as scanning lines go beyond the stock.
constexpr double kOverEdge = 0.5;

using Centres = std::vector<Vec3>;

// Asked along one cut.
struct WorksOn {
  ToolProbe drop;  // on the part
  const mesh::TriangleBvh& faces;
  double radius, tolerance;
  std::optional<ToolProbe> rests = {};  // on the faces: of a cutter that is no ball

  bool touches(const Vec3& centre) {
    if (rests) return (*rests)(centre.x(), centre.y()) >= centre.z() - tolerance;
    return mesh::is_over(faces, centre, radius + tolerance, kOverEdge);
  }

  bool operator()(const Vec3& centre) {
    const double rest = drop(centre.x(), centre.y());
    const bool over = rest > kNoContact && rest <= centre.z() + tolerance;  // not beside a wall
    return (over && touches({centre.x(), centre.y(), rest})) || touches(centre);
  }
};

// The place between `kept` and `lost` where the ball leaves the faces, on the side that is kept.
Vec3 limit_between(Vec3 kept, Vec3 lost, WorksOn& works) {
  while ((lost - kept).norm() > works.tolerance) {
    const Vec3 middle = 0.5 * (kept + lost);
    (works(middle) ? kept : lost) = middle;
  }
  return kept;
}

// The stretches of a cut on which the ball works on the faces.
std::vector<Centres> kept_of(const Centres& cut, WorksOn works) {
  std::vector<Centres> out;
  Vec3 at = cut.front();
  bool on = works(at);
  if (on) out.push_back({at});
  for (std::size_t i = 1; i < cut.size(); ++i) {
    const Vec3 a = cut[i - 1], b = cut[i];
    const int n = std::max(1, static_cast<int>(std::ceil((b - a).norm() / (0.25 * works.radius))));
    for (int k = 1; k <= n; ++k) {
      const Vec3 next = k == n ? b : Vec3(a + (b - a) * k / n);
      const bool now = works(next);
      if (now && !on) out.push_back({limit_between(next, at, works)});
      if (on && !now) out.back().push_back(limit_between(at, next, works));
      if (now && k == n) out.back().push_back(next);
      on = now;
      at = next;
    }
  }
  return out;
}

// The cuts of a path as polylines of ball centres.
std::vector<Centres> cuts_of(const ToolPath& path) {
  std::vector<Centres> cuts;
  Vec3 from = centre_of(path.start, path.tool);
  bool cutting = false;
  for (const Move& move : path.moves) {
    const Vec3 to = centre_of(move.end, path.tool);
    const bool cut = move.kind == MoveKind::Cut;
    if (cut && !cutting) cuts.push_back({from});
    if (cut) cuts.back().push_back(to);
    cutting = cut;
    from = to;
  }
  return cuts;
}

}  // namespace

ToolPath over_faces(const ToolPath& path, const mesh::TriangleBvh& part,
                    const mesh::TriangleBvh& faces, const CopyOptions& options,
                    const Progress& progress) {
  require_valid(options);
  const double radius = options.tool.radius + options.allowance;
  WorksOn works{ToolProbe(part, options.tool, options.allowance), faces, radius, options.tolerance};
  if (!options.tool.is_ball()) works.rests.emplace(faces, options.tool, options.allowance);
  const std::vector<Centres> cuts = cuts_of(path);
  PathBuilder builder(options);
  constexpr std::size_t kBlock = 64;  // cuts side by side, asked to stop between blocks of them
  for (std::size_t first = 0; first < cuts.size(); first += kBlock) {
    if (!go_on(progress, double(first) / double(cuts.size()))) break;
    const std::size_t last = std::min(first + kBlock, cuts.size());
    std::vector<std::vector<Centres>> kept(last - first);
    patchmill::parallel_for(first, last,
                            [&](std::size_t i) { kept[i - first] = kept_of(cuts[i], works); });
    for (const auto& pieces : kept)
      for (const Centres& piece : pieces) builder.cut(piece);
  }
  return builder.finish().path;
}

}  // namespace patchmill::copy

// Chebyshev nets on sampled surfaces; see surface_lattice.h. The two threads through the start are
// laid first, then the meshes between them by rows of equal distance from the start: each new node
// is where spheres of radius f about its two elder neighbours meet the surface.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/geometry/error.h"
#include "patchmill/patch/surface_lattice.h"
#include "patchmill/patch/surface_walk.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace patchmill::patch {
namespace {

// Nodes by lattice point, over the range that the threads reach.
class Net {
 public:
  Net(const LatticePoint& first, const LatticePoint& last)
      : first_(first),
        last_(last),
        columns_(last[0] - first[0] + 1),
        nodes_(std::size_t(columns_) * std::size_t(last[1] - first[1] + 1)),
        laid_(nodes_.size(), false) {}

  bool laid(const LatticePoint& p) const {
    return p[0] >= first_[0] && p[0] <= last_[0] && p[1] >= first_[1] && p[1] <= last_[1] &&
           laid_[index(p)];
  }
  const WalkPoint& at(const LatticePoint& p) const { return nodes_[index(p)]; }
  void lay(const LatticePoint& p, const WalkPoint& node) {
    nodes_[index(p)] = node;
    laid_[index(p)] = true;
  }
  const LatticePoint& first() const { return first_; }
  const LatticePoint& last() const { return last_; }

 private:
  std::size_t index(const LatticePoint& p) const {
    return std::size_t(p[1] - first_[1]) * std::size_t(columns_) + std::size_t(p[0] - first_[0]);
  }
  LatticePoint first_, last_;
  int columns_;
  std::vector<WalkPoint> nodes_;
  std::vector<bool> laid_;
};

// A net is laid somewhat beyond the area, since its threads may leave it and come back.
Box2 widened(const LatticeRequest& r) {
  const Vec2 margin = 0.1 * r.area.sizes() + Vec2::Constant(2.0 * r.spacing);
  Box2 box = r.area;
  box.extend(Vec2(r.area.min() - margin));
  box.extend(Vec2(r.area.max() + margin));
  return box;
}

// The four half threads from the start: +i, -i, +j, -j, without the start itself.
std::array<std::vector<WalkPoint>, 4> lay_threads(const LatticeRequest& r,
                                                  const TexturePlane& plane,
                                                  const SurfaceSampler& sampler,
                                                  const WalkPoint& start, const Box2& limit) {
  const Vec3 t1 = tangents(plane, start.normal).col(0).normalized();
  const Vec3 t2 = start.normal.cross(t1);
  const Vec2 second = second_axis(r.kind);
  const Vec3 heading[4] = {t1, -t1, second.x() * t1 + second.y() * t2,
                           -second.x() * t1 - second.y() * t2};
  // a straight line across at 75° of slope; one that is longer goes in circles
  const double across = 4.0 * limit.diagonal().norm() / r.spacing;
  const auto longest = static_cast<std::size_t>(std::min(across, double(r.max_nodes)));
  std::array<std::vector<WalkPoint>, 4> threads;
  std::array<bool, 4> open{true, true, true, true};
  while (open[0] || open[1] || open[2] || open[3]) {
    std::vector<WalkStep> steps;
    std::vector<int> of;
    for (int k = 0; k < 4; ++k) {
      if (!open[k]) continue;
      const auto& thread = threads[k];
      const WalkPoint& a = thread.empty() ? start : thread.back();
      const WalkPoint& before = thread.size() > 1 ? thread[thread.size() - 2] : start;
      const Vec3 ahead =
          thread.empty() ? heading[k] : Vec3((a.position - before.position).normalized());
      WalkStep step;
      step.a = &a;
      step.across = a.normal.cross(ahead).normalized();
      step.length = r.spacing;
      step.extension = extension(a.position, a.normal, a.normal - before.normal, plane);
      step.at.place = place_of_point(plane, a.position + r.spacing * ahead);
      steps.push_back(step);
      of.push_back(k);
    }
    take_steps(plane, sampler, steps);
    for (std::size_t n = 0; n < steps.size(); ++n) {
      auto& thread = threads[of[n]];
      open[of[n]] =
          steps[n].reached && limit.contains(steps[n].at.place) && thread.size() < longest;
      if (open[of[n]]) thread.push_back(steps[n].at);
    }
  }
  return threads;
}

int sign(int x) {
  return x < 0 ? -1 : 1;
}

// The meshes at distance k from the start (|i| + |j| = k) whose elder neighbours are laid.
std::vector<LatticePoint> row(const Net& net, int k) {
  std::vector<LatticePoint> points;
  for (int i = std::max(net.first()[0], 1 - k); i <= std::min(net.last()[0], k - 1); ++i) {
    if (i == 0) continue;
    for (int j : {std::abs(i) - k, k - std::abs(i)}) {
      const LatticePoint a{i - sign(i), j}, b{i, j - sign(j)}, c{i - sign(i), j - sign(j)};
      if (net.laid(a) && net.laid(b) && net.laid(c)) points.push_back({i, j});
    }
  }
  return points;
}

// Lays one row of meshes. Returns whether there was any.
bool lay_row(Net& net, int k, const LatticeRequest& r, const TexturePlane& plane,
             const SurfaceSampler& sampler, const Box2& limit) {
  const std::vector<LatticePoint> points = row(net, k);
  std::vector<WalkStep> steps;
  steps.reserve(points.size());
  for (const LatticePoint& p : points) {
    const int si = sign(p[0]), sj = sign(p[1]);
    WalkStep step;
    step.a = &net.at({p[0] - si, p[1]});
    step.b = &net.at({p[0], p[1] - sj});
    const WalkPoint& corner = net.at({p[0] - si, p[1] - sj});
    step.length = r.spacing;
    step.extension = parallelogram(*step.a, *step.b, corner, plane);
    step.at.place = place_of_point(plane, step.a->position + step.b->position - corner.position);
    steps.push_back(step);
  }
  take_steps(plane, sampler, steps);
  const double widest = std::cos(r.least_angle.radians());
  for (std::size_t n = 0; n < points.size(); ++n) {
    if (!steps[n].reached || !limit.contains(steps[n].at.place)) continue;
    const Vec3 a = (steps[n].at.position - steps[n].a->position).normalized();
    const Vec3 b = (steps[n].at.position - steps[n].b->position).normalized();
    if (std::abs(a.dot(b)) < widest) net.lay(points[n], steps[n].at);
  }
  return !points.empty();
}

}  // namespace

std::optional<SurfaceLattice> chebyshev_net(const LatticeRequest& request,
                                            const TexturePlane& plane,
                                            const SurfaceSampler& sampler,
                                            const Progress& progress) {
  const SurfacePoint at = require_start(request, sampler);
  const WalkPoint start{request.start, at.position, at.normal, true};
  const Box2 limit = widened(request);
  const auto threads = lay_threads(request, plane, sampler, start, limit);
  auto length = [&](int k) { return static_cast<int>(threads[k].size()); };
  const double nodes = (length(0) + length(1) + 1.0) * (length(2) + length(3) + 1.0);
  if (nodes > double(request.max_nodes))
    throw InputError("Spacing", fmt::format("{} mm", request.spacing),
                     fmt::format("the net would have {:.0f} nodes, more than the limit of {}: "
                                 "choose a larger spacing or a smaller area.",
                                 nodes, request.max_nodes));
  Net net({-length(1), -length(3)}, {length(0), length(2)});
  net.lay({0, 0}, start);
  for (int n = 1; n <= length(0); ++n) net.lay({n, 0}, threads[0][n - 1]);
  for (int n = 1; n <= length(1); ++n) net.lay({-n, 0}, threads[1][n - 1]);
  for (int n = 1; n <= length(2); ++n) net.lay({0, n}, threads[2][n - 1]);
  for (int n = 1; n <= length(3); ++n) net.lay({0, -n}, threads[3][n - 1]);
  const int last_row = std::max(length(0), length(1)) + std::max(length(2), length(3));
  for (int k = 2; k <= last_row && lay_row(net, k, request, plane, sampler, limit); ++k)
    if (!go_on(progress, double(k) * k / (double(last_row) * last_row))) return std::nullopt;

  auto grid = std::make_shared<NodeGrid>(net.first(), net.last());
  SurfaceLattice lattice;
  for (int j = net.first()[1]; j <= net.last()[1]; ++j)
    for (int i = net.first()[0]; i <= net.last()[0]; ++i) {
      if (!net.laid({i, j})) continue;
      const Vec2 place = net.at({i, j}).place;
      grid->set({i, j}, place);
      if (!request.area.contains(place)) continue;
      lattice.flat.extend(lattice_place(request.kind, request.spacing, Vec2(i, j)));
    }
  lattice.place_of = [grid](const Vec2& p) { return grid->at(p); };
  return lattice;
}

}  // namespace patchmill::patch

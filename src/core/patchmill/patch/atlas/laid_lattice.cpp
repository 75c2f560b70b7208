// Lattice points on charts; see laid_lattice.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/atlas/laid_lattice.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"
#include "patchmill/patch/atlas/near_points.h"
#include "patchmill/patch/cover.h"
#include "patchmill/patch/surface_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace patchmill::patch {
namespace {

constexpr double kOffWorth = 0.04;   // share by which the count may be off what the area is worth
constexpr int kOffsets = 5;          // along each side of a cell that are tried
constexpr double kFew = 6000.0;      // dimples: with more, a shift of the lattice changes little
constexpr double kConflicts = 0.05;  // share of a chart's points whose number is taken
constexpr double kHidden = 1e-3;     // spacings: a face that is met so much earlier hides a point

double worth(const Atlas& atlas, LatticeKind kind, double spacing) {
  double sum = 0.0;
  for (const PlacedChart& c : atlas.charts)
    sum += c.chart.area() * c.chart.density() / (cell_area(kind) * spacing * spacing);
  return sum;
}

Box2 plane_bounds(const PlacedChart& c) {
  Box2 box;
  if (c.chart.bounds().isEmpty()) return box;
  for (int k = 0; k < 4; ++k) box.extend(c.to_plane(c.chart.bounds().corner(Box2::CornerType(k))));
  return box;
}

// Lattice coordinates around a rectangle of the plane.
Box2 lattice_bounds(LatticeKind kind, double spacing, const Box2& plane) {
  Box2 box;
  for (int k = 0; k < 4; ++k)
    box.extend(lattice_coordinates(kind, spacing, plane.corner(Box2::CornerType(k))));
  return box;
}

bool is_whole(const Vec2& p) {
  return (p - Vec2(p.array().round())).cwiseAbs().maxCoeff() < 1e-9;
}

}  // namespace

template <class Take>
void LaidLattice::each_point(const PlacedChart& c, const Vec2& offset, Take take) const {
  const Box2 bounds = plane_bounds(c);
  if (bounds.isEmpty()) return;
  const double f = pattern_.spacing;
  const Box2 range = lattice_bounds(kind_, f, Box2(bounds.min() - offset, bounds.max() - offset));
  const int i0 = int(std::floor(range.min().x())), i1 = int(std::ceil(range.max().x()));
  const int j0 = int(std::floor(range.min().y())), j1 = int(std::ceil(range.max().y()));
  for (int j = j0; j <= j1; ++j)
    for (int i = i0; i <= i1; ++i) {
      stop_point();
      const Vec2 own = c.to_own(lattice_place(kind_, f, Vec2(i, j)) + offset);
      if (!c.chart.bounds().contains(own)) continue;
      const auto place = c.chart.uv(own);
      if (place && c.chart.face().inside(place->uv)) take(LatticePoint{i, j}, *place);
    }
}

LaidLattice::LaidLattice(Atlas atlas, const PatchPattern& pattern, bool may_shift,
                         std::int64_t max_points)
    : atlas_(std::move(atlas)), pattern_(pattern), kind_(lattice_of(pattern.shape)) {
  require_valid(pattern_);
  require_room(max_points);
  if (may_shift) offset_ = best_offset();
  settle_windows();
  for (PlacedChart& c : atlas_.charts) {
    std::int64_t taken = 0, count = 0;
    each_point(c, offset_, [&](const LatticePoint& p, const Chart::Place& place) {
      ++count;
      const LatticePoint shift = window_shift(c.window);
      const auto found = index_.find({p[0] + shift[0], p[1] + shift[1]});
      if (found == index_.end()) return;
      const Vec3 there = points_[found->second].sample.point.position;
      taken += (there - c.chart.point(place.uv).position).norm() > 0.5 * pattern_.spacing;
    });
    if (double(taken) > kConflicts * double(count)) c.window = atlas_.windows++;
    lay(c);
  }
  leave_out_crowded();
}

void LaidLattice::require_room(std::int64_t max_points) const {
  double cells = 0.0;
  for (const PlacedChart& c : atlas_.charts)
    if (!c.chart.bounds().isEmpty())
      cells += plane_bounds(c).volume() / (cell_area(kind_) * std::pow(pattern_.spacing, 2));
  if (worth(atlas_, kind_, pattern_.spacing) > double(max_points) ||
      cells > 20.0 * double(max_points))
    throw InputError("Spacing", fmt::format("{} mm", pattern_.spacing),
                     fmt::format("about {:.0f} dimples are more than the limit of {}: choose a "
                                 "larger spacing or fewer faces.",
                                 worth(atlas_, kind_, pattern_.spacing), max_points));
}

std::int64_t LaidLattice::count_at(const Vec2& offset) const {
  std::int64_t count = 0;
  for (const PlacedChart& c : atlas_.charts)
    each_point(c, offset, [&](const LatticePoint&, const Chart::Place&) { ++count; });
  return count;
}

Vec2 LaidLattice::best_offset() const {
  const double wanted = worth(atlas_, kind_, pattern_.spacing);
  Vec2 best = Vec2::Zero();
  if (wanted > kFew) return best;
  double off = std::abs(double(count_at(best)) - wanted);
  if (off <= kOffWorth * wanted) return best;
  for (int k = 1; k < kOffsets * kOffsets; ++k) {
    const Vec2 offset =
        lattice_place(kind_, pattern_.spacing, Vec2(k % kOffsets, k / kOffsets) / double(kOffsets));
    const double miss = std::abs(double(count_at(offset)) - wanted);
    if (miss < off) {
      off = miss;
      best = offset;
    }
  }
  return best;
}

// Windows so far apart, along the second tiling vector, that no two have lattice points in common.
void LaidLattice::settle_windows() {
  double furthest = 1.0;
  for (const PlacedChart& c : atlas_.charts) {
    const Box2 plane = plane_bounds(c);
    if (plane.isEmpty()) continue;
    const Box2 range = lattice_bounds(kind_, pattern_.spacing, plane);
    furthest = std::max({furthest, std::abs(range.min().y()), std::abs(range.max().y())});
  }
  const LatticePoint v = tiling_vectors(pattern_.shape, pattern_.size)[1];
  const int patch = std::abs(v[0]) + std::abs(v[1]);
  window_cells_ = static_cast<std::int32_t>(std::ceil((2.0 * furthest + 4.0 * patch + 8.0) / v[1]));
}

LatticePoint LaidLattice::window_shift(int window) const {
  const LatticePoint v = tiling_vectors(pattern_.shape, pattern_.size)[1];
  const int cells = window * window_cells_;
  return {cells * v[0], cells * v[1]};
}

void LaidLattice::lay(const PlacedChart& c) {
  const LatticePoint shift = window_shift(c.window);
  each_point(c, offset_, [&](const LatticePoint& p, const Chart::Place& place) {
    const LatticePoint key{p[0] + shift[0], p[1] + shift[1]};
    const DimpleState state = place.fit ? DimpleState::Cut : DimpleState::OffNet;
    if (!index_.emplace(key, points_.size()).second) return;
    points_.push_back({key, {c.chart.point(place.uv), state}});
  });
}

// Of points on the same side of a wall; those on its two sides are not milled together.
void LaidLattice::leave_out_crowded() {
  const double least = kLeastDistance * pattern_.spacing;
  NearPoints kept(least);
  for (std::size_t k = 0; k < points_.size(); ++k) {
    stop_point();
    SurfaceSample& sample = points_[k].sample;
    if (sample.state != DimpleState::Cut) continue;
    bool room = true;
    kept.around(sample.point.position, [&](std::size_t n, double squared) {
      if (squared < least * least && points_[n].sample.point.normal.dot(sample.point.normal) > -0.2)
        room = false;
    });
    if (room) {
      kept.add(sample.point.position, k);
      continue;
    }
    sample.state = DimpleState::Crowded;
    ++crowded_;
  }
}

void LaidLattice::look_along(const TexturePlane& plane, const SurfaceSampler& sampler,
                             Angle steepest) {
  std::vector<Vec2> places;
  for (const Point& p : points_) places.push_back(place_of_point(plane, p.sample.point.position));
  const std::vector<SurfaceSample> seen = sampler(places);
  const double least = std::cos(steepest.radians());
  for (std::size_t k = 0; k < points_.size(); ++k) {
    stop_point();
    SurfaceSample& sample = points_[k].sample;
    if (sample.state != DimpleState::Cut) continue;
    const double facing = -sample.point.normal.dot(plane.direction);
    const double before = (sample.point.position - seen[k].point.position).dot(plane.direction);
    if (facing <= 0.0 || (on_face(seen[k].state) && before > kHidden * pattern_.spacing))
      sample.state = DimpleState::Undercut;
    else if (facing < least)
      sample.state = DimpleState::TooSteep;
  }
}

SurfaceSample LaidLattice::at(const Vec2& lattice) const {
  if (is_whole(lattice)) {
    const auto found = index_.find({int(std::lround(lattice.x())), int(std::lround(lattice.y()))});
    return found == index_.end() ? SurfaceSample{} : points_[found->second].sample;
  }
  const double apart = window_shift(1)[1];
  const int window = int(std::lround(lattice.y() / apart));
  const Vec2 local = lattice - to_vec(window_shift(window));
  const Vec2 place = lattice_place(kind_, pattern_.spacing, local) + offset_;
  SurfaceSample sample;
  for (const PlacedChart& c : atlas_.charts) {
    if (c.window != window) continue;
    const auto found = c.chart.uv(c.to_own(place));
    if (!found) continue;
    const bool inside = c.chart.face().inside(found->uv);
    if (inside || sample.state != DimpleState::Cut)
      sample = {c.chart.point(found->uv), inside ? DimpleState::Cut : DimpleState::TooSteep};
    if (inside) break;
  }
  return sample;
}

PatchDivision LaidLattice::cover(std::int64_t max_dimples) const {
  PatchDivision all;
  all.pattern = pattern_;
  for (int window = 0; window < atlas_.windows; ++window) {
    stop_point();
    const LatticePoint shift = window_shift(window);
    const double half = 0.5 * window_shift(1)[1];
    Box2 flat;
    for (const Point& p : points_) {
      const Vec2 local(p.lattice[0] - shift[0], p.lattice[1] - shift[1]);
      if (std::abs(local.y()) < half) flat.extend(lattice_place(kind_, pattern_.spacing, local));
    }
    if (flat.isEmpty()) continue;
    const Vec2 slack = Vec2::Constant(1e-3 * pattern_.spacing);
    const Box2 area(flat.min() - slack, flat.max() + slack);
    PatchDivision part = keep_patches(patch::cover(pattern_, area, Vec2::Zero(), 8 * max_dimples),
                                      [&](const LatticePoint& p) {
                                        return index_.count({p[0] + shift[0], p[1] + shift[1]}) > 0;
                                      });
    for (PatchCell& cell : part.cells) cell.b += window * window_cells_;
    all.cells.insert(all.cells.end(), part.cells.begin(), part.cells.end());
  }
  return all;
}

SurfaceLattice as_surface_lattice(std::shared_ptr<const LaidLattice> laid,
                                  const TexturePlane& plane) {
  SurfaceLattice lattice;
  lattice.sample_of = [laid](const Vec2& p) { return laid->at(p); };
  lattice.place_of = [laid, plane](const Vec2& p) -> Vec2 {
    const SurfaceSample sample = laid->at(p);
    if (sample.state == DimpleState::OffFace)
      return Vec2::Constant(std::numeric_limits<double>::quiet_NaN());
    return place_of_point(plane, sample.point.position);
  };
  lattice.flat = Box2(Vec2::Zero(), Vec2::Zero());
  return lattice;
}

}  // namespace patchmill::patch

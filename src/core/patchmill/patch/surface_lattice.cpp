// What lattices on surfaces have in common, and their measure; see surface_lattice.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/surface_lattice.h"

#include "patchmill/geometry/require.h"
#include "patchmill/patch/cover.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <fmt/format.h>

namespace patchmill::patch {
namespace {

struct PointHash {
  std::size_t operator()(const LatticePoint& p) const {
    return static_cast<std::size_t>(p[0]) * 0x9e3779b97f4a7c15ull ^
           static_cast<std::size_t>(p[1]) * 0xc2b2ae3d27d4eb4full;
  }
};

void add(SpacingSpread::Direction& d, double ratio) {
  d.least = d.pairs ? std::min(d.least, ratio) : ratio;
  d.greatest = std::max(d.greatest, ratio);
  d.mean += ratio;
  ++d.pairs;
}

void require_area(const Box2& area) {
  if (area.isEmpty() || !area.min().allFinite() || !area.max().allFinite())
    throw InputError("Area", "empty", "give an area with finite corners.");
}

}  // namespace

SurfacePoint require_start(const LatticeRequest& r, const SurfaceSampler& sampler) {
  require_positive("Spacing", r.spacing, "mm");
  require_area(r.area);
  require_finite("Start", r.start, "mm");
  const std::vector<SurfaceSample> sample = sampler({r.start});
  if (!on_face(sample[0].state))
    throw InputError("Start", fmt::format("({:.6g}, {:.6g}) mm", r.start.x(), r.start.y()),
                     "this place is off the faces: choose one on them.");
  return sample[0].point;
}

Vec2 nearest_start(const Vec2& wanted, const Box2& area, const SurfaceSampler& sampler) {
  require_area(area);
  require_finite("Start", wanted, "mm");
  constexpr int kGrid = 64;
  std::vector<Vec2> places{wanted};
  for (int i = 0; i < kGrid; ++i)
    for (int j = 0; j < kGrid; ++j)
      places.push_back(area.min() +
                       area.sizes().cwiseProduct(Vec2(i + 0.5, j + 0.5) / double(kGrid)));
  const std::vector<SurfaceSample> samples = sampler(places);
  const Vec2* best = nullptr;
  for (std::size_t k = 0; k < places.size(); ++k)
    if (samples[k].state == DimpleState::Cut &&
        (!best || (places[k] - wanted).norm() < (*best - wanted).norm()))
      best = &places[k];
  if (!best)
    throw InputError("Start", fmt::format("({:.6g}, {:.6g}) mm", wanted.x(), wanted.y()),
                     "no place of the faces can be cut from this direction: choose another "
                     "direction, a steeper limit or other faces.");
  return *best;
}

SurfaceLattice counted_from(const SurfaceLattice& lattice, const Vec2& flat, LatticeKind kind,
                            double spacing) {
  require_finite("Start", flat, "mm");
  const Vec2 shift = lattice_coordinates(kind, spacing, flat).array().round();
  const Vec2 moved = lattice_place(kind, spacing, shift);
  SurfaceLattice counted{
      [place_of = lattice.place_of, shift](const Vec2& p) { return place_of(p + shift); }, nullptr,
      Box2(lattice.flat.min() - moved, lattice.flat.max() - moved)};
  if (lattice.sample_of)
    counted.sample_of = [sample_of = lattice.sample_of, shift](const Vec2& p) {
      return sample_of(p + shift);
    };
  return counted;
}

PatchDivision cover(const PatchPattern& pattern, const SurfaceLattice& lattice, const Box2& area,
                    std::int64_t max_dimples) {
  require_valid(pattern);
  require_area(area);
  const Vec2 anchor = lattice.place_of(Vec2::Zero());
  const Vec2 slack = Vec2::Constant(1e-6 * pattern.spacing);
  const Box2 flat(anchor + lattice.flat.min() - slack, anchor + lattice.flat.max() + slack);
  return keep_patches(cover(pattern, flat, anchor, 4 * max_dimples), [&](const LatticePoint& p) {
    const Vec2 at = lattice.place_of(to_vec(p));
    return at.allFinite() && area.contains(at);
  });
}

SpacingSpread spacing_spread(const Dimples& dimples, LatticeKind kind, double spacing) {
  std::unordered_map<LatticePoint, const Vec3*, PointHash> cut;
  cut.reserve(dimples.size());
  for (const Dimple& d : dimples)
    if (d.state == DimpleState::Cut) cut.emplace(d.lattice, &d.surface.position);
  const auto& steps = neighbour_steps(kind);
  SpacingSpread spread;
  double squares = 0.0, widest = -1.0, narrowest = 1.0;  // cosines
  for (const Dimple& d : dimples) {
    if (d.state != DimpleState::Cut) continue;
    std::array<Vec3, 3> edge;
    std::array<bool, 3> has{};
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const auto next = cut.find({d.lattice[0] + steps[k][0], d.lattice[1] + steps[k][1]});
      if (next == cut.end()) continue;
      has[k] = true;
      edge[k] = *next->second - d.surface.position;
      add(spread.along[k], edge[k].norm() / spacing);
      squares += std::pow(edge[k].norm() / spacing - 1.0, 2);
    }
    if (!has[0] || !has[1]) continue;
    const double c = std::clamp(edge[0].normalized().dot(edge[1].normalized()), -1.0, 1.0);
    widest = std::max(widest, c);
    narrowest = std::min(narrowest, c);
  }
  spread.least_angle = Angle::radians(std::acos(widest));
  spread.greatest_angle = Angle::radians(std::acos(narrowest));
  std::int64_t pairs = 0;
  for (SpacingSpread::Direction& a : spread.along) {
    if (!a.pairs) continue;
    a.mean /= double(a.pairs);
    spread.least = pairs ? std::min(spread.least, a.least) : a.least;
    spread.greatest = std::max(spread.greatest, a.greatest);
    pairs += a.pairs;
  }
  spread.rms = pairs ? std::sqrt(squares / double(pairs)) : 0.0;
  return spread;
}

}  // namespace patchmill::patch

// LaidLattice: a lattice on an atlas of faces. Each lattice point is a point of a face; those that would be nearer
// to one that is there already than kLeastDistance of the spacing, straight in space, are left out as crowded:
// where charts meet that do not follow from one another, and where a closed face comes back to itself.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/atlas/atlas.h"
#include "patchmill/patch/surface_lattice.h"

#include <unordered_map>

namespace patchmill::patch {

/// A hash of lattice points.
struct LatticePointHash {
  /// The hash of a point.
  std::size_t operator()(const LatticePoint& p) const {
    return static_cast<std::size_t>(p[0]) * 0x9e3779b97f4a7c15ull ^
           static_cast<std::size_t>(p[1]) * 0xc2b2ae3d27d4eb4full;
  }
};

/// A lattice laid on the charts of an atlas.
class LaidLattice {
 public:
  /// Nearest distance of dimples over the spacing that is laid.
  static constexpr double kLeastDistance = 0.9;

  /// The pattern's lattice. Unless the start was given, it is shifted within a cell if that brings the number
  /// of points nearer to what the area is worth. Errors: InputError naming Spacing (more than `max_points`).
  LaidLattice(Atlas atlas, const PatchPattern& pattern, bool may_shift,
              std::int64_t max_points = 20000000);

  /// Marks what cannot be cut from a direction: too steep, undercut, or hidden by what a ray of the sampler meets
  /// before it. `steepest` is the greatest angle between the normal and -direction that may be cut.
  void look_along(const TexturePlane& plane, const SurfaceSampler& sampler, Angle steepest);

  /// What is at lattice coordinates: for whole ones the lattice's point, and between them the faces.
  SurfaceSample at(const Vec2& lattice) const;

  /// The patches that have lattice points, window by window.
  PatchDivision cover(std::int64_t max_dimples = 20000000) const;

  /// The charts that it lies on.
  const Atlas& atlas() const { return atlas_; }
  /// How many points were left out because others are too near.
  std::int64_t crowded() const { return crowded_; }
  /// How many points it has.
  std::size_t size() const { return points_.size(); }

 private:
  struct Point {
    LatticePoint lattice;
    SurfaceSample sample;
  };
  template <class Take>
  void each_point(const PlacedChart& chart, const Vec2& offset, Take take) const;
  Vec2 best_offset() const;
  std::int64_t count_at(const Vec2& offset) const;
  void require_room(std::int64_t max_points) const;
  void settle_windows();
  void lay(const PlacedChart& chart);
  void leave_out_crowded();
  LatticePoint window_shift(int window) const;

  Atlas atlas_;
  PatchPattern pattern_;
  LatticeKind kind_;
  Vec2 offset_ = Vec2::Zero();
  std::int32_t window_cells_ = 0;  // along the second tiling vector, from window to window
  std::int64_t crowded_ = 0;
  std::vector<Point> points_;  // in the order in which they were laid
  std::unordered_map<LatticePoint, std::size_t, LatticePointHash> index_;
};

/// The laid lattice as operations take it. `laid` must have been looked along the plane's direction.
SurfaceLattice as_surface_lattice(std::shared_ptr<const LaidLattice> laid,
                                  const TexturePlane& plane);

/// Cut dimples nearer than `least` [mm], straight in space, to one before them become Crowded. Returns how many.
/// Errors: InputError naming LeastDistance (0 .. 1e6).
std::int64_t keep_apart(Dimples& dimples, double least);

/// Distance of each cut dimple to the nearest other one, straight in space [mm], in their order; infinite if there
/// is no other.
std::vector<double> nearest_distances(const Dimples& dimples);

}  // namespace patchmill::patch

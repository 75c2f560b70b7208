// Chart: a rectangle of a face's parameters in the plane, so that lengths are kept: exactly where the face
// rolls out by a formula, else as well as its curvature lets them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/progress.h"
#include "patchmill/patch/atlas/curved_face.h"

#include <memory>
#include <optional>

namespace patchmill::patch {

class ChartLookup;
struct ChartMesh;

/// A rectangle of a face spread out flat.
class Chart {
 public:
  /// Where a place of the plane is on the face.
  struct Place {
    Vec2 uv;
    bool fit = true;  ///< whether lengths are kept well enough for dimples there
  };

  /// `rectangle` is within the face's box(). `spacing` [mm] of the dimples: the plane is spread so that those
  /// neighbours that the map brings nearest keep kLeastDistance, if that takes no more than kMostSpread.
  /// One that does not fit and may be divided is not worked out. With `close_round`, a face that is closed along u
  /// and rolls out to a rectangle gets a whole number of dimples round: the least change that closes it.
  /// Nothing if `progress` asks to stop. Throws nothing.
  static std::optional<Chart> make(std::shared_ptr<const CurvedFace> face, const Box2& rectangle,
                                   double spacing, bool may_divide, bool close_round,
                                   const Progress& progress);

  /// Place in the plane [mm], as seen from outside of the material.
  Vec2 flat(const Vec2& uv) const;
  /// The way back; nothing beyond the rectangle.
  std::optional<Place> uv(const Vec2& flat) const;
  /// Position and normal of the face at parameters.
  SurfacePoint point(const Vec2& uv) const;

  /// The face that it is of.
  const CurvedFace& face() const { return *face_; }
  /// Its rectangle of the face's parameters.
  const Box2& rectangle() const { return rectangle_; }
  const Box2& bounds() const { return bounds_; }  ///< in the plane, of what is near the face [mm]
  const Vec2& middle() const {
    return middle_;
  }                                      ///< mean place of the trimmed face in the plane [mm]
  double area() const { return area_; }  ///< on the face, inside the trimming [mm²]
  double spread() const {
    return spread_;
  }  ///< distances on the face are so much longer, on average
  /// Dimples round a closed face, and their distance along it [mm]; 0 if it is not closed so.
  int round_count() const { return round_count_; }
  /// Distance of dimples round a closed face [mm]; 0 if it is not closed so.
  double round_spacing() const { return round_spacing_; }
  /// Share of a lattice cell's worth that is on the face: 1 / (spread² / the change that closes it).
  double density() const { return squeeze_ / (spread_ * spread_); }
  /// Whether all of it keeps lengths well enough; else it is to be divided.
  bool fits() const { return fits_; }
  /// Mean length of the rectangle on the face along u and v [mm].
  const Vec2& lengths() const { return lengths_; }

  /// Least distance of neighbours that is aimed at, over the spacing.
  static constexpr double kLeastDistance = 0.905;
  static constexpr double kMostSpread = 1.035;

 private:
  Chart() = default;
  struct Extremes;
  static Extremes extremes(const ChartMesh& mesh, const std::vector<Vec2>& flat);
  void measure(double spacing, bool close_round);
  void settle(ChartMesh mesh, std::vector<Vec2> flat, const Extremes& e, double chord);
  void close(double spacing, double chord);
  Vec2 turned(const Vec2& p) const { return face_->reversed() ? Vec2(p.x(), -p.y()) : p; }
  /// From the map's plane to the chart's own, and back.
  Vec2 own(const Vec2& p) const {
    const Vec2 q = turned(p) / spread_;
    return {q.x() * squeeze_, q.y()};
  }
  Vec2 mapped(const Vec2& p) const { return turned(spread_ * Vec2(p.x() / squeeze_, p.y())); }

  std::shared_ptr<const CurvedFace> face_;
  Box2 rectangle_, bounds_;
  Vec2 middle_ = Vec2::Zero(), lengths_ = Vec2::Zero();
  double area_ = 0.0, spread_ = 1.0, squeeze_ = 1.0;
  int round_count_ = 0;
  double round_spacing_ = 0.0;
  bool fits_ = true;
  std::shared_ptr<const ChartLookup> lookup_;  // null if the face rolls out by a formula
};

}  // namespace patchmill::patch

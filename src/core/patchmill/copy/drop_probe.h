// The probe of copy milling on its way: a ball dropped at one place after the other, each near the last.
//
// Around the places ahead the probe keeps a zone, a box of the plan with a floor, the plane
// P(p) = f + g . (p - c) - m through a place c where the ball rests at the height f, or near it, on a slope g, and
// lowered by m; and those triangles that can lift the ball above the floor somewhere in the zone:
//   every other one lifts the ball to P(p) at most, for all p of the zone         (patchmill/mesh/drop_bounds.h).
// A height found among the zone's triangles that is above P(p) is therefore the highest of all, to the last bit.
// One that is not tells nothing, and the zone is made anew. The floor is lowered by m = b |r - c|^2 / 2, r the
// furthest place of the zone, b the bend that the heights have shown in the zone before. A zone is as long as some
// twenty triangles or sixty steps, so that its making is shared by several places: what a place costs depends on how
// many triangles lie between it and the next, and hardly on how many there are.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/copy/drop_cutter.h"
#include "patchmill/mesh/drop_bounds.h"

namespace patchmill::copy {

/// A ball that is dropped from place to place.
class DropProbe {
 public:
  /// `radius` of the ball [mm, > 0]. The tree must outlive the probe. A probe serves one thread.
  DropProbe(const mesh::TriangleBvh& bvh, double radius);

  /// Height z [mm] of the ball's centre over (x, y) [mm], kNoContact where nothing holds it: the same as
  /// drop_ball(bvh, x, y, radius), to the last bit, whatever places came before.
  double operator()(double x, double y);

 private:
  struct Zone {
    Vec2 lo = Vec2::Ones(), hi = Vec2::Zero();     // none while lo > hi
    Vec2 at = Vec2::Zero(), slope = Vec2::Zero();  // P(p) = height + slope . (p - at) - margin
    double height = 0.0, margin = 0.0;
    double reach = 0.0;                  // from `at` to the furthest place of the zone
    double sag = 0.0;                    // largest fall of the heights below P + margin
    std::vector<mesh::DropLeaf> leaves;  // its triangles, eight by eight
  };
  void follow(const Vec2& p);
  bool in_zone(const Vec2& p) const;
  double highest_in_zone(const Vec2& p, double floor);
  void learn_bend();
  bool make_zone(const Vec2& p, double height);
  std::size_t gather(const mesh::DropFloor& floor);

  const mesh::TriangleBvh* bvh_;
  double radius_;
  std::int32_t triangle_ = -1;  // on which the ball rested last
  Zone zone_;
  double length_;  // half the length of the next zone [mm]
  double bend_;    // b [1/mm]
  Vec2 last_ = Vec2::Zero(), drift_ = Vec2::Zero(), spread_ = Vec2::Zero();  // recent steps [mm]
  bool begun_ = false;
};

}  // namespace patchmill::copy

// Dimples on a sphere, for the tests of paths: everything about it has a closed form. A bump
// (convex) or a bowl (concave) of radius rho whose centre is chosen so that the patch's first point
// is tilted.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/cover.h"

namespace patchmill::sync {

struct BallSurface {
  double radius = 30.0;  ///< > 0: bump, < 0: bowl [mm]
  Vec3 centre = Vec3::Zero();

  /// Height of a ball of radius `ball` at `c` over the surface [mm]; negative: it gouges.
  double clearance(const Vec3& c, double ball) const {
    const double distance = (c - centre).norm();
    return radius > 0.0 ? distance - radius - ball : -radius - distance - ball;
  }
};

/// Helical patches of side x side dimples on `surface`, spaced 0.5 mm; (x, y) the first one's place
/// from the sphere's centre.
inline patch::Dimples dimples_on(const BallSurface& surface, double x, double y, int side,
                                 int patches_x = 1, int patches_y = 1) {
  const patch::PatchDivision division =
      patch::patch_block({patch::PatchShape::Square, 0.5, side}, patches_x, patches_y);
  patch::Dimples dimples = patch::lattice_points(division);
  const Vec2 first = patch::place(division, dimples.front().lattice);
  for (patch::Dimple& dimple : dimples) {
    const Vec2 at = patch::place(division, dimple.lattice) - first + Vec2(x, y);
    const double height = std::sqrt(surface.radius * surface.radius - at.squaredNorm());
    const Vec3 radial(at.x(), at.y(), surface.radius > 0.0 ? height : -height);
    dimple.surface.position = surface.centre + radial;
    dimple.surface.normal = radial.normalized() * (surface.radius > 0.0 ? 1.0 : -1.0);
  }
  return dimples;
}

}  // namespace patchmill::sync

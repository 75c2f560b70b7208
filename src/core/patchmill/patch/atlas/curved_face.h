// CurvedFace: a trimmed face by its parameters, as the atlas needs it. Whoever knows faces (OpenCASCADE, a
// formula in a test) derives from it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/polynomial_surface.h"
#include "patchmill/patch/division.h"

#include <functional>
#include <memory>
#include <vector>

namespace patchmill::patch {

/// A face rolled out flat with all its lengths and angles, where that is possible and known by formula.
struct Development {
  std::function<Vec2(const Vec2& uv)> flat;  ///< place in the plane [mm] of parameters
  std::function<Vec2(const Vec2& flat)> uv;  ///< parameters of a place in the plane
};

/// A trimmed face as an atlas asks it.
class CurvedFace {
 public:
  virtual ~CurvedFace() = default;
  /// Point and derivatives; also a little outside of box().
  virtual SurfaceD1 d1(const Vec2& uv) const = 0;
  /// Unit normal out of the material, at poles too.
  virtual Vec3 normal(const Vec2& uv) const = 0;
  /// Whether the normal out of the material is du x dv turned over.
  virtual bool reversed() const = 0;
  /// Whether parameters of box() are inside the trimming.
  virtual bool inside(const Vec2& uv) const = 0;
  /// Rectangle of parameters around the trimming.
  virtual Box2 box() const = 0;
  /// How it rolls out by formula (plane, cylinder, cone, extrusion), or null.
  virtual const Development* development() const { return nullptr; }
};

/// The same points of an edge on the two faces (by number) that share it, by their parameters.
struct SharedEdge {
  int a = 0, b = 0;
  std::vector<Vec2> uv_a, uv_b;
};

/// Faces that are textured together, and the edges that they share. Faces are not null.
struct FaceSet {
  std::vector<std::shared_ptr<const CurvedFace>> faces;
  std::vector<SharedEdge> edges;
};

}  // namespace patchmill::patch

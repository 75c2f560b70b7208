// A part or stock as Python holds it: its mesh and the tree over it, made once.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/mesh/triangle_bvh.h"

namespace patchmill {

struct Solid {
  mesh::TriangleMesh mesh;
  mesh::TriangleBvh bvh;
  explicit Solid(mesh::TriangleMesh given) : mesh(std::move(given)), bvh(mesh) {}
};

}  // namespace patchmill

// A part or stock as Python holds it: its mesh and the tree over it, made once.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/error.h"
#include "patchmill/mesh/signed_distance.h"

namespace patchmill {

struct Solid {
  mesh::TriangleMesh mesh;
  mesh::TriangleBvh bvh;
  explicit Solid(mesh::TriangleMesh given) : mesh(std::move(given)), bvh(mesh) {}
};

/// What errors call the shape: it must have a name, or they would name nothing.
inline void require_named(const std::string& property) {
  if (property.empty())
    throw InputError("property", "empty", "give the name that errors are to call the shape by.");
}

}  // namespace patchmill

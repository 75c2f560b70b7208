// OpenCASCADE's faces as the atlas takes them: parameters, trimming, how they roll out, and shared edges.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/atlas/curved_face.h"

#include <optional>
#include <utility>

#include <TopoDS_Face.hxx>

namespace patchmill {

/// The faces in their order, and the edges that two of them share. Not for use by several threads at once.
/// Errors: InputError naming Base (no face, or a face without a surface).
patch::FaceSet atlas_faces(const std::vector<TopoDS_Face>& faces);

/// The face that a point lies on, at most 1e-5 mm off, and its parameters there; nothing if it is on none.
std::optional<std::pair<int, Vec2>> find_on_faces(const std::vector<TopoDS_Face>& faces,
                                                  const Vec3& point);

}  // namespace patchmill

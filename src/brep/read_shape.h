// Shapes cross from FreeCAD as BREP text, since Debian's FreeCAD has no C++ headers.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

namespace patchmill {

/// The shape in `brep` (what Part.Shape.exportBrepToString gives). Errors: InputError naming `property` if the
/// text is no shape.
TopoDS_Shape read_shape(const std::string& brep, const char* property);

/// All faces of the shape in `brep` (what Part.Shape.exportBrepToString gives), in its order.
/// Errors: InputError naming Base if the text is no shape or has no face.
std::vector<TopoDS_Face> read_faces(const std::string& brep);

}  // namespace patchmill

// OpenCASCADE's mesher, asked how many triangles it will make before it makes them: their number goes with a
// power of the deflection, -1/2 for faces that bend one way and -1 for those that bend both ways, and two coarse
// meshes show which.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/angle.h"

#include <TopoDS_Shape.hxx>

namespace patchmill {

/// Triangulates all faces of a shape anew, triangles no further than `deflection` [mm] from it and at most `angle`
/// between neighbours of one face. Where that is so fine that the mesher would take long, a coarser deflection is
/// taken, and refine() is to do the rest; returns what was taken [mm]. Errors: InputError naming Deflection, with one
/// that does, where more than about `most` triangles would be made; Standard_Failure of OpenCASCADE.
double mesh_faces(const TopoDS_Shape& shape, double deflection, Angle angle, double most);

}  // namespace patchmill

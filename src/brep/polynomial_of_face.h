// A face's Bezier or B-spline surface as the core's PolynomialSurface.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/polynomial_surface.h"

#include <optional>

#include <TopoDS_Face.hxx>

namespace patchmill {

/// The face's surface in the face's place, with the same parameters; nothing if it is not a Bezier or
/// B-spline surface, is periodic, or of a degree above PolynomialSurface::kMostDegree.
std::optional<PolynomialSurface> polynomial_of(const TopoDS_Face& face);

}  // namespace patchmill

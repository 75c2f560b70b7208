// The edges that bound a set of faces, as short straight pieces: what a margin is measured from.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/boundary.h"

#include <vector>

#include <TopoDS_Face.hxx>

namespace patchmill {

/// Edges that belong to one of the faces only, and once only: neither seams nor edges between two of the
/// faces. Two edges are the same if their shape is (TopoDS IsSame). Pieces are at most `deflection` [mm]
/// from the curve. Degenerate edges (poles) are left out.
/// Errors: InputError naming Base if an edge's curve cannot be discretised.
std::vector<patch::Segment3> border_segments(const std::vector<TopoDS_Face>& faces,
                                             double deflection);

}  // namespace patchmill

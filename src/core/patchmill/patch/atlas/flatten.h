// Flattening of a chart's mesh: the places in the plane that change the lengths of its edges least, as the sum
// of squares of relative changes, and then so that the greatest changes become smaller (weights that grow
// with the change: iteratively reweighted least squares). No map of a sphere's cap of angular radius θ has
// stretches whose greatest and least are nearer than θ/sin θ (Milnor 1969).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/progress.h"
#include "patchmill/patch/atlas/chart_mesh.h"

#include <optional>

namespace patchmill::patch {

/// Greatest and least length in the plane over that on the face, in any direction; of one triangle.
struct Stretch {
  double least = 1.0, greatest = 1.0;
  bool turned_over = false;
};

/// Places of the vertices in the plane [mm], as du x dv sees them (counter-clockwise stays so). Vertices that
/// no triangle reaches are not finite. Nothing if `progress` asks to stop.
std::optional<std::vector<Vec2>> flatten(const ChartMesh& mesh, const Progress& progress = {});

/// Makes the greatest changes of length smaller, at the cost of the others. False if asked to stop.
bool even_out(const ChartMesh& mesh, std::vector<Vec2>& flat, const Progress& progress = {});

/// Of each of the mesh's triangles.
std::vector<Stretch> stretches(const ChartMesh& mesh, const std::vector<Vec2>& flat);

}  // namespace patchmill::patch

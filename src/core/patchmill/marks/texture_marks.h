// A whole texture through the simulator: band by band, so that memory goes with the heights that are kept
// and not with the base, and with the dimples of each band looked for at once.
//
//     const auto found = simulate_texture(motion, {path.tool}, grid, base_on(sampler), options);
//
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/marks/plan_comparison.h"
#include "patchmill/marks/simulate.h"

namespace patchmill::marks {

/// Gives a flat grid its base surface.
using BaseMaker = std::function<SurfaceGrid(SurfaceGrid flat)>;

/// The faces themselves, as the sampler finds them along the plane's direction.
BaseMaker base_on(const patch::SurfaceSampler& sampler);

/// The planes of planar patches and facets: at each cell the tangent plane of the nearest dimple, none
/// where that is further away than `reach` [mm]. Copies the dimples. Errors: InputError naming Reach.
BaseMaker base_of_patches(const patch::Dimples& dimples, const patch::TexturePlane& plane,
                          double reach);

/// How marks of a texture are computed.
struct TextureMarkOptions {
  MarkOptions marks;
  FindOptions find;
  std::int64_t band_cells = 4000000;  ///< about so many cells are simulated at once
  double halo = 1.0;  ///< [mm] beyond a band on both sides: twice the size of a dimple at least
};

/// The marks of a texture over a window.
struct TextureMarks {
  SurfaceGrid grid;  ///< flat: the base is not kept
  double stock = 0.0;
  std::vector<float> height;  ///< as in Relief: deviation from the base [mm], NaN without a base
  std::vector<DimpleMark> dimples;  ///< in order of rows
  MarkStatistics statistics;
  bool complete = true;  ///< false if `progress` asked to stop: rows not reached are NaN
};

/// The relief and the dimples of a flat grid, or of what `base` makes of it. Errors: those of
/// simulate_marks (memory is that of the heights that are kept and of one band) and find_dimples; Halo.
TextureMarks simulate_texture(const ToolMotion& motion, const Cutter& cutter,
                              const SurfaceGrid& flat, const BaseMaker& base,
                              const TextureMarkOptions& options, const Progress& progress = {});

/// What of a texture lies in a window of it.
struct WindowComparison {
  PlanComparison comparison;      ///< indices into `found`
  std::vector<DimpleMark> found;  ///< dimples of the window
};

/// Compares the dimples of a part of a texture with those planned there. A dimple belongs to the window
/// `low` to `high` [mm] if the planned one nearest to it does, or, further than half a spacing from any, if
/// it lies in it; so a mark that has moved over the border is not lost. `planned`: the whole plan.
/// Errors: InputError naming Spacing, or Window (not finite, or upside down).
WindowComparison compare_window(const std::vector<DimpleMark>& found,
                                const std::vector<PlannedPlace>& planned, const Vec2& low,
                                const Vec2& high, double spacing);

}  // namespace patchmill::marks

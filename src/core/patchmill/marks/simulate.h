// The cutter-mark simulator: the relief that a motion leaves on a surface (Matsuda, Sasahara &
// Tsutsumi 2008, section 2.2 and their simulator). Every flute of every turn that comes near the
// surface is one tooth pass; for every cell within its reach the moment is solved at which the edge
// is over the cell, while tool and spindle move, and the lowest pass wins. Cost goes with the
// marks, not with area times turns. The result is the same bit for bit on any number of threads.
//
//     const ToolMotion motion = motion_of(path);
//     const SurfaceGrid grid = flat_grid(plane, low, high, 0.01);
//     const SimulatedRelief marks = simulate_marks(motion, {path.tool}, grid, {0.1});
//
// Limits: only the ball part of the edges is simulated, from the tip to the equator.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/marks/tooth_pass.h"

#include <functional>

namespace patchmill::marks {

/// How closely marks are computed.
struct MarkOptions {
  /// Height of the uncut surface over the base [mm]; the simulator looks no higher. The reach of
  /// each pass, and so the cost, grows with it: about 2 R stock in area.
  double stock = 0.0;
  double memory_limit = 4e9;  ///< bytes; a job that needs more is refused beforehand
};

/// What computing them took.
struct MarkStatistics {
  std::int64_t passes = 0;       ///< tooth passes that reach the grid
  std::int64_t evaluations = 0;  ///< flute-cell evaluations: cells in reach, summed over passes
};

/// A relief and how it was found.
struct SimulatedRelief {
  Relief relief;
  MarkStatistics statistics;
  bool complete = true;  ///< false if `progress` asked to stop: some cells are then uncut
};

/// Bytes that simulate_marks needs for a grid of so many cells and a path of so many passes.
double memory_needed(const SurfaceGrid& grid, std::int64_t passes);

/// Errors: InputError naming GridStep with a step that does, if `of_cells` bytes, which go with the number of a grid's
/// cells, and `beside` bytes, which do not, are more than `limit`.
void require_memory(const SurfaceGrid& grid, double of_cells, double beside, double limit);

/// Errors: InputError naming Stock (not finite, or not below the ball radius), those of require_memory, of
/// require_valid(cutter) and of require_valid(grid).
SimulatedRelief simulate_marks(const ToolMotion& motion, const Cutter& cutter,
                               const SurfaceGrid& grid, const MarkOptions& options,
                               const Progress& progress = {});

/// The same, band by band of at most `band_rows` rows and `halo` rows more on both sides, for
/// reliefs too large to hold: `take` is called for each band in order, with the grid row of its
/// first row (halo included). Heights are those of simulate_marks but for rounding. `progress`
/// counts bands.
struct ReliefBand {
  Relief relief;                 ///< halo rows included
  int first_row = 0;             ///< of the whole grid: where relief row 0 is
  int own_from = 0, own_to = 0;  ///< rows of the whole grid that are this band's own
};
MarkStatistics simulate_bands(const ToolMotion& motion, const Cutter& cutter,
                              const SurfaceGrid& grid, const MarkOptions& options, int band_rows,
                              int halo, const std::function<void(const ReliefBand&)>& take,
                              const Progress& progress = {});

}  // namespace patchmill::marks

// One tile of a height field under the simulator: a square of cells small enough for a processor's
// cache, milled by all tooth passes that reach it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/marks/pass_frame.h"

namespace patchmill::marks {

constexpr int kTile = 128;  ///< cells along each side; a multiple of kLanes

/// A square of cells that is milled at a time.
class Tile {
 public:
  /// Starts an uncut tile at a cell of the grid. `grid` must outlive the tile's use.
  void begin(const SurfaceGrid& grid, int first_column, int first_row, double stock);

  /// Mills one pass; returns the number of cells in its reach.
  std::int64_t mill(const ToothPass& pass, const ToolMotion& motion, const Cutter& cutter);

  /// Looks again at the cells that are near the tool axis in a pass; for after all passes are
  /// milled.
  void search(const ToothPass& pass, const ToolMotion& motion, const Cutter& cutter);

  /// Copies the cells that are on the grid to a field of the grid's size.
  void end(std::vector<float>& field) const;

 private:
  /// Cells within `reach` of the ball centre's way, moved by `aside` (seen from above; on a curved
  /// base the reach is from point to point); returns their number.
  std::int64_t treat_flat(bool search, const Vec3& aside, double reach);
  std::int64_t treat_curved(bool search, const ToothPass& pass, const Vec3& aside, double reach);
  void load_base();

  const SurfaceGrid* grid_ = nullptr;
  int first_column_ = 0, first_row_ = 0, columns_ = 0, rows_ = 0;
  double stock_ = 0.0;
  std::vector<float> height_;  // kTile * kTile
  // curved base: places relative to origin_, normals, and for each run of kLanes cells the middle
  // and the radius of a ball around their stock points (negative: no base there)
  Vec3 origin_ = Vec3::Zero();
  std::vector<float> base_[6];
  std::vector<Vec3f> chunk_middle_;
  std::vector<float> chunk_radius_;
  FluteKernel kernel_ = flute_kernel(best_instruction_set());
  PassFrame frame_;
  PassWay way_;
};

}  // namespace patchmill::marks

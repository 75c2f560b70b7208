// Tiles, in parallel: each thread mills whole tiles, all passes of a tile in the order of the path.
// See simulate.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/marks/simulate.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/shared_progress.h"
#include "patchmill/geometry/stop.h"
#include "patchmill/marks/tile.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

namespace patchmill::marks {
namespace {

constexpr double kCoarser = 1.02;  // than would do, for the step is told with three digits

struct TileGrid {
  int columns, rows;  // of tiles
  explicit TileGrid(const SurfaceGrid& grid)
      : columns((grid.columns + kTile - 1) / kTile), rows((grid.rows + kTile - 1) / kTile) {}
  std::size_t count() const { return static_cast<std::size_t>(columns) * rows; }
};

/// Which passes reach each tile: those of tile k are pass_numbers[first[k] .. first[k + 1]), in
/// order.
struct TilePasses {
  std::vector<std::uint32_t> first, pass_numbers;
};

template <class Visit>
void for_tiles_of(const ToothPass& pass, const SurfaceGrid& grid, const TileGrid& tiles,
                  Visit&& visit) {
  const double size = grid.step * kTile;
  const auto tile_of = [&](double coordinate, double first, int count, double round_by) {
    return static_cast<int>(
        std::clamp(std::floor((coordinate - first + round_by) / size), -1.0, count + 0.0));
  };
  const int i0 = std::max(tile_of(pass.least[0], grid.first.x(), tiles.columns, -grid.step), 0);
  const int j0 = std::max(tile_of(pass.least[1], grid.first.y(), tiles.rows, -grid.step), 0);
  const int i1 =
      std::min(tile_of(pass.most[0], grid.first.x(), tiles.columns, grid.step), tiles.columns - 1);
  const int j1 =
      std::min(tile_of(pass.most[1], grid.first.y(), tiles.rows, grid.step), tiles.rows - 1);
  for (int j = j0; j <= j1; ++j)
    for (int i = i0; i <= i1; ++i) visit(static_cast<std::size_t>(j) * tiles.columns + i);
}

TilePasses sort_into_tiles(const std::vector<ToothPass>& passes, const SurfaceGrid& grid,
                           const TileGrid& tiles) {
  TilePasses sorted;
  sorted.first.assign(tiles.count() + 1, 0);
  for (const ToothPass& pass : passes)
    for_tiles_of(pass, grid, tiles, [&](std::size_t k) { ++sorted.first[k + 1]; });
  for (std::size_t k = 0; k < tiles.count(); ++k) sorted.first[k + 1] += sorted.first[k];
  sorted.pass_numbers.resize(sorted.first.back());
  std::vector<std::uint32_t> next(sorted.first.begin(), sorted.first.end() - 1);
  for (std::size_t p = 0; p < passes.size(); ++p)
    for_tiles_of(passes[p], grid, tiles, [&](std::size_t k) {
      sorted.pass_numbers[next[k]++] = static_cast<std::uint32_t>(p);
    });
  return sorted;
}

void require_valid_job(const Cutter& cutter, const SurfaceGrid& grid, const MarkOptions& options) {
  require_valid(cutter);
  require_valid(grid);
  require_in_range("Stock", options.stock, -cutter.ball.radius, 0.999 * cutter.ball.radius, "mm");
}

/// Mills all tiles of a grid into `out`.
void mill(const ToolMotion& motion, const Cutter& cutter, const std::vector<ToothPass>& passes,
          const MarkOptions& options, const Progress& progress, SimulatedRelief& out) {
  const SurfaceGrid& grid = out.relief.grid;
  const TileGrid tiles(grid);
  const TilePasses sorted = sort_into_tiles(passes, grid, tiles);
  SharedProgress shared(progress, tiles.count());
  tbb::enumerable_thread_specific<Tile> scratch;
  std::atomic<std::int64_t> evaluations{0};
  patchmill::parallel_for(std::size_t{0}, tiles.count(), [&](std::size_t k) {
    if (shared.stopped()) return;
    Tile& tile = scratch.local();
    tile.begin(grid, static_cast<int>(k % tiles.columns) * kTile,
               static_cast<int>(k / tiles.columns) * kTile, options.stock);
    std::int64_t count = 0;
    for (std::uint32_t i = sorted.first[k]; i < sorted.first[k + 1]; ++i)
      count += tile.mill(passes[sorted.pass_numbers[i]], motion, cutter);
    for (std::uint32_t i = sorted.first[k]; i < sorted.first[k + 1]; ++i)
      tile.search(passes[sorted.pass_numbers[i]], motion, cutter);
    tile.end(out.relief.height);
    evaluations += count;
    shared.one_done();
  });
  out.statistics.passes += static_cast<std::int64_t>(passes.size());
  out.statistics.evaluations += evaluations;
  out.complete = !shared.stopped();
}

SimulatedRelief uncut(const SurfaceGrid& grid, double stock) {
  SimulatedRelief out;
  out.relief.grid = grid;
  out.relief.stock = stock;
  out.relief.height.assign(static_cast<std::size_t>(grid.cells()), static_cast<float>(stock));
  return out;
}

/// Passes that reach rows from .. to of a grid.
std::vector<ToothPass> passes_of_rows(const std::vector<ToothPass>& passes, const SurfaceGrid& grid,
                                      int from, int to) {
  const double low = grid.plane_point(0, from - 1).y(), high = grid.plane_point(0, to).y();
  std::vector<ToothPass> some;
  std::copy_if(passes.begin(), passes.end(), std::back_inserter(some),
               [&](const ToothPass& pass) { return pass.most[1] >= low && pass.least[1] <= high; });
  return some;
}

}  // namespace

void require_memory(const SurfaceGrid& grid, double of_cells, double beside, double limit) {
  const double needed = of_cells + beside;
  if (needed <= limit) return;
  const std::string what =
      fmt::format("{:.3g} mm, which takes {:.3g} GB", grid.step, needed * 1e-9);
  const double left = limit - beside;
  if (!(left > 0.0))
    throw InputError(
        "GridStep", what,
        fmt::format(
            "the limit is {:.3g} GB, and {:.3g} GB are taken at any step: take a smaller window.",
            limit * 1e-9, beside * 1e-9));
  throw InputError(
      "GridStep", what,
      fmt::format("the limit is {:.3g} GB: take {:.3g} mm or more, or a smaller window.",
                  limit * 1e-9, kCoarser * grid.step * std::sqrt(of_cells / left)));
}

double memory_needed(const SurfaceGrid& grid, std::int64_t passes) {
  const double per_cell = sizeof(float) + (grid.curved() ? sizeof(double) + sizeof(Vec3f) : 0.0);
  return per_cell * static_cast<double>(grid.cells()) +
         (sizeof(ToothPass) + 4.0 * sizeof(std::uint32_t)) * static_cast<double>(passes);
}

SimulatedRelief simulate_marks(const ToolMotion& motion, const Cutter& cutter,
                               const SurfaceGrid& grid, const MarkOptions& options,
                               const Progress& progress) {
  require_valid_job(cutter, grid, options);
  const double of_cells = memory_needed(grid, 0);
  require_memory(grid, of_cells, 0.0, options.memory_limit);
  const std::vector<ToothPass> passes = find_passes(motion, cutter, grid, options.stock);
  require_memory(grid, of_cells,
                 memory_needed(grid, static_cast<std::int64_t>(passes.size())) - of_cells,
                 options.memory_limit);
  SimulatedRelief out = uncut(grid, options.stock);
  mill(motion, cutter, passes, options, progress, out);
  return out;
}

MarkStatistics simulate_bands(const ToolMotion& motion, const Cutter& cutter,
                              const SurfaceGrid& grid, const MarkOptions& options, int band_rows,
                              int halo, const std::function<void(const ReliefBand&)>& take,
                              const Progress& progress) {
  require_valid_job(cutter, grid, options);
  require_in_range("BandRows", band_rows, 1, std::numeric_limits<int>::max(), "rows");
  require_in_range("Halo", halo, 0, std::numeric_limits<int>::max(), "rows");
  const std::vector<ToothPass> passes = find_passes(motion, cutter, grid, options.stock);
  MarkStatistics sum;
  for (int from = 0; from < grid.rows; from += std::min(band_rows, grid.rows - from)) {
    ReliefBand band;
    band.own_from = from;
    band.own_to = from + std::min(band_rows, grid.rows - from);
    band.first_row = std::max(from - halo, 0);
    const int to = band.own_to + std::min(halo, grid.rows - band.own_to);
    SimulatedRelief part =
        uncut(row_band(grid, band.first_row, to - band.first_row), options.stock);
    mill(motion, cutter, passes_of_rows(passes, grid, band.first_row, to), options, {}, part);
    sum.evaluations += part.statistics.evaluations;
    band.relief = std::move(part.relief);
    take(band);
    if (!go_on(progress, static_cast<double>(band.own_to) / grid.rows)) break;
  }
  sum.passes = static_cast<std::int64_t>(passes.size());
  return sum;
}

}  // namespace patchmill::marks

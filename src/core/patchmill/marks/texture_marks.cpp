// Bands of a texture; see texture_marks.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/marks/texture_marks.h"

#include "patchmill/geometry/require.h"
#include "patchmill/geometry/stop.h"
#include "patchmill/marks/base_lookup.h"
#include "patchmill/marks/place_index.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <fmt/format.h>

namespace patchmill::marks {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// One band: rows first .. last of the whole grid are simulated, from .. to are its own.
struct Band {
  int first, last, from, to;
};

std::vector<Band> bands_of(const SurfaceGrid& grid, const TextureMarkOptions& options) {
  const auto rows =
      static_cast<int>(std::clamp<std::int64_t>(options.band_cells / grid.columns, 1, grid.rows));
  const auto halo = static_cast<int>(std::min(std::ceil(options.halo / grid.step), 1e6));
  std::vector<Band> bands;
  for (int from = 0; from < grid.rows;) {
    const int to = from + std::min(rows, grid.rows - from);
    bands.push_back({std::max(from - halo, 0), to + std::min(halo, grid.rows - to), from, to});
    from = to;
  }
  return bands;
}

void require_memory_of(const SurfaceGrid& grid, const std::vector<Band>& bands, double limit) {
  int rows = 0;
  for (const Band& band : bands) rows = std::max(rows, band.last - band.first);
  // a band: its heights, its base, and what looking for dimples takes
  const double heights = 4.0 * static_cast<double>(grid.cells());
  const double band = (4.0 + 20.0 + 20.0) * static_cast<double>(rows) * grid.columns;
  if (bands.size() > 1)  // of about so many cells, whatever the grid's
    require_memory(grid, heights, band, limit);
  else
    require_memory(grid, heights + band, 0.0, limit);
}

/// Takes the band's own rows and dimples over.
void keep(const Relief& relief, const Band& band, const FindOptions& find, TextureMarks& out) {
  const auto columns = static_cast<std::ptrdiff_t>(relief.grid.columns);
  std::copy(relief.height.begin() + columns * (band.from - band.first),
            relief.height.begin() + columns * (band.to - band.first),
            out.height.begin() + columns * band.from);
  const double step = out.grid.step, low = out.grid.plane_point(0, band.from).y() - 0.5 * step;
  const double high = out.grid.plane_point(0, band.to).y() - 0.5 * step;
  const bool lowest = band.from == 0, highest = band.to == out.grid.rows;
  for (const DimpleMark& mark : find_dimples(relief, find))
    if ((lowest || mark.place.y() >= low) && (highest || mark.place.y() < high))
      out.dimples.push_back(mark);
}

}  // namespace

BaseMaker base_on(const patch::SurfaceSampler& sampler) {
  return [sampler](SurfaceGrid flat) { return curved_grid(std::move(flat), sampler); };
}

BaseMaker base_of_patches(const patch::Dimples& dimples, const patch::TexturePlane& plane,
                          double reach) {
  require_positive("Reach", reach, "mm");
  auto known = std::make_shared<std::vector<patch::SurfacePoint>>();
  std::vector<Vec2> places;
  for (const patch::Dimple& dimple : dimples) {
    const Vec2 place = project(plane, dimple.surface.position);
    const bool seen = dimple.surface.normal.dot(plane.direction) < 0.0;
    if (dimple.state != patch::DimpleState::Cut || !place.allFinite() || !seen) continue;
    known->push_back(dimple.surface);
    places.push_back(place);
  }
  const auto index = std::make_shared<const PlaceIndex>(std::move(places));
  return [known, index, reach](SurfaceGrid grid) {
    grid.sag.assign(static_cast<std::size_t>(grid.cells()), kNone);
    grid.normal.assign(static_cast<std::size_t>(grid.cells()), Vec3f::UnitZ());
    patchmill::parallel_for(0, grid.rows, [&](int j) {
      for (int i = 0; i < grid.columns; ++i) {
        const Vec2 at = grid.plane_point(i, j);
        const std::size_t k = index->nearest(at);
        if (k == PlaceIndex::kNobody) continue;
        const patch::SurfacePoint& s = (*known)[k];
        if ((project(grid.plane, s.position) - at).norm() > reach) continue;
        const Vec3& d = grid.plane.direction;
        const auto cell = static_cast<std::size_t>(grid.number(i, j));
        grid.sag[cell] = (s.position - grid.plane.at(at)).dot(s.normal) / d.dot(s.normal);
        grid.normal[cell] = s.normal.cast<float>();
      }
    });
    return grid;
  };
}

TextureMarks simulate_texture(const ToolMotion& motion, const Cutter& cutter,
                              const SurfaceGrid& flat, const BaseMaker& base,
                              const TextureMarkOptions& options, const Progress& progress) {
  require_valid(flat);
  require_in_range("Halo", options.halo, 0.0, 1e6, "mm");
  require_memory(flat, 4.0 * static_cast<double>(flat.cells()), 0.0,
                 options.marks.memory_limit);  // before any list
  const std::vector<Band> bands = bands_of(flat, options);
  require_memory_of(flat, bands, options.marks.memory_limit);
  TextureMarks out;
  out.grid = flat;
  out.stock = options.marks.stock;
  out.height.assign(static_cast<std::size_t>(flat.cells()), static_cast<float>(kNone));
  for (const Band& band : bands) {
    SurfaceGrid grid = row_band(flat, band.first, band.last - band.first);
    if (base) grid = base(std::move(grid));
    const double done = static_cast<double>(band.from) / flat.rows;
    const double share = static_cast<double>(band.to - band.from) / flat.rows;
    const Progress part = [&](double s) { return go_on(progress, done + s * share); };
    const SimulatedRelief marks =
        simulate_marks(motion, cutter, grid, options.marks, progress ? part : Progress{});
    out.statistics.passes += marks.statistics.passes;
    out.statistics.evaluations += marks.statistics.evaluations;
    out.complete = marks.complete;
    if (!marks.complete) break;
    keep(marks.relief, band, options.find, out);
  }
  return out;
}

WindowComparison compare_window(const std::vector<DimpleMark>& found,
                                const std::vector<PlannedPlace>& planned, const Vec2& low,
                                const Vec2& high, double spacing) {
  require_positive("Spacing", spacing, "mm");
  require_finite("Window", low, "mm");
  require_finite("Window", high, "mm");
  if ((high - low).minCoeff() < 0.0)
    throw InputError("Window",
                     fmt::format("({}, {}) to ({}, {}) mm", low.x(), low.y(), high.x(), high.y()),
                     "give the least corner first.");
  const auto inside = [&](const Vec2& p) {
    return (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
  };
  std::vector<Vec2> places;
  std::vector<PlannedPlace> here;
  for (const PlannedPlace& plan : planned) {
    places.push_back(plan.place);
    if (inside(plan.place)) here.push_back(plan);
  }
  const PlaceIndex index(places);
  WindowComparison out;
  for (const DimpleMark& mark : found) {
    const std::size_t k = index.nearest(mark.place);
    const bool near = k != PlaceIndex::kNobody && (places[k] - mark.place).norm() <= 0.5 * spacing;
    if (inside(near ? places[k] : mark.place)) out.found.push_back(mark);
  }
  out.comparison = compare_with_plan(out.found, here, spacing);
  return out;
}

}  // namespace patchmill::marks

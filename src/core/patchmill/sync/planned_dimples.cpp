// Dimples as places of the tool tip; see planned_dimples.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/planned_dimples.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/require.h"

#include <algorithm>
#include <array>
#include <exception>

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/parallel_reduce.h>

namespace patchmill::sync {

namespace {

constexpr std::size_t kBatch = 1024;  // dimples: few enough to stay in the cache
constexpr std::size_t kUnderWay = 8;  // batches

Vec3 tip_of(const patch::Dimple& dimple, double radius, const Decimals& decimals) {
  const Vec3 centre = dimple.surface.position + (radius - dimple.depth) * dimple.surface.normal;
  return decimals.round(Vec3(centre - radius * Vec3::UnitZ()));
}

PlannedDimple planned_dimple(const patch::Dimples& dimples, std::size_t k, double radius,
                             const PhaseRule& rule, const Decimals& decimals) {
  return {tip_of(dimples[k], radius, decimals), dimples[k].surface.normal,
          contact_azimuth(dimples, k, rule), static_cast<std::int32_t>(k), dimples[k].patch};
}

bool is_cut(const patch::Dimple& dimple) {
  return dimple.state == patch::DimpleState::Cut;
}

using Range = tbb::blocked_range<std::size_t>;

// A batch under way, and the error that ended it, which is told in the batch's turn. Its memory serves one batch after
// the other.
struct Work {
  PlannedBatch batch;
  std::exception_ptr trouble;

  void clear() {
    batch.planned.clear();
    batch.turns.clear();
    batch.before.reset();
    batch.corners.clear();
    trouble = nullptr;
  }
};

// Dimples, and the batch that they are planned in.
struct Piece {
  Range range{0, 0};
  Work* work = nullptr;
};

void plan(const patch::Dimples& dimples, const Range& range, const Tool& tool,
          const Spindle& spindle, const PhaseRule& rule, const Decimals& decimals, Work& work) {
  work.clear();
  work.batch.planned.reserve(range.size());
  work.batch.turns.reserve(range.size());
  std::size_t before = range.begin();
  while (before > 0 && !is_cut(dimples[before - 1])) --before;
  Angle last;
  if (before > 0) {
    work.batch.before = planned_dimple(dimples, before - 1, tool.radius, rule, decimals);
    last = work.batch.before->azimuth;
  }
  for (std::size_t k = range.begin(); k < range.end(); ++k) {
    if (!is_cut(dimples[k])) continue;
    work.batch.planned.push_back(planned_dimple(dimples, k, tool.radius, rule, decimals));
    const Angle azimuth = work.batch.planned.back().azimuth;
    work.batch.turns.push_back(spindle_advance(last, azimuth, rule, tool, spindle).turns());
    last = azimuth;
  }
}

}  // namespace

std::vector<PlannedDimple> planned_dimples(const patch::Dimples& dimples, double radius,
                                           const PhaseRule& rule, const Decimals& decimals) {
  std::vector<PlannedDimple> planned;
  planned.reserve(dimples.size());
  for (std::size_t k = 0; k < dimples.size(); ++k)
    if (is_cut(dimples[k])) planned.push_back(planned_dimple(dimples, k, radius, rule, decimals));
  return planned;
}

void in_batches(const patch::Dimples& dimples, const Tool& tool, const Spindle& spindle,
                const PhaseRule& rule, const Decimals& decimals,
                const std::function<void(PlannedBatch&)>& prepare,
                const std::function<void(const PlannedBatch&)>& take) {
  // Batches end in their order and no more than kUnderWay are under way: the one that many before has ended.
  std::array<Work, kUnderWay> works;
  std::size_t next = 0;
  const auto begin = [&](tbb::flow_control& flow) {
    const Piece piece{Range(next, std::min(next + kBatch, dimples.size())),
                      &works[next / kBatch % kUnderWay]};
    if (piece.range.empty()) flow.stop();  // its memory may still be that of the last batch
    next = piece.range.end();
    return piece;
  };
  const auto work_on = [&](const Piece& piece) {
    Work& work = *piece.work;
    try {
      plan(dimples, piece.range, tool, spindle, rule, decimals, work);
      prepare(work.batch);
    } catch (const InputError&) {
      work.trouble = std::current_exception();
    }
    return piece.work;
  };
  const auto hand_on = [&](const Work* work) {
    if (!work->batch.planned.empty()) take(work->batch);
    if (work->trouble) std::rethrow_exception(work->trouble);
  };
  using tbb::filter_mode;
  tbb::parallel_pipeline(kUnderWay,
                         tbb::make_filter<void, Piece>(filter_mode::serial_in_order, begin) &
                             tbb::make_filter<Piece, Work*>(filter_mode::parallel, work_on) &
                             tbb::make_filter<Work*, void>(filter_mode::serial_in_order, hand_on));
}

PlannedExtent planned_extent(const patch::Dimples& dimples, double radius, const Decimals& decimals,
                             double safe_height) {
  const auto of_range = [&](const Range& range, PlannedExtent extent) {
    for (std::size_t k = range.begin(); k < range.end(); ++k) {
      if (!is_cut(dimples[k])) continue;
      ++extent.dimples;
      extent.gaps += k == 0 || !is_cut(dimples[k - 1]) || dimples[k - 1].patch != dimples[k].patch;
      const double z = tip_of(dimples[k], radius, decimals).z();
      if (extent.too_high >= 0 || !(z > safe_height)) continue;
      extent.too_high = static_cast<std::int32_t>(k);
      extent.z = z;
    }
    return extent;
  };
  const auto join = [](const PlannedExtent& a, const PlannedExtent& b) {
    const PlannedExtent& high = a.too_high >= 0 ? a : b;
    return PlannedExtent{a.dimples + b.dimples, a.gaps + b.gaps, high.too_high, high.z};
  };
  return tbb::parallel_reduce(Range(0, dimples.size(), kBatch), PlannedExtent{}, of_range, join);
}

constexpr double kMaxRadius = 1e5;  // mm: of larger ones a surface has no curvature left

void require_turning_tool(const Tool& tool, const Spindle& spindle) {
  require_positive("SpindleSpeed", spindle.speed * 60.0, "rpm");
  require_valid(tool);
  require_ball(tool, "textures are milled");
  require_in_range("BallRadius", tool.radius, 0.0, kMaxRadius, "mm");
}

void require_heights(double safe_height, double clearance_height) {
  require_finite("SafeHeight", safe_height, "mm");
  require_finite("ClearanceHeight", clearance_height, "mm");
  if (!(clearance_height >= safe_height))
    throw InputError("ClearanceHeight", fmt::format("{} mm", clearance_height),
                     fmt::format("give at least the safe height, {} mm.", safe_height));
}

namespace {

[[noreturn]] void refuse_height(double safe_height, double z, std::int32_t number) {
  throw InputError(
      "SafeHeight", fmt::format("{} mm", safe_height),
      fmt::format("the tool tip is at Z {:.3f} mm on dimple {}: give a greater safe height.", z,
                  number));
}

}  // namespace

void require_below(double safe_height, const std::vector<PlannedDimple>& planned, double lift) {
  for (const PlannedDimple& p : planned)
    if (p.tip.z() + lift > safe_height) refuse_height(safe_height, p.tip.z(), p.number);
}

void require_below(double safe_height, const PlannedExtent& extent) {
  if (extent.too_high >= 0) refuse_height(safe_height, extent.z, extent.too_high);
}

}  // namespace patchmill::sync

// Many places on a surface, in parallel; see projected_surface.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/projected_surface.h"

#include "patchmill/geometry/require.h"
#include "patchmill/geometry/stop.h"

#include <atomic>
#include <cmath>
#include <mutex>

#include <tbb/blocked_range.h>

namespace patchmill::patch {

ProjectedSurface::ProjectedSurface(const TexturePlane& plane, Angle steepest)
    : plane_(plane), least_cosine_(std::cos(steepest.radians())) {
  require_in_range("SteepestSlope", steepest.degrees(), 0.01, 89.9, "degrees");
}

std::vector<SurfaceSample> ProjectedSurface::sample(const std::vector<Vec2>& places,
                                                    const Progress& progress) const {
  std::vector<SurfaceSample> samples(places.size());
  std::atomic<bool> stop{false};
  std::atomic<std::size_t> done{0};
  std::mutex reporting;
  const tbb::blocked_range<std::size_t> all(0, places.size(), 2048);
  patchmill::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& part) {
    if (stop) return;
    sample_run(&places[part.begin()], &samples[part.begin()], part.size());
    done += part.size();
    if (!progress) return;
    const std::lock_guard<std::mutex> lock(reporting);
    if (!progress(static_cast<double>(done) / static_cast<double>(places.size()))) stop = true;
  });
  if (stop) samples.clear();
  return samples;
}

DimpleState ProjectedSurface::state_of(const Vec3& normal) const {
  const double cosine = normal.dot(-plane_.direction);
  if (cosine >= least_cosine_) return DimpleState::Cut;
  return cosine > 0.0 ? DimpleState::TooSteep : DimpleState::Undercut;
}

}  // namespace patchmill::patch

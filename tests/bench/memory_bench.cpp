// A box of 10^8 voxels of which 88 % are to be removed: voxel model, then the steady posture, then the feed
// fields. Counters in GiB: the largest resident memory of the process over all of it, and what was foreseen
// before anything was allocated. The limit is 4 GiB.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/voxel/peak_memory.h"
#include "patchmill/dcm/posture_field.h"
#include "patchmill/voxel/voxelise.h"

#include <cmath>

#include <benchmark/benchmark.h>

namespace patchmill {
namespace {

void model_posture_feed(benchmark::State& state) {
  constexpr double kSide = 464.0, kGib = 1024.0 * 1024.0 * 1024.0;
  const double part_side = kSide * std::cbrt(1.0 - 0.01 * double(state.range(0)));
  const Vec3 middle = Vec3::Constant(0.5 * kSide + 0.3), half = Vec3::Constant(0.5 * part_side);
  const mesh::TriangleMesh stock = mesh::box_mesh(Vec3::Zero(), Vec3::Constant(kSide));
  const mesh::TriangleMesh part = mesh::box_mesh(middle - half, middle + half);
  const mesh::TriangleBvh bvh(part);
  const voxel::MemoryEstimate need = voxel::estimate_memory(
      voxel::frame_over(mesh::bounds(stock), 1.0), mesh::volume(stock) - mesh::volume(part),
      mesh::surface_area(stock) + mesh::surface_area(part));
  voxel::VoxelOptions options;
  options.pitch = 1.0;
  for (auto _ : state) {
    const voxel::PeakMemory peak;
    const voxel::VoxelGrid grid = voxel::voxelise(stock, part, options);
    const double after_model = peak.bytes();
    const dcm::PostureField posture = dcm::steady_posture(grid, part, bvh);
    const double after_posture = peak.bytes();
    const dcm::FeedField feed = dcm::steady_feed(grid, {400.0 / 60.0, 800.0 / 60.0});
    benchmark::DoNotOptimize(feed.along[0].data());
    state.counters["GiB_model"] = after_model / kGib;
    state.counters["GiB_posture"] = after_posture / kGib;
    state.counters["GiB_peak"] = peak.bytes() / kGib;
    state.counters["GiB_foreseen"] = need.total() / kGib;
    state.counters["voxels_stored"] = double(grid.kind.size());
    state.counters["iterations"] = posture.outcome.iterations;
    state.counters["residual"] = posture.outcome.true_residual;
  }
}

// per cent to be removed
BENCHMARK(model_posture_feed)->Arg(88)->Iterations(1)->UseRealTime()->Unit(benchmark::kSecond);

}  // namespace
}  // namespace patchmill

// Voxelisation of a B-rep solid in its box: OpenCASCADE's point classifier asked at every voxel's centre (at 64^3,
// its time goes with the number of voxels) beside tessellation and line parity at 64^3 to 1024^3.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/tessellate.h"
#include "patchmill/voxel/voxelise.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopoDS_Shape.hxx>
#include <benchmark/benchmark.h>

namespace patchmill {
namespace {

constexpr double kSide = 64.0;  // of the stock [mm]

// A ball with a ring cut out of it, in the middle of the stock.
TopoDS_Shape part() {
  const gp_Pnt middle(kSide / 2, kSide / 2, kSide / 2);
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(middle, 28.0).Shape();
  const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(gp_Ax2(middle, gp::DZ()), 26.0, 6.0).Shape();
  return BRepAlgoAPI_Cut(ball, ring).Shape();
}

void opencascade_classifier(benchmark::State& state) {
  BRepClass3d_SolidClassifier classifier(part());
  const int n = static_cast<int>(state.range(0));
  const double pitch = kSide / n;
  std::int64_t inside = 0, asked = 0;
  for (auto _ : state)
    for (int k = 0; k < n; ++k)  // every eighth layer: the time goes with the number of points
      for (int j = 0; j < n && k % 8 == 4; ++j)
        for (int i = 0; i < n; ++i, ++asked) {
          classifier.Perform(gp_Pnt((i + 0.5) * pitch, (j + 0.5) * pitch, (k + 0.5) * pitch), 1e-7);
          inside += classifier.State() == TopAbs_IN ? 1 : 0;
        }
  benchmark::DoNotOptimize(inside);
  state.SetItemsProcessed(asked);
}

void patchmill_voxelise_solid(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  TessellationOptions fine;
  fine.deflection = 0.05 * kSide / n;
  const TopoDS_Shape shape = part();
  const mesh::TriangleMesh stock = mesh::box_mesh(Vec3::Zero(), Vec3::Constant(kSide));
  voxel::VoxelOptions options;
  options.pitch = kSide / n;
  options.memory_limit = 64e9;  // kinds only: no field is made here
  std::size_t triangles = 0;
  for (auto _ : state) {
    const Tessellation mesh = tessellate(shape, fine);
    triangles = mesh.mesh.triangles.size();
    benchmark::DoNotOptimize(voxel::voxelise(stock, mesh.mesh, options));
  }
  state.SetItemsProcessed(std::int64_t{n} * n * n * state.iterations());
  state.counters["triangles"] = static_cast<double>(triangles);
}

BENCHMARK(opencascade_classifier)->Arg(64)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(patchmill_voxelise_solid)
    ->Arg(64)
    ->Arg(256)
    ->Arg(512)
    ->Arg(1024)
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace patchmill

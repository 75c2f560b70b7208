// Dimples on a sphere: the patches, the path at constant feed, and how far each dimple is from the phase it wants.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <cstdio>
#include <patchmill/geometry/error.h>
#include <patchmill/patch/boundary.h>
#include <patchmill/patch/cover.h>
#include <patchmill/patch/patch_surface.h>
#include <patchmill/sync/constant_feed.h>
#include <patchmill/sync/contact_azimuth.h>
#include <patchmill/sync/phase_error.h>

using namespace patchmill;

namespace {

constexpr double kSphere = 40.0;  // mm

// The faces, as the core sees them: where a ray down from a place of the texture plane meets them.
std::vector<patch::SurfaceSample> sample(const std::vector<Vec2>& places) {
  std::vector<patch::SurfaceSample> samples;
  for (const Vec2& p : places) {
    patch::SurfaceSample found;
    if (p.norm() < 0.9 * kSphere) {
      const Vec3 point(p.x(), p.y(), std::sqrt(kSphere * kSphere - p.squaredNorm()));
      found = {{point, point / kSphere}, patch::DimpleState::Cut};
    }
    samples.push_back(found);
  }
  return samples;
}

int run() {
  const patch::TexturePlane plane;
  const patch::PatchDivision division =
      patch::cover({patch::PatchShape::Hexagon, 0.5, 6}, {Vec2(5, -4), Vec2(15, 4)});
  auto dimples = patch::sample_patches(division, plane, sample, {patch::SurfaceKind::Pyramid});
  if (!dimples) return 1;
  const Tool ball{1.0, 2};
  const Spindle spindle{1000.0 / 60.0, SpindleSense::M3};
  sync::mark_tool_tip(*dimples, Vec3::UnitZ(), Angle::degrees(3));
  const sync::ConstantFeed rule{400.0 / 60.0, {sync::FluteChoice::Same, 5.0, {}}, 45.0, 50.0};
  const ToolPath path = sync::constant_feed_path(*dimples, ball, spindle, rule, Decimals(3));
  const PathStatistics done = statistics(path);
  std::printf("%lld dimples in %zu patches, %.0f mm cut in %.1f s\n",
              static_cast<long long>(done.dimples), division.cells.size(), done.cut_length,
              done.timed_seconds);
  return done.dimples > 100 ? 0 : 1;
}

}  // namespace

int main() {
  try {
    return run();
  } catch (const InputError& error) {  // property, value and remedy
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

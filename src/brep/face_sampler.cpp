// Many points on many faces, in parallel; see face_sampler.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/face_sampler.h"

#include "brep/face_projection.h"
#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <fmt/format.h>
#include <tbb/blocked_range.h>

namespace patchmill {

FaceSampler::FaceSampler(const std::vector<TopoDS_Face>& faces, const patch::TexturePlane& plane,
                         Angle steepest)
    : plane_(plane), least_cosine_(std::cos(steepest.radians())) {
  require_in_range("SteepestSlope", steepest.degrees(), 0.01, 89.9, "degrees");
  if (faces.empty()) throw InputError("Base", "no face", "select at least one face.");
  for (const TopoDS_Face& face : faces) {
    const std::string which = fmt::format("face {}", faces_.size() + 1);
    if (BRep_Tool::Surface(face).IsNull())
      throw InputError("Base", which, "it has no surface: repair the shape.");
    try {
      faces_.push_back(std::make_unique<FaceProjection>(face, plane));
    } catch (const Standard_Failure& e) {
      throw InputError("Base", which, std::string(e.GetMessageString()) + ": repair the shape.");
    }
  }
}

FaceSampler::~FaceSampler() = default;
FaceSampler::FaceSampler(FaceSampler&&) noexcept = default;
FaceSampler& FaceSampler::operator=(FaceSampler&&) noexcept = default;

std::vector<patch::SurfaceSample> FaceSampler::sample(const std::vector<Vec2>& points,
                                                      const Progress& progress) const {
  std::vector<patch::SurfaceSample> samples(points.size());
  std::atomic<bool> stop{false};
  std::atomic<std::size_t> done{0};
  std::mutex reporting;
  const tbb::blocked_range<std::size_t> all(0, points.size(), 2048);
  patchmill::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& part) {
    if (stop) return;
    std::vector<FaceProjection::Worker> workers;
    for (const auto& face : faces_) workers.push_back(face->worker());
    for (std::size_t i = part.begin(); i < part.end(); ++i) {
      std::optional<Hit> first;
      for (std::size_t f = 0; f < faces_.size(); ++f) {
        const std::optional<Hit> hit = faces_[f]->first_hit(points[i], workers[f]);
        if (hit && (!first || hit->depth < first->depth)) first = hit;
      }
      if (first) samples[i] = {first->point, state_of(first->point.normal)};
    }
    done += part.size();
    if (!progress) return;
    const std::lock_guard<std::mutex> lock(reporting);
    if (!progress(static_cast<double>(done) / static_cast<double>(points.size()))) stop = true;
  });
  if (stop) samples.clear();
  return samples;
}

patch::DimpleState FaceSampler::state_of(const Vec3& normal) const {
  const double cosine = normal.dot(-plane_.direction);
  if (cosine >= least_cosine_) return patch::DimpleState::Cut;
  return cosine > 0.0 ? patch::DimpleState::TooSteep : patch::DimpleState::Undercut;
}

std::pair<Vec2, Vec2> FaceSampler::extent() const {
  Vec2 low = faces_.front()->low(), high = faces_.front()->high();
  for (const auto& face : faces_) {
    low = low.cwiseMin(face->low());
    high = high.cwiseMax(face->high());
  }
  return {low, high};
}

long FaceSampler::fallbacks() const {
  long sum = 0;
  for (const auto& face : faces_) sum += face->fallbacks();
  return sum;
}

}  // namespace patchmill

// Many points on many faces, in parallel; see face_sampler.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/face_sampler.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <unordered_map>

#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <fmt/format.h>
#include <tbb/blocked_range.h>

namespace patchmill {
namespace {

constexpr double kAnywhere = 1e9;  // mm, of a face that nobody knows where it is
constexpr std::size_t kLook = 16;  // points between looks whether to stop

[[noreturn]] void refuse(std::size_t face, const Standard_Failure& reason) {
  throw InputError("Base", fmt::format("face {}", face + 1),
                   std::string(reason.GetMessageString()) + ": repair the shape.");
}

}  // namespace

FaceSampler::FaceSampler(const std::vector<TopoDS_Face>& faces, const patch::TexturePlane& plane,
                         Angle steepest)
    : plane_(plane), least_cosine_(std::cos(steepest.radians())) {
  require_in_range("SteepestSlope", steepest.degrees(), 0.01, 89.9, "degrees");
  if (faces.empty()) throw InputError("Base", "no face", "select at least one face.");
  for (const TopoDS_Face& face : faces) {
    if (BRep_Tool::Surface(face).IsNull())
      throw InputError("Base", fmt::format("face {}", faces_.size() + 1),
                       "it has no surface: repair the shape.");
    try {
      faces_.push_back(std::make_unique<FaceProjection>(face, plane));
    } catch (const Standard_Failure& e) {
      refuse(faces_.size(), e);
    }
  }
  std::vector<PlanBox> boxes;
  for (const auto& face : faces_) {
    const PlanBox box = face->box();
    const bool known = box.low.allFinite() && box.high.allFinite();
    boxes.push_back(known ? box : PlanBox{Vec2::Constant(-kAnywhere), Vec2::Constant(kAnywhere)});
  }
  bins_ = FaceBins(boxes);
}

// Of the faces that are met: neighbours mostly lie on the same.
class FaceSampler::Workers {
 public:
  FaceProjection::Worker& of(std::int32_t number, const FaceProjection& face) {
    if (last_ && number == number_) return *last_;
    auto known = all_.find(number);
    if (known == all_.end()) known = all_.emplace(number, face.worker()).first;
    number_ = number;
    last_ = &known->second;
    return *last_;
  }

 private:
  std::unordered_map<std::int32_t, FaceProjection::Worker> all_;
  FaceProjection::Worker* last_ = nullptr;
  std::int32_t number_ = 0;
};

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
    Workers workers;
    for (std::size_t i = part.begin(); i < part.end(); ++i) {
      if (i % kLook == 0) stop_point();
      const std::optional<Hit> first = first_hit(points[i], workers);
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

std::optional<Hit> FaceSampler::first_hit(const Vec2& place, Workers& workers) const {
  std::optional<Hit> first;
  for (const std::int32_t f : bins_.over(place)) {
    const FaceProjection& face = *faces_[std::size_t(f)];
    try {
      const std::optional<Hit> hit = face.first_hit(place, workers.of(f, face));
      if (hit && (!first || hit->depth < first->depth)) first = hit;
    } catch (const Standard_Failure& e) {
      refuse(std::size_t(f), e);
    }
  }
  return first;
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

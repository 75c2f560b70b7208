// Many points on many faces, in parallel; see face_sampler.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/face_sampler.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"

#include <algorithm>
#include <unordered_map>

#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <fmt/format.h>

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
    : patch::ProjectedSurface(plane, steepest) {
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

void FaceSampler::sample_run(const Vec2* places, patch::SurfaceSample* samples,
                             std::size_t count) const {
  Workers workers;
  for (std::size_t i = 0; i < count; ++i) {
    if (i % kLook == 0) stop_point();
    const std::optional<Hit> first = first_hit(places[i], workers);
    if (first) samples[i] = {first->point, state_of(first->point.normal)};
  }
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

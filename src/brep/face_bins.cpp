// Bins of faces; see face_bins.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/face_bins.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace patchmill {
namespace {

constexpr int kMostSide = 1024;  // of bins
constexpr std::int64_t kEntries =
    16;  // for each face, on average: more bins would hold large faces too often

}  // namespace

FaceBins::FaceBins(const std::vector<PlanBox>& boxes) : all_(boxes.front()) {
  for (const PlanBox& box : boxes) {
    all_.low = all_.low.cwiseMin(box.low);
    all_.high = all_.high.cwiseMax(box.high);
  }
  const auto count = static_cast<std::int64_t>(boxes.size());
  int side = std::clamp(static_cast<int>(std::ceil(std::sqrt(double(count)))), 1, kMostSide);
  const auto entries = [&](int bins) {
    columns_ = rows_ = bins;
    size_ = ((all_.high - all_.low) / bins).cwiseMax(Vec2::Constant(1e-9));
    return std::accumulate(boxes.begin(), boxes.end(), std::int64_t{0},
                           [&](std::int64_t sum, const PlanBox& box) {
                             const Bins b = bins_of(box);
                             return sum + std::int64_t{b.x1 - b.x0 + 1} * (b.y1 - b.y0 + 1);
                           });
  };
  while (entries(side) > kEntries * count && side > 1) side /= 2;

  const auto each_bin = [&](const auto& visit) {
    for (std::size_t face = 0; face < boxes.size(); ++face) {
      const Bins b = bins_of(boxes[face]);
      for (int y = b.y0; y <= b.y1; ++y)
        for (int x = b.x0; x <= b.x1; ++x) visit(std::size_t(y * columns_ + x), face);
    }
  };
  begin_.assign(std::size_t(columns_) * std::size_t(rows_) + 1, 0);
  each_bin([&](std::size_t bin, std::size_t) { ++begin_[bin + 1]; });
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  faces_.resize(std::size_t(begin_.back()));
  std::vector<std::int32_t> next = begin_;
  each_bin([&](std::size_t bin, std::size_t face) {
    faces_[std::size_t(next[bin]++)] = static_cast<std::int32_t>(face);
  });
}

// Both grow with their argument, so that a place in a box is in a bin of the box, however it is rounded.
int FaceBins::column(double x) const {
  return std::clamp(static_cast<int>((x - all_.low.x()) / size_.x()), 0, columns_ - 1);
}

int FaceBins::row(double y) const {
  return std::clamp(static_cast<int>((y - all_.low.y()) / size_.y()), 0, rows_ - 1);
}

FaceBins::Bins FaceBins::bins_of(const PlanBox& box) const {
  return {column(box.low.x()), column(box.high.x()), row(box.low.y()), row(box.high.y())};
}

FaceBins::Range FaceBins::over(const Vec2& p) const {
  const bool within =
      (p.array() >= all_.low.array()).all() && (p.array() <= all_.high.array()).all();
  if (begin_.empty() || !within) return {nullptr, nullptr};
  const auto bin = std::size_t(row(p.y()) * columns_ + column(p.x()));
  return {faces_.data() + begin_[bin], faces_.data() + begin_[bin + 1]};
}

}  // namespace patchmill

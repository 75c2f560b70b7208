// Buckets of places; see place_index.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/marks/place_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace patchmill::marks {

PlaceIndex::PlaceIndex(std::vector<Vec2> places) : places_(std::move(places)) {
  if (places_.empty()) return;
  Vec2 high = places_.front();
  low_ = high;
  for (const Vec2& p : places_) {
    low_ = low_.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  // about two places to a bucket; long thin sets get one row of them
  const Vec2 span = high - low_;
  const double count = static_cast<double>(places_.size());
  size_ = std::max({std::sqrt(2.0 * span.x() * span.y() / count), span.maxCoeff() / count, 1e-9});
  columns_ = 1 + static_cast<int>(span.x() / size_);
  rows_ = 1 + static_cast<int>(span.y() / size_);
  first_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
  const auto bucket = [&](const Vec2& p) {
    return static_cast<std::size_t>(row_of(p.y())) * columns_ + column_of(p.x());
  };
  for (const Vec2& p : places_) ++first_[bucket(p) + 1];
  for (std::size_t b = 1; b < first_.size(); ++b) first_[b] += first_[b - 1];
  numbers_.resize(places_.size());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t k = 0; k < places_.size(); ++k) numbers_[next[bucket(places_[k])]++] = k;
}

int PlaceIndex::column_of(double x) const {
  return static_cast<int>(std::clamp((x - low_.x()) / size_, 0.0, columns_ - 1.0));
}
int PlaceIndex::row_of(double y) const {
  return static_cast<int>(std::clamp((y - low_.y()) / size_, 0.0, rows_ - 1.0));
}

std::size_t PlaceIndex::nearest(const Vec2& at, std::size_t except) const {
  std::size_t best = kNobody;
  double distance = std::numeric_limits<double>::infinity();
  if (places_.empty()) return best;
  const int i = column_of(at.x()), j = row_of(at.y());
  // rings of buckets about the one of `at`; ring r holds nothing nearer than (r - 1) buckets, and
  // `at` may be outside the buckets, which only adds to that
  for (int r = 0; r <= std::max(columns_, rows_); ++r) {
    if ((r - 1) * size_ > distance) break;
    for (int jj = std::max(j - r, 0); jj <= std::min(j + r, rows_ - 1); ++jj) {
      const bool whole = std::abs(jj - j) == r;
      for (int ii = i - r; ii <= i + r; ii += whole || r == 0 ? 1 : 2 * r) {
        if (ii < 0 || ii >= columns_) continue;
        const std::size_t b = static_cast<std::size_t>(jj) * columns_ + ii;
        for (std::size_t n = first_[b]; n < first_[b + 1]; ++n) {
          const std::size_t k = numbers_[n];
          const double d = (places_[k] - at).norm();
          if (k == except || d > distance || (d == distance && k > best)) continue;
          best = k;
          distance = d;
        }
      }
    }
  }
  return best;
}

std::vector<std::size_t> PlaceIndex::within(const Vec2& at, double radius) const {
  std::vector<std::size_t> found;
  if (places_.empty()) return found;
  for (int j = row_of(at.y() - radius); j <= row_of(at.y() + radius); ++j)
    for (int i = column_of(at.x() - radius); i <= column_of(at.x() + radius); ++i) {
      const std::size_t b = static_cast<std::size_t>(j) * columns_ + i;
      for (std::size_t n = first_[b]; n < first_[b + 1]; ++n)
        if ((places_[numbers_[n]] - at).norm() <= radius) found.push_back(numbers_[n]);
    }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace patchmill::marks

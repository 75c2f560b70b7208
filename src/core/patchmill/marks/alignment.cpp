// Shifts of marks from row to row; see alignment.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/marks/alignment.h"

#include "patchmill/geometry/angle.h"
#include "patchmill/geometry/require.h"
#include "patchmill/marks/place_index.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>

namespace patchmill::marks {
namespace {

using Phasor = std::complex<double>;

Phasor phasor(double share) {
  return std::polar(1.0, 2.0 * kPi * share);
}
double share_of(const Phasor& p) {
  const double share = std::arg(p) / (2.0 * kPi);
  return share < 0.0 ? share + 1.0 : share;
}

struct RowSum {
  Phasor sum;
  int pairs = 0;
};

/// Sum of the shifts from each mark to the marks of the next row, by row.
std::map<int, RowSum> sum_shifts(const std::vector<Vec2>& places, const RowLayout& layout) {
  const Vec2 u = layout.feed.normalized(), v(-u.y(), u.x());
  const double f = layout.feed_per_tooth, p = layout.cross_feed;
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vec2& place : places) lowest = std::min(lowest, place.dot(v));
  const PlaceIndex index(places);
  std::map<int, RowSum> rows;
  for (const Vec2& place : places)
    for (const std::size_t other : index.within(place, std::hypot(1.5 * p, 0.75 * f))) {
      const Vec2 step = places[other] - place;
      if (std::abs(step.dot(v) - p) > 0.5 * p || std::abs(step.dot(u)) > 0.75 * f) continue;
      RowSum& row = rows[static_cast<int>(std::lround((place.dot(v) - lowest) / p))];
      row.sum += phasor(step.dot(u) / f);
      ++row.pairs;
    }
  return rows;
}

double distance_round(double a, double b) {
  return std::abs(a - b - std::round(a - b));
}

Alignment state_of(const AlignmentResult& result, const AlignmentOptions& options) {
  if (result.rows.empty()) return Alignment::Unknown;
  if (result.row_agreement < options.least_row_agreement) return Alignment::Irregular;
  if (result.agreement < options.least_agreement) return Alignment::Drifting;
  if (distance_round(result.shift, 0.0) <= options.shift_tolerance) return Alignment::Square;
  if (distance_round(result.shift, 0.5) <= options.shift_tolerance) return Alignment::Staggered;
  return Alignment::Skewed;
}

}  // namespace

const char* name(Alignment alignment) {
  switch (alignment) {
    case Alignment::Square:
      return "square";
    case Alignment::Staggered:
      return "staggered";
    case Alignment::Skewed:
      return "skewed";
    case Alignment::Drifting:
      return "drifting";
    case Alignment::Irregular:
      return "irregular";
    default:
      return "unknown";
  }
}

AlignmentResult classify_alignment(const std::vector<Vec2>& places, const RowLayout& layout,
                                   const AlignmentOptions& options) {
  require_positive("FeedPerTooth", layout.feed_per_tooth, "mm");
  require_positive("CrossFeed", layout.cross_feed, "mm");
  require_in_range("FeedDirection", layout.feed.norm(), 1e-9, 1e9, "long");
  for (const Vec2& place : places) require_finite("Places", place, "mm");
  AlignmentResult result;
  Phasor all;
  double pairs = 0.0, sums = 0.0;
  for (const auto& [row, sum] : sum_shifts(places, layout)) {
    if (sum.pairs < 2) continue;  // one mark agrees with itself
    const double agreement = std::abs(sum.sum) / sum.pairs;
    result.rows.push_back({row, share_of(sum.sum), agreement, sum.pairs});
    all += sum.sum;  // a row counts by its marks: a stray one makes no row of its own
    sums += std::abs(sum.sum);
    result.row_agreement += agreement * sum.pairs;
    pairs += sum.pairs;
  }
  if (!result.rows.empty()) {
    result.row_agreement /= pairs;
    result.agreement = sums > 0.0 ? std::abs(all) / sums : 0.0;
    result.shift = share_of(all);
  }
  result.state = state_of(result, options);
  return result;
}

}  // namespace patchmill::marks

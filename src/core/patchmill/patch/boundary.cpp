// Steepness, margin and slivers; see boundary.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/boundary.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <fmt/format.h>

namespace patchmill::patch {
namespace {

double distance(const Vec3& p, const Segment3& s) {
  const Vec3 along = s.b - s.a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - s.a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (p - s.a - t * along).norm();
}

// Segments by the cubes of the grid that they come near to: one look-up finds all segments within
// one cube's side of a point.
class SegmentGrid {
 public:
  SegmentGrid(const std::vector<Segment3>& segments, double margin) : segments_(segments) {
    double length = 0.0;
    for (const Segment3& s : segments) length += (s.b - s.a).norm();
    cube_ = std::max(margin, 1e-5 * length);
    for (int n = 0; n < static_cast<int>(segments.size()); ++n) insert(n);
  }

  bool any_within(const Vec3& p, double margin) const {
    const auto found = cubes_.find(key(p));
    return found != cubes_.end() &&
           std::any_of(found->second.begin(), found->second.end(),
                       [&](int n) { return distance(p, segments_[n]) < margin; });
  }

 private:
  using Key = std::array<std::int64_t, 3>;
  struct Hash {
    std::size_t operator()(const Key& k) const {
      std::uint64_t h = 0;
      for (std::int64_t x : k)
        h = (h ^ static_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15ull + (h >> 29);
      return h;
    }
  };

  Key key(const Vec3& p) const {
    Key k;
    for (int i = 0; i < 3; ++i) k[i] = static_cast<std::int64_t>(std::floor(p[i] / cube_));
    return k;
  }

  // Steps of half a cube: the cubes around each step hold all points within `cube_` of the segment
  // that lie half a step or less along it from there.
  void insert(int n) {
    const Segment3& s = segments_[n];
    const int steps = 1 + static_cast<int>(2.0 * (s.b - s.a).norm() / cube_);
    for (int i = 0; i <= steps; ++i) {
      const Key at = key(s.a + (s.b - s.a) * (double(i) / steps));
      for (int dx = -2; dx <= 2; ++dx)
        for (int dy = -2; dy <= 2; ++dy)
          for (int dz = -2; dz <= 2; ++dz) {
            std::vector<int>& in = cubes_[{at[0] + dx, at[1] + dy, at[2] + dz}];
            if (in.empty() || in.back() != n) in.push_back(n);
          }
    }
  }

  const std::vector<Segment3>& segments_;
  double cube_ = 1.0;
  std::unordered_map<Key, std::vector<int>, Hash> cubes_;
};

}  // namespace

void limit_steepness(Dimples& dimples, const Vec3& direction, Angle limit) {
  if (!(limit.degrees() > 0.0 && limit.degrees() <= 90.0 + 1e-9))
    throw InputError("SteepnessLimit", fmt::format("{}°", limit.degrees()),
                     "give an angle above 0° and up to 90°.");
  const double least = std::cos(limit.radians());
  for (Dimple& dimple : dimples) {
    if (dimple.state != DimpleState::Cut) continue;
    const double facing = -dimple.surface.normal.dot(direction);
    if (facing <= 0.0)
      dimple.state = DimpleState::Undercut;
    else if (facing < least)
      dimple.state = DimpleState::TooSteep;
  }
}

void keep_off_edges(Dimples& dimples, const std::vector<Segment3>& edges, double margin) {
  if (!(std::isfinite(margin) && margin >= 0.0))
    throw InputError("Margin", fmt::format("{} mm", margin), "give zero or a positive length.");
  if (margin == 0.0 || edges.empty()) return;
  const SegmentGrid grid(edges, margin);
  patchmill::parallel_for(std::size_t{0}, dimples.size(), [&](std::size_t k) {
    Dimple& dimple = dimples[k];
    if (dimple.state == DimpleState::Cut && grid.any_within(dimple.surface.position, margin))
      dimple.state = DimpleState::NearEdge;
  });
}

void drop_slivers(Dimples& dimples, int least) {
  require_in_range("MinimumDimples", least, 0, 1e9, "dimples");
  for (std::size_t first = 0, last = 0; first < dimples.size(); first = last) {
    int cut = 0;
    for (last = first; last < dimples.size() && dimples[last].patch == dimples[first].patch; ++last)
      cut += dimples[last].state == DimpleState::Cut;
    if (cut >= least) continue;
    for (std::size_t k = first; k < last; ++k)
      if (dimples[k].state == DimpleState::Cut) dimples[k].state = DimpleState::Sliver;
  }
}

}  // namespace patchmill::patch

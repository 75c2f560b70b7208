// NearPoints: points in space in cubes of one size, to find those that are near a place.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace patchmill::patch {

/// Points by the cubes that they are in.
class NearPoints {
 public:
  /// `cube` [mm], > 0: side of a cube, and the greatest distance that can be asked for.
  explicit NearPoints(double cube) : cube_(cube) {}

  /// Adds a point [mm] with its number.
  void add(const Vec3& p, std::size_t number) { cubes_[key(p)].push_back({p, number}); }

  /// Calls `see(number, squared distance)` for all points within a cube's side of `p`, and some further ones.
  template <class See>
  void around(const Vec3& p, See see) const {
    const Key at = key(p);
    for (std::int64_t x = at[0] - 1; x <= at[0] + 1; ++x)
      for (std::int64_t y = at[1] - 1; y <= at[1] + 1; ++y)
        for (std::int64_t z = at[2] - 1; z <= at[2] + 1; ++z) {
          const auto found = cubes_.find({x, y, z});
          if (found == cubes_.end()) continue;
          for (const Entry& e : found->second) see(e.number, (e.point - p).squaredNorm());
        }
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
  struct Entry {
    Vec3 point;
    std::size_t number;
  };
  Key key(const Vec3& p) const {
    Key k;
    for (int i = 0; i < 3; ++i) k[i] = static_cast<std::int64_t>(std::floor(p[i] / cube_));
    return k;
  }

  double cube_;
  std::unordered_map<Key, std::vector<Entry>, Hash> cubes_;
};

}  // namespace patchmill::patch

// Image and curve masks and what they do to dimples; see mask.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/mask.h"

#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

namespace patchmill::patch {
namespace {

struct Edge {
  Vec2 a, b;
};

// Edges of closed loops in bands of y, so that a query looks only at those that its level may
// cross.
class EvenOdd {
 public:
  explicit EvenOdd(const std::vector<Polygon>& loops) {
    std::vector<Edge> edges;
    for (const Polygon& loop : loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        edges.push_back({loop[i], loop[(i + 1) % loop.size()]});
        box_.extend(loop[i]);
      }
    bands_.resize(std::clamp<std::size_t>(edges.size() / 2, 1, 4096));
    for (const Edge& edge : edges) {
      const auto [low, high] = std::minmax(edge.a.y(), edge.b.y());
      for (std::size_t k = band(low); k <= band(high); ++k) bands_[k].push_back(edge);
    }
  }

  bool inside(const Vec2& p) const {
    if (bands_.empty() || !box_.contains(p)) return false;
    bool odd = false;
    for (const Edge& e : bands_[band(p.y())])
      if ((e.a.y() > p.y()) != (e.b.y() > p.y()) &&
          p.x() < e.a.x() + (p.y() - e.a.y()) / (e.b.y() - e.a.y()) * (e.b.x() - e.a.x()))
        odd = !odd;
    return odd;
  }

 private:
  std::size_t band(double y) const {
    const double height = box_.sizes().y();
    const double share = height > 0.0 ? (y - box_.min().y()) / height : 0.0;
    return std::min(bands_.size() - 1,
                    static_cast<std::size_t>(std::max(0.0, share) * double(bands_.size())));
  }

  Box2 box_;
  std::vector<std::vector<Edge>> bands_;
};

// Rank of a lattice point in the 8 x 8 dither matrix, 0..63: bits of i xor j and of j, interleaved
// from the lowest, which come first.
int dither_rank(const LatticePoint& p) {
  const int x = (p[0] ^ p[1]) & 7, y = p[1] & 7;
  int rank = 0;
  for (int bit = 0; bit < 3; ++bit) rank = rank << 2 | ((x >> bit) & 1) << 1 | ((y >> bit) & 1);
  return rank;
}

template <typename Change>
void change_cut(Dimples& dimples, const LatticePlace& place_of, const Mask& mask, Change change) {
  for (Dimple& dimple : dimples)
    if (dimple.state == DimpleState::Cut) change(dimple, mask(place_of(to_vec(dimple.lattice))));
}

}  // namespace

Mask image_mask(Image image, const Box2& area, double outside) {
  if (image.columns < 1 || image.rows < 1 ||
      image.values.size() != std::size_t(image.columns) * std::size_t(image.rows))
    throw InputError(
        "Image",
        fmt::format("{} x {} with {} values", image.columns, image.rows, image.values.size()),
        "give one value for each pixel.");
  for (float v : image.values)
    if (!(v >= 0.0f && v <= 1.0f))
      throw InputError("Image", fmt::format("value {}", v), "give values from 0 to 1.");
  if (area.isEmpty() || !(area.sizes().minCoeff() > 0.0) || !area.sizes().allFinite())
    throw InputError("MaskArea", "empty or infinite", "give two different finite corners.");
  require_in_range("MaskOutside", outside, 0.0, 1.0, "");
  const auto shared = std::make_shared<const Image>(std::move(image));
  return [shared, area, outside](const Vec2& p) {
    if (!area.contains(p)) return outside;
    const Image& im = *shared;
    const Vec2 share = (p - area.min()).cwiseQuotient(area.sizes());
    const double x = std::clamp(share.x() * im.columns - 0.5, 0.0, im.columns - 1.0);
    const double y = std::clamp((1.0 - share.y()) * im.rows - 0.5, 0.0, im.rows - 1.0);
    const int c = std::min(int(x), std::max(0, im.columns - 2));
    const int r = std::min(int(y), std::max(0, im.rows - 2));
    auto value = [&](int dc, int dr) {
      const int cc = std::min(c + dc, im.columns - 1), rr = std::min(r + dr, im.rows - 1);
      return double(im.values[std::size_t(rr) * std::size_t(im.columns) + std::size_t(cc)]);
    };
    const double u = x - c, v = y - r;
    return (1 - v) * ((1 - u) * value(0, 0) + u * value(1, 0)) +
           v * ((1 - u) * value(0, 1) + u * value(1, 1));
  };
}

Mask curve_mask(std::vector<Polygon> loops) {
  for (const Polygon& loop : loops) {
    const bool finite =
        std::all_of(loop.begin(), loop.end(), [](const Vec2& p) { return p.allFinite(); });
    if (loop.size() < 3 || !finite)
      throw InputError("Curves", fmt::format("a loop of {} points", loop.size()),
                       "give closed loops of at least three finite points.");
  }
  const auto index = std::make_shared<const EvenOdd>(loops);
  return [index](const Vec2& p) { return index->inside(p) ? 1.0 : 0.0; };
}

void keep_where(Dimples& dimples, const LatticePlace& place_of, const Mask& mask,
                double threshold) {
  require_in_range("Threshold", threshold, 0.0, 1.0, "");
  change_cut(dimples, place_of, mask, [&](Dimple& dimple, double value) {
    if (value < threshold) dimple.state = DimpleState::Masked;
  });
}

void thin_out(Dimples& dimples, const LatticePlace& place_of, const Mask& mask) {
  change_cut(dimples, place_of, mask, [&](Dimple& dimple, double value) {
    if (value * 64.0 <= dither_rank(dimple.lattice)) dimple.state = DimpleState::Masked;
  });
}

void set_depth(Dimples& dimples, const LatticePlace& place_of, const Mask& mask, double depth_at_0,
               double depth_at_1, double least) {
  require_in_range("Depth", depth_at_0, 0.0, 1e3, "mm");
  require_in_range("Depth", depth_at_1, 0.0, 1e3, "mm");
  require_in_range("MinimumDepth", least, 0.0, 1e3, "mm");
  change_cut(dimples, place_of, mask, [&](Dimple& dimple, double value) {
    dimple.depth = depth_at_0 + value * (depth_at_1 - depth_at_0);
    if (dimple.depth < least) dimple.state = DimpleState::Masked;
  });
}

}  // namespace patchmill::patch

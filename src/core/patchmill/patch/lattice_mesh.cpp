// Growth of lattices over sampled surfaces; see lattice_mesh.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/lattice_mesh.h"

#include <algorithm>

namespace patchmill::patch {
namespace {

// A missing node completes parallelograms a + b - c over the net's border: a and b are next to it
// and to each other, c is across from it. Calls `take(a, b, c)` with the indices of each.
template <typename Take>
int parallelograms(const LatticeMesh& mesh, const LatticePoint& p, Take take) {
  int count = 0;
  for (int s = 0; s < 6; ++s) {
    const LatticePoint at_a = neighbour(p, s);
    const int a = mesh.find(at_a), b = mesh.find(neighbour(p, s + 1));
    const int c = mesh.find(neighbour(at_a, s + 1));
    if (a < 0 || b < 0 || c < 0) continue;
    take(a, b, c);
    ++count;
  }
  return count;
}

// A first guess of where a new node is, and what carries on the surface if it is off the faces.
struct Guess {
  Vec2 place;
  ExtensionPlane extension;
};

// The mean of the parallelograms in space; around the start, a step in the lattice's own direction.
std::optional<Guess> guess(const LatticeMesh& mesh, const LatticePoint& p) {
  if (mesh.at.size() < 7) {
    const WalkPoint& start = mesh.points[0];
    const Vec3 t1 = tangents(mesh.plane, start.normal).col(0).normalized();
    const Vec2 flat = lattice_place(LatticeKind::Triangular, mesh.edge, to_vec(p));
    const Vec3 point = start.position + flat.x() * t1 + flat.y() * start.normal.cross(t1);
    return Guess{place_of_point(mesh.plane, point),
                 extension(start.position, start.normal, Vec3::Zero(), mesh.plane)};
  }
  Vec3 sum = Vec3::Zero();
  Guess g;
  const int count = parallelograms(mesh, p, [&](int ka, int kb, int kc) {
    const WalkPoint &a = mesh.points[ka], &b = mesh.points[kb], &c = mesh.points[kc];
    sum += a.position + b.position - c.position;
    g.extension = parallelogram(a, b, c, mesh.plane);
  });
  if (!count) return std::nullopt;
  g.place = place_of_point(mesh.plane, sum / count);
  return g;
}

// How many steps each node is from the nearest live one, up to kGapLayers.
std::vector<int> depths(const LatticeMesh& mesh) {
  std::vector<int> depth(mesh.at.size(), kGapLayers), layer;
  for (std::size_t k = 0; k < depth.size(); ++k)
    if (mesh.is_live[k]) {
      depth[k] = 0;
      layer.push_back(static_cast<int>(k));
    }
  for (int d = 1; d < kGapLayers; ++d) {
    std::vector<int> next;
    for (int k : layer)
      for (int s = 0; s < 6; ++s) {
        const int n = mesh.find(neighbour(mesh.at[k], s));
        if (n < 0 || depth[n] <= d) continue;
        depth[n] = d;
        next.push_back(n);
      }
    layer.swap(next);
  }
  return depth;
}

// Missing neighbours of nodes at a depth of at most `deepest`, in a fixed order.
std::vector<LatticePoint> border(const LatticeMesh& mesh, int deepest) {
  const std::vector<int> depth = depths(mesh);
  std::vector<LatticePoint> points;
  for (std::size_t k = 0; k < mesh.at.size(); ++k)
    for (int s = 0; s < 6 && depth[k] <= deepest; ++s) {
      const LatticePoint p = neighbour(mesh.at[k], s);
      if (mesh.find(p) < 0) points.push_back(p);
    }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

}  // namespace

bool grow(LatticeMesh& mesh, int deepest, bool only_live) {
  std::vector<LatticePoint> news;
  std::vector<ExtensionPlane> beyond;
  std::vector<Vec2> places;
  for (const LatticePoint& p : border(mesh, deepest))
    if (const auto g = guess(mesh, p)) {
      news.push_back(p);
      beyond.push_back(g->extension);
      places.push_back(g->place);
    }
  const std::vector<SurfaceSample> samples = mesh.sampler(places);
  bool any = false;
  for (std::size_t k = 0; k < news.size(); ++k) {
    const WalkPoint point = walk_point(mesh.plane, places[k], samples[k], beyond[k]);
    any = any || mesh.live(point);
    if (mesh.live(point) || !only_live) mesh.add(news[k], point);
  }
  return any;
}

bool place_nodes(LatticeMesh& mesh, const std::vector<Vec2>& places, bool again) {
  const std::vector<SurfaceSample> samples = mesh.sampler(places);
  std::vector<char> placed(places.size(), 0);
  bool back = false;
  for (std::size_t k = 0; k < places.size(); ++k) {
    WalkPoint& p = mesh.points[k];
    const SurfaceSample sample = p.on_face || again ? samples[k] : SurfaceSample{};
    const bool was_on = p.on_face;
    p = walk_point(mesh.plane, places[k], sample,
                   extension(p.position, p.normal, Vec3::Zero(), mesh.plane));
    placed[k] = p.on_face;
    back = back || (p.on_face && !was_on);
    mesh.is_live[k] = (mesh.is_live[k] || again) && mesh.live(p);
  }
  for (int layer = 0; layer < kGapLayers; ++layer) {
    std::vector<std::size_t> news;
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (placed[k]) continue;
      std::optional<ExtensionPlane> on;
      parallelograms(mesh, mesh.at[k], [&](int a, int b, int c) {
        if (placed[a] && placed[b] && placed[c])
          on = parallelogram(mesh.points[a], mesh.points[b], mesh.points[c], mesh.plane);
      });
      if (!on) continue;
      mesh.points[k] = walk_point(mesh.plane, places[k], SurfaceSample{}, *on);
      news.push_back(k);
    }
    for (std::size_t k : news) placed[k] = 1;
    if (news.empty()) break;
  }
  return back;
}

void forget_outside(LatticeMesh& mesh, int layers) {
  const std::vector<int> depth = depths(mesh);
  LatticeMesh kept{mesh.plane, mesh.sampler, mesh.edge, mesh.least_cosine, mesh.limit, {},
                   {},         {},           {}};
  for (std::size_t k = 0; k < depth.size(); ++k) {
    if (depth[k] > layers && k > 0) continue;
    kept.add(mesh.at[k], mesh.points[k]);
    kept.is_live.back() = mesh.is_live[k];
  }
  mesh.at.swap(kept.at);
  mesh.points.swap(kept.points);
  mesh.is_live.swap(kept.is_live);
  mesh.index.swap(kept.index);
}

}  // namespace patchmill::patch

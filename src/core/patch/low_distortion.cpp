// Low-distortion lattices on sampled surfaces; see surface_lattice.h. A coarse triangular lattice of
// edge H >= f grows layer by layer from the start, around holes too; in between it is relaxed by
// Gauss-Newton steps on
//     sum over edges of w (L/H - 1)²,  L = |X_b - X_a| (1 + ((n_b - n_a)·e)²/24),
// L the edge's length along the surface to third order, e its direction. Nodes move in their tangent
// planes and are projected back by the sampler. A few layers go beyond the faces (or the slope up to
// which low distortion is sought), with less weight w, for interpolation up to the border and to get
// across narrow gaps.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/patch/surface_lattice.h"
#include "core/patch/surface_walk.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/QR>
#include <Eigen/SparseCholesky>

namespace patchmill {
namespace {

constexpr double kCoarseNodes = 2000.0;  // about so many are relaxed
constexpr double kDamping = 1e-4;        // holds turns of the whole, which cost nothing on a plane
constexpr double kOutsideWeight = 0.8;
constexpr std::size_t kMostNodes = 24000;  // more cannot be without overlap at 75° of slope
constexpr int kOutsideLayers = 3;
constexpr int kGapLayers = 8;  // sent out for other parts; each gets half an edge further, or more
constexpr int kGaps = 50;      // one after another

const LatticePoint kAround[6] = {{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}};

LatticePoint operator+(const LatticePoint& a, const LatticePoint& b) {
  return {a[0] + b[0], a[1] + b[1]};
}

// The growing net, the start first. Nodes are live where the map is to be good.
struct Mesh {
  const TexturePlane& plane;
  const SurfaceSampler& sampler;
  double edge;          // H
  double least_cosine;  // of the slope
  Box2 limit;
  std::vector<LatticePoint> at;
  std::vector<WalkPoint> points;
  std::vector<char> is_live;  // once lost, for good: a node that comes and goes keeps all from rest
  std::map<LatticePoint, int> index;

  int find(const LatticePoint& p) const {
    const auto found = index.find(p);
    return found == index.end() ? -1 : found->second;
  }
  bool live(const WalkPoint& p) const {
    return p.on_face && -p.normal.dot(plane.direction) >= least_cosine && limit.contains(p.place);
  }
  void add(const LatticePoint& p, const WalkPoint& point) {
    index[p] = static_cast<int>(at.size());
    at.push_back(p);
    points.push_back(point);
    is_live.push_back(live(point));
  }
};

// An orthonormal basis Q of the tangent plane, and R with tangents = Q R.
struct TangentBasis {
  Eigen::Matrix<double, 3, 2> q;
  Eigen::Matrix2d r;
};

TangentBasis tangent_basis(const TexturePlane& plane, const Vec3& normal) {
  const auto t = tangents(plane, normal);
  TangentBasis basis;
  basis.q.col(0) = t.col(0).normalized();
  basis.q.col(1) = (t.col(1) - basis.q.col(0).dot(t.col(1)) * basis.q.col(0)).normalized();
  basis.r = basis.q.transpose() * t;
  return basis;
}

// The equations of one Gauss-Newton step; the start's are left at zero, so that it stays.
struct Equations {
  Eigen::SparseMatrix<double> matrix;
  Eigen::VectorXd right;
};

Equations equations(const Mesh& mesh, const std::vector<TangentBasis>& basis) {
  const int n = static_cast<int>(mesh.at.size());
  std::vector<Eigen::Triplet<double>> entries;
  Equations eq{Eigen::SparseMatrix<double>(2 * n, 2 * n), Eigen::VectorXd::Zero(2 * n)};
  for (int k = 0; k < 2 * n; ++k) entries.emplace_back(k, k, k < 2 ? 1.0 : kDamping);
  for (int a = 0; a < n; ++a)
    for (int s = 0; s < 3; ++s) {
      const int b = mesh.find(mesh.at[a] + kAround[s]);
      if (b < 0) continue;
      const WalkPoint &pa = mesh.points[a], &pb = mesh.points[b];
      const Vec3 chord = pb.position - pa.position, e = chord.normalized();
      const double bend = (pb.normal - pa.normal).dot(e);
      const double length = chord.norm() * (1.0 + bend * bend / 24.0) / mesh.edge;
      const int of[4] = {2 * a, 2 * a + 1, 2 * b, 2 * b + 1};
      const double weight = mesh.is_live[a] && mesh.is_live[b] ? 1.0 : kOutsideWeight;
      Eigen::Vector4d g;
      g << -basis[a].q.transpose() * e, basis[b].q.transpose() * e;
      for (int i = 0; i < 4; ++i) {
        if (of[i] < 2) continue;
        eq.right[of[i]] -= weight * g[i] * (length - 1.0);
        for (int j = 0; j < 4; ++j)
          if (of[j] >= 2) entries.emplace_back(of[i], of[j], weight * g[i] * g[j]);
      }
    }
  // The step (1, 0) keeps its direction: else the whole lattice might turn, which costs nothing.
  if (const int k = mesh.find({1, 0}); k >= 0) {
    const Vec3 off = (mesh.points[k].position - mesh.points[0].position) / mesh.edge;
    const Vec3 across =
        mesh.points[0].normal.cross(tangents(mesh.plane, mesh.points[0].normal).col(0));
    const Vec2 g = basis[k].q.transpose() * across.normalized();
    eq.right.segment<2>(2 * k) -= g * off.dot(across.normalized());
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) entries.emplace_back(2 * k + i, 2 * k + j, g[i] * g[j]);
  }
  eq.matrix.setFromTriplets(entries.begin(), entries.end());
  return eq;
}

// A missing node completes parallelograms a + b - c over the net's border: a and b are next to it
// and to each other, c is across from it. Calls `take(a, b, c)` with the indices of each.
template <typename Take>
int parallelograms(const Mesh& mesh, const LatticePoint& p, Take take) {
  int count = 0;
  for (int s = 0; s < 6; ++s) {
    const LatticePoint sa = kAround[s], sb = kAround[(s + 1) % 6];
    const int a = mesh.find(p + sa), b = mesh.find(p + sb), c = mesh.find(p + sa + sb);
    if (a < 0 || b < 0 || c < 0) continue;
    take(a, b, c);
    ++count;
  }
  return count;
}

// Brings all nodes on the surface at new places. A node that is off the faces lies on what carries
// on its neighbours, which are placed before it. Unless `again`, a node that was off stays so:
// nodes that come and go would keep all from rest.
void place_nodes(Mesh& mesh, const std::vector<Vec2>& places, bool again) {
  const std::vector<SurfaceSample> samples = mesh.sampler(places);
  std::vector<char> placed(places.size(), 0);
  for (std::size_t k = 0; k < places.size(); ++k) {
    WalkPoint& p = mesh.points[k];
    const SurfaceSample sample = p.on_face || again ? samples[k] : SurfaceSample{};
    p = walk_point(mesh.plane, places[k], sample,
                   extension(p.position, p.normal, Vec3::Zero(), mesh.plane));
    placed[k] = p.on_face;
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
}

// One Gauss-Newton step of all nodes. Returns the largest move of a live one / H.
double relax(Mesh& mesh) {
  std::vector<TangentBasis> basis;
  basis.reserve(mesh.points.size());
  for (const WalkPoint& p : mesh.points) basis.push_back(tangent_basis(mesh.plane, p.normal));
  const Equations eq = equations(mesh, basis);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(eq.matrix);
  const Eigen::VectorXd move = solver.solve(eq.right);
  std::vector<Vec2> places;
  double largest = 0.0;
  for (std::size_t k = 0; k < mesh.points.size(); ++k) {
    Vec2 y = move.segment<2>(Eigen::Index(2 * k));
    if (!y.allFinite()) y.setZero();
    if (y.norm() > 0.3) y *= 0.3 / y.norm();
    if (mesh.is_live[k]) largest = std::max(largest, y.norm());
    places.push_back(mesh.points[k].place + basis[k].r.inverse() * y * mesh.edge);
  }
  place_nodes(mesh, places, false);
  return largest;
}

// A first guess of where a new node is, and what carries on the surface if it is off the faces.
struct Guess {
  Vec2 place;
  ExtensionPlane extension;
};

// The mean of the parallelograms in space; around the start, a step in the lattice's own direction.
std::optional<Guess> guess(const Mesh& mesh, const LatticePoint& p) {
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
std::vector<int> depths(const Mesh& mesh) {
  std::vector<int> depth(mesh.at.size(), kGapLayers), layer;
  for (std::size_t k = 0; k < depth.size(); ++k)
    if (mesh.is_live[k]) {
      depth[k] = 0;
      layer.push_back(static_cast<int>(k));
    }
  for (int d = 1; d < kGapLayers; ++d) {
    std::vector<int> next;
    for (int k : layer)
      for (const LatticePoint& s : kAround) {
        const int n = mesh.find(mesh.at[k] + s);
        if (n < 0 || depth[n] <= d) continue;
        depth[n] = d;
        next.push_back(n);
      }
    layer.swap(next);
  }
  return depth;
}

// Missing neighbours of nodes at a depth of at most `deepest`, in a fixed order.
std::vector<LatticePoint> border(const Mesh& mesh, int deepest) {
  const std::vector<int> depth = depths(mesh);
  std::vector<LatticePoint> points;
  for (std::size_t k = 0; k < mesh.at.size(); ++k)
    for (const LatticePoint& s : kAround)
      if (depth[k] <= deepest && mesh.find(mesh.at[k] + s) < 0) points.push_back(mesh.at[k] + s);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

// Adds a layer of nodes around those of depth `deepest` or less: only live ones, or all. Returns
// whether there were any live ones.
bool grow(Mesh& mesh, int deepest, bool only_live) {
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

SurfaceLattice as_lattice(const Mesh& mesh, const LatticeRequest& request) {
  LatticePoint first{0, 0}, last{0, 0};
  SurfaceLattice lattice;
  for (std::size_t n = 0; n < mesh.at.size(); ++n) {
    for (int k = 0; k < 2; ++k) {
      first[k] = std::min(first[k], mesh.at[n][k]);
      last[k] = std::max(last[k], mesh.at[n][k]);
    }
    if (request.area.contains(mesh.points[n].place))
      lattice.flat.extend(lattice_place(LatticeKind::Triangular, mesh.edge, to_vec(mesh.at[n])));
  }
  const Vec2 one = Vec2::Constant(mesh.edge);
  lattice.flat = Box2(lattice.flat.min() - one, lattice.flat.max() + one);
  auto grid = std::make_shared<NodeGrid>(first, last);
  for (std::size_t n = 0; n < mesh.at.size(); ++n) grid->set(mesh.at[n], mesh.points[n].place);
  lattice.place_of = [grid, kind = request.kind, f = request.spacing,
                      edge = mesh.edge](const Vec2& p) {
    return grid->at(lattice_coordinates(LatticeKind::Triangular, edge, lattice_place(kind, f, p)));
  };
  return lattice;
}

// Leaves only kOutsideLayers around live nodes.
void forget_outside(Mesh& mesh) {
  const std::vector<int> depth = depths(mesh);
  Mesh kept{mesh.plane, mesh.sampler, mesh.edge, mesh.least_cosine, mesh.limit, {}, {}, {}, {}};
  for (std::size_t k = 0; k < depth.size(); ++k) {
    if (depth[k] > kOutsideLayers && k > 0) continue;
    kept.add(mesh.at[k], mesh.points[k]);
    kept.is_live.back() = mesh.is_live[k];
  }
  mesh.at.swap(kept.at);
  mesh.points.swap(kept.points);
  mesh.is_live.swap(kept.is_live);
  mesh.index.swap(kept.index);
}

// Grows over all of the faces that can be reached, relaxing after each layer so that the next one
// fits. False if asked to stop.
bool grow_all(Mesh& mesh, const LatticeRequest& request, const Progress& progress) {
  const double expected = 2.0 * request.area.volume() / (mesh.edge * mesh.edge);
  bool landed = true;  // beyond a gap
  for (int gap = 0; landed && gap < kGaps; ++gap) {
    while (mesh.at.size() < kMostNodes && grow(mesh, 0, true)) {
      relax(mesh);
      if (!go_on(progress, std::min(0.9, double(mesh.at.size()) / expected))) return false;
    }
    landed = false;
    for (int layer = 0; layer < kGapLayers; ++layer) {
      const bool live = grow(mesh, layer, false);
      landed = landed || (live && layer > 0);  // next to live nodes all have been tried
      if (layer < kOutsideLayers) relax(mesh);
    }
  }
  forget_outside(mesh);
  return true;
}

}  // namespace

std::optional<SurfaceLattice> low_distortion_lattice(const LatticeRequest& request,
                                                     const TexturePlane& plane,
                                                     const SurfaceSampler& sampler,
                                                     const Progress& progress) {
  const SurfacePoint at = require_start(request, sampler);
  const double edge = std::max(request.spacing, std::sqrt(request.area.volume() / kCoarseNodes));
  const Vec2 margin = Vec2::Constant(4.0 * edge);
  Mesh mesh{plane,
            sampler,
            edge,
            std::cos(request.steepest.radians()),
            Box2(request.area.min() - margin, request.area.max() + margin),
            {},
            {},
            {},
            {}};
  mesh.add({0, 0}, {request.start, at.position, at.normal, true});
  if (!grow_all(mesh, request, progress)) return std::nullopt;
  for (int settle = 0; settle < 3; ++settle) {
    std::vector<Vec2> places;
    for (const WalkPoint& p : mesh.points) places.push_back(p.place);
    place_nodes(mesh, places, true);
    for (int n = 0; n < 12 && relax(mesh) > 3e-4; ++n)
      if (!go_on(progress, 0.9)) return std::nullopt;
  }
  return as_lattice(mesh, request);
}

}  // namespace patchmill

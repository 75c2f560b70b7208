// Low-distortion lattices on sampled surfaces; see surface_lattice.h. A coarse triangular lattice of
// edge H >= f grows layer by layer from the start, around holes too; in between it is relaxed by
// Gauss-Newton steps on
//     sum over edges of w (L/H - 1)²,  L = |X_b - X_a| (1 + ((n_b - n_a)·e)²/24),
// L the edge's length along the surface to third order, e its direction. Nodes move in their tangent
// planes and are projected back by the sampler. A few layers go beyond the faces (or the slope up to
// which low distortion is sought), with less weight w, for interpolation up to the border and to get
// across narrow gaps.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/lattice_mesh.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>
#include <Eigen/SparseCholesky>

namespace patchmill::patch {
namespace {

constexpr double kCoarseNodes = 2000.0;  // about so many are relaxed
constexpr double kDamping = 1e-4;        // holds turns of the whole, which cost nothing on a plane
constexpr double kOutsideWeight = 0.8;
constexpr double kMostNodes = 4.0;  // of those on a flat area: more at 75° of slope would overlap
constexpr int kOutsideLayers = 3;
constexpr int kGaps = 10;  // one after another

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

Equations equations(const LatticeMesh& mesh, const std::vector<TangentBasis>& basis) {
  const int n = static_cast<int>(mesh.at.size());
  std::vector<Eigen::Triplet<double>> entries;
  Equations eq{Eigen::SparseMatrix<double>(2 * n, 2 * n), Eigen::VectorXd::Zero(2 * n)};
  for (int k = 0; k < 2 * n; ++k) entries.emplace_back(k, k, k < 2 ? 1.0 : kDamping);
  for (int a = 0; a < n; ++a)
    for (int s = 0; s < 3; ++s) {
      const int b = mesh.find(neighbour(mesh.at[a], s));
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

// One Gauss-Newton step of all nodes. Returns the largest move of a live one / H.
double relax(LatticeMesh& mesh) {
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

SurfaceLattice as_lattice(const LatticeMesh& mesh, const LatticeRequest& request) {
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

// Grows over all of the faces that can be reached, relaxing after each layer so that the next one
// fits. False if asked to stop.
bool grow_all(LatticeMesh& mesh, const LatticeRequest& request, const Progress& progress) {
  const double expected = 2.0 * request.area.volume() / (mesh.edge * mesh.edge);
  const double flat =
      mesh.limit.volume() / (cell_area(LatticeKind::Triangular) * mesh.edge * mesh.edge);
  const auto room = [&] { return double(mesh.at.size()) < kMostNodes * flat; };
  bool landed = true;  // beyond a gap
  for (int gap = 0; landed && room() && gap < kGaps; ++gap) {
    while (room() && grow(mesh, 0, true)) {
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
  forget_outside(mesh, kOutsideLayers);
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
  LatticeMesh mesh{plane,
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
  // nodes that were carried off the faces, and came back since, get two more chances
  for (int settle = 0; settle < 3; ++settle) {
    std::vector<Vec2> places;
    for (const WalkPoint& p : mesh.points) places.push_back(p.place);
    if (!place_nodes(mesh, places, true) && settle > 0) break;
    for (int n = 0; n < 12 && relax(mesh) > 3e-4; ++n)
      if (!go_on(progress, 0.9)) return std::nullopt;
  }
  return as_lattice(mesh, request);
}

}  // namespace patchmill::patch

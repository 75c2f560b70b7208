// Unrolling triangle by triangle, then Gauss-Newton steps on sparse normal equations; see flatten.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/atlas/flatten.h"

#include "patchmill/geometry/stop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <Eigen/SVD>
#include <Eigen/SparseCholesky>

namespace patchmill::patch {
namespace {

constexpr int kSteps = 15;
constexpr double kRest = 1e-4;  // move of a step over the edges' mean length
constexpr int kReweightings = 6;
constexpr double kDamping = 1e-7;
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

double length_of(const ChartMesh& mesh, int a, int b) {
  const auto i = std::size_t(a), j = std::size_t(b);
  return along_surface(mesh.positions[i], mesh.normals[i], mesh.positions[j], mesh.normals[j]);
}

// The corner of a triangle with sides |AB| = c, |BC| = a, |CA| = b to the left of A to B, with A at 0 and B
// at (1, 0): in units of c.
Vec2 third_corner(double a, double b, double c) {
  const double x = (b * b + c * c - a * a) / (2.0 * c);
  return {x / c, std::sqrt(std::max(0.0, b * b - x * x)) / c};
}

// Triangles around a first one, layer by layer: each vertex at the mean of where its triangles want it.
std::vector<Vec2> unrolled(const ChartMesh& mesh) {
  const Vec2 unknown = Vec2::Constant(kNotANumber);
  std::vector<Vec2> flat(mesh.positions.size(), unknown);
  std::vector<std::vector<int>> around(flat.size());
  for (std::size_t t = 0; t < mesh.unrolling.size(); ++t)
    for (int v : mesh.unrolling[t]) around[std::size_t(v)].push_back(static_cast<int>(t));
  auto placed = [&](int v) { return flat[std::size_t(v)].allFinite(); };
  const auto& first = mesh.unrolling[mesh.unrolling.size() / 2];
  flat[std::size_t(first[0])] = Vec2::Zero();
  flat[std::size_t(first[1])] = Vec2(length_of(mesh, first[0], first[1]), 0.0);
  std::set<int> open(around[std::size_t(first[0])].begin(), around[std::size_t(first[0])].end());
  while (!open.empty()) {
    std::map<int, std::pair<Vec2, int>> wanted;
    for (int t : open) {
      const auto& v = mesh.unrolling[std::size_t(t)];
      for (int k = 0; k < 3; ++k) {
        const int a = v[k], b = v[(k + 1) % 3], c = v[(k + 2) % 3];
        if (!placed(a) || !placed(b) || placed(c)) continue;
        const Vec2 base = flat[std::size_t(b)] - flat[std::size_t(a)];
        const Vec2 third =
            third_corner(length_of(mesh, b, c), length_of(mesh, c, a), length_of(mesh, a, b));
        auto& [sum, count] = wanted.try_emplace(c, Vec2::Zero(), 0).first->second;
        sum += flat[std::size_t(a)] + third.x() * base + third.y() * Vec2(-base.y(), base.x());
        ++count;
      }
    }
    open.clear();
    for (const auto& [v, place] : wanted) {
      flat[std::size_t(v)] = place.first / place.second;
      open.insert(around[std::size_t(v)].begin(), around[std::size_t(v)].end());
    }
  }
  return flat;
}

struct Residuals {
  std::vector<double> value;  // of each edge: length / wanted length - 1
  double sum = 0.0;           // of weight · value²
};

Residuals residuals(const ChartMesh& mesh, const std::vector<Vec2>& flat,
                    const std::vector<double>& weights) {
  Residuals r;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto& edge = mesh.edges[e];
    const Vec2 d = flat[std::size_t(edge.b)] - flat[std::size_t(edge.a)];
    r.value.push_back(d.allFinite() ? d.norm() / edge.length - 1.0 : 0.0);
    r.sum += weights[e] * r.value.back() * r.value.back();
  }
  return r;
}

using Solver = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

// The move of all vertices in one Gauss-Newton step. `solver` knows the pattern of the equations from the second
// step on.
Eigen::VectorXd step(const ChartMesh& mesh, const std::vector<Vec2>& flat,
                     const std::vector<double>& weights, double damping, Solver& solver) {
  const auto n = Eigen::Index(2 * flat.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n), diagonal = Eigen::VectorXd::Zero(n);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto& edge = mesh.edges[e];
    const Vec2 d = flat[std::size_t(edge.b)] - flat[std::size_t(edge.a)];
    // an edge that is nowhere yet has a place in the equations too: their pattern must not change
    const bool known = d.allFinite() && d.norm() > 0.0;
    const Vec2 g = known ? Vec2(d / (d.norm() * edge.length)) : Vec2(0.0, 0.0);
    const double miss = known ? d.norm() / edge.length - 1.0 : 0.0;
    const int of[4] = {2 * edge.a, 2 * edge.a + 1, 2 * edge.b, 2 * edge.b + 1};
    const double slope[4] = {-g.x(), -g.y(), g.x(), g.y()};
    for (int i = 0; i < 4; ++i) {
      right[of[i]] -= weights[e] * slope[i] * miss;
      diagonal[of[i]] += weights[e] * slope[i] * slope[i];
      for (int j = 0; j < 4; ++j)
        if (of[i] >= of[j]) entries.emplace_back(of[i], of[j], weights[e] * slope[i] * slope[j]);
    }
  }
  const double mean = diagonal.sum() / double(n);
  for (Eigen::Index k = 0; k < n; ++k)
    entries.emplace_back(int(k), int(k), diagonal[k] > 0.0 ? damping * mean : 1.0);
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  stop_point();
  if (solver.rows() == 0) solver.analyzePattern(matrix);
  solver.factorize(matrix);
  if (solver.info() != Eigen::Success) return Eigen::VectorXd::Constant(n, kNotANumber);
  return solver.solve(right);
}

// Levenberg's rule: a step that makes it worse is damped. False if asked to stop.
bool relax(const ChartMesh& mesh, const std::vector<double>& weights, int steps,
           const Progress& progress, std::vector<Vec2>& flat) {
  double damping = kDamping, mean = 0.0;
  for (const auto& edge : mesh.edges) mean += edge.length / double(mesh.edges.size());
  Residuals now = residuals(mesh, flat, weights);
  Solver solver;
  for (int k = 0; k < steps && damping < 1e3; ++k) {
    if (!go_on(progress, double(k) / steps)) return false;
    const Eigen::VectorXd move = step(mesh, flat, weights, damping, solver);
    if (!move.allFinite()) {  // the equations have no answer: damped, they have
      damping *= 30.0;
      continue;
    }
    std::vector<Vec2> moved = flat;
    double furthest = 0.0;
    for (std::size_t v = 0; v < flat.size(); ++v) {
      const Vec2 by = move.segment<2>(Eigen::Index(2 * v));
      moved[v] += by;
      if (flat[v].allFinite()) furthest = std::max(furthest, by.norm());
    }
    const Residuals then = residuals(mesh, moved, weights);
    if (!(then.sum <= now.sum)) {
      damping *= 30.0;
      continue;
    }
    flat.swap(moved);
    now = then;
    damping = std::max(kDamping, damping / 10.0);
    if (furthest < kRest * mean) break;
  }
  return true;
}

std::vector<double> own_weights(const ChartMesh& mesh) {
  std::vector<double> weights;
  for (const auto& edge : mesh.edges) weights.push_back(edge.weight);
  return weights;
}

}  // namespace

std::optional<std::vector<Vec2>> flatten(const ChartMesh& mesh, const Progress& progress) {
  if (mesh.unrolling.empty()) return std::vector<Vec2>(mesh.positions.size());
  std::vector<Vec2> flat = unrolled(mesh);
  if (!relax(mesh, own_weights(mesh), kSteps, progress, flat)) return std::nullopt;
  return flat;
}

bool even_out(const ChartMesh& mesh, std::vector<Vec2>& flat, const Progress& progress) {
  std::vector<double> weights = own_weights(mesh);
  for (int round = 0; round < kReweightings; ++round) {
    const Residuals r = residuals(mesh, flat, weights);
    double greatest = 0.0;
    for (const double value : r.value) greatest = std::max(greatest, std::abs(value));
    if (greatest < 0.02) break;
    for (std::size_t e = 0; e < r.value.size(); ++e) {
      const double over = std::abs(r.value[e]) / greatest;
      weights[e] = 0.5 * weights[e] + 0.5 * mesh.edges[e].weight * (0.02 + over * over);
    }
    if (!relax(mesh, weights, 2, progress, flat)) return false;
  }
  return true;
}

std::vector<Stretch> stretches(const ChartMesh& mesh, const std::vector<Vec2>& flat) {
  std::vector<Stretch> all;
  for (const auto& triangle : mesh.triangles) {
    const int v[3] = {triangle[0].vertex, triangle[1].vertex, triangle[2].vertex};
    const double c = length_of(mesh, v[0], v[1]);
    const Vec2 third =
        c * third_corner(length_of(mesh, v[1], v[2]), length_of(mesh, v[2], v[0]), c);
    Eigen::Matrix2d on_face, in_plane;
    on_face << c, third.x(), 0.0, third.y();
    in_plane << flat[std::size_t(v[1])] - flat[std::size_t(v[0])],
        flat[std::size_t(v[2])] - flat[std::size_t(v[0])];
    Stretch s{1.0, 1.0, !in_plane.allFinite()};
    if (third.y() > 1e-6 * c && in_plane.allFinite()) {
      const Eigen::Matrix2d map = in_plane * on_face.inverse();
      const Vec2 values = Eigen::JacobiSVD<Eigen::Matrix2d>(map).singularValues();
      s = {values[1], values[0], map.determinant() < 0.0};
    }
    all.push_back(s);
  }
  return all;
}

}  // namespace patchmill::patch

// Grids over a face's parameters; see chart_mesh.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/atlas/chart_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace patchmill::patch {
namespace {

constexpr int kProbes = 48;     // along each line that is looked at to place the grid's lines
constexpr int kProbeLines = 9;  // of each direction
constexpr double kTurn = 0.2;   // rad: greatest turn of the normal over a cell
constexpr int kMostLines = 90;
constexpr int kTrimProbes = 4;  // by as many of a cell its share inside the trimming is counted

double share(int k, int of) {
  return double(k) / of;
}

// Where the face is looked at along one direction: points and normals of some lines of parameters.
struct Probes {
  std::vector<double> step, turn;  // by piece: greatest length [mm] and turn [rad] of all lines
  double length = 0.0;             // mean of the lines [mm]
};

Probes probe(const CurvedFace& face, const Box2& r, int axis) {
  Probes probes;
  probes.step.assign(kProbes, 0.0);
  probes.turn.assign(kProbes, 0.0);
  for (int line = 0; line < kProbeLines; ++line) {
    Vec2 uv;
    uv[1 - axis] = r.min()[1 - axis] + r.sizes()[1 - axis] * share(line, kProbeLines - 1);
    Vec3 point = Vec3::Zero(), normal = Vec3::Zero();
    for (int k = 0; k <= kProbes; ++k) {
      uv[axis] = r.min()[axis] + r.sizes()[axis] * share(k, kProbes);
      const Vec3 p = face.d1(uv).point, n = face.normal(uv);
      if (k > 0) {
        const double step = (p - point).norm();
        const auto piece = std::size_t(k - 1);
        probes.step[piece] = std::max(probes.step[piece], step);
        // what turns where the line is a point is no bend
        if (step > 0.0) probes.turn[piece] = std::max(probes.turn[piece], (n - normal).norm());
        probes.length += step / kProbeLines;
      }
      point = p;
      normal = n;
    }
  }
  return probes;
}

// Parameters of the grid's lines along one direction, close where cells would be long or bent.
std::vector<double> grid_lines(const Probes& probes, double cell, double first, double last) {
  std::vector<double> sum{0.0};
  for (int k = 0; k < kProbes; ++k) {
    const auto i = std::size_t(k);
    sum.push_back(sum.back() + probes.step[i] / cell + probes.turn[i] / kTurn + 1e-3);
  }
  const int count = std::clamp(static_cast<int>(std::ceil(sum.back())), 4, kMostLines);
  std::vector<double> lines;
  int piece = 0;
  for (int k = 0; k <= count; ++k) {
    const double want = sum.back() * share(k, count);
    while (piece < kProbes - 1 && sum[std::size_t(piece) + 1] < want) ++piece;
    const double a = sum[std::size_t(piece)], b = sum[std::size_t(piece) + 1];
    lines.push_back(first + (last - first) * (piece + (want - a) / (b - a)) / kProbes);
  }
  lines.front() = first;
  lines.back() = last;
  return lines;
}

// The nodes of a grid and the vertex that each is.
class Nodes {
 public:
  Nodes(const CurvedFace& face, std::vector<double> us, std::vector<double> vs)
      : us_(std::move(us)), vs_(std::move(vs)) {
    for (int j = 0; j < rows(); ++j)
      for (int i = 0; i < columns(); ++i) {
        positions_.push_back(face.d1(uv(i, j)).point);
        normals_.push_back(face.normal(uv(i, j)));
        vertex_.push_back(static_cast<int>(vertex_.size()));
      }
    Eigen::AlignedBox3d around;
    for (const Vec3& p : positions_) around.extend(p);
    near_ = 1e-7 * around.diagonal().norm();
    int poles[2] = {0, 0};  // sides of constant u, of constant v
    for (int side = 0; side < 4; ++side) poles[side / 2] += weld_if_point(side);
    // one pole and the other direction closed: a disk
    if (poles[1] == 1 && poles[0] == 0) weld_sides(true);
    if (poles[0] == 1 && poles[1] == 0) weld_sides(false);
  }

  int columns() const { return static_cast<int>(us_.size()); }
  int rows() const { return static_cast<int>(vs_.size()); }
  Vec2 uv(int i, int j) const { return {us_[std::size_t(i)], vs_[std::size_t(j)]}; }
  int vertex(int i, int j) const { return vertex_[index(i, j)]; }
  const std::vector<Vec3>& positions() const { return positions_; }
  const std::vector<Vec3>& normals() const { return normals_; }

 private:
  std::size_t index(int i, int j) const { return std::size_t(j * columns() + i); }

  // Nodes of a side: 0 and 1 of least and greatest u, 2 and 3 of v.
  std::vector<std::size_t> side_nodes(int side) const {
    std::vector<std::size_t> nodes;
    if (side < 2)
      for (int j = 0; j < rows(); ++j) nodes.push_back(index(side ? columns() - 1 : 0, j));
    else
      for (int i = 0; i < columns(); ++i) nodes.push_back(index(i, side == 3 ? rows() - 1 : 0));
    return nodes;
  }

  bool weld_if_point(int side) {
    const auto nodes = side_nodes(side);
    for (std::size_t n : nodes)
      if ((positions_[n] - positions_[nodes[0]]).norm() > near_) return false;
    for (std::size_t n : nodes) vertex_[n] = vertex_[nodes[0]];
    return true;
  }

  void weld_sides(bool along_u) {
    const auto a = side_nodes(along_u ? 0 : 2), b = side_nodes(along_u ? 1 : 3);
    for (std::size_t k = 0; k < a.size(); ++k)
      if ((positions_[a[k]] - positions_[b[k]]).norm() > near_) return;
    for (std::size_t k = 0; k < a.size(); ++k) vertex_[b[k]] = vertex_[a[k]];
  }

  std::vector<double> us_, vs_;
  std::vector<Vec3> positions_, normals_;
  std::vector<int> vertex_;
  double near_ = 0.0;
};

// Share of each cell that is inside the trimming.
std::vector<double> shares_inside(const CurvedFace& face, const Nodes& nodes) {
  std::vector<double> shares;
  for (int j = 0; j + 1 < nodes.rows(); ++j)
    for (int i = 0; i + 1 < nodes.columns(); ++i) {
      const Vec2 low = nodes.uv(i, j), size = nodes.uv(i + 1, j + 1) - low;
      int count = 0;
      for (int k = 0; k < kTrimProbes * kTrimProbes; ++k)
        count +=
            face.inside(low + size.cwiseProduct(Vec2(k % kTrimProbes + 0.5, k / kTrimProbes + 0.5) /
                                                double(kTrimProbes)));
      shares.push_back(double(count) / (kTrimProbes * kTrimProbes));
    }
  return shares;
}

class Builder {
 public:
  Builder(const Nodes& nodes, std::vector<double> shares)
      : nodes_(nodes), shares_(std::move(shares)) {}

  ChartMesh build() {
    mesh_.positions = nodes_.positions();
    mesh_.normals = nodes_.normals();
    for (int j = 0; j + 1 < nodes_.rows(); ++j)
      for (int i = 0; i + 1 < nodes_.columns(); ++i)
        if (near_face(i, j)) add_cell(i, j);
    for (auto& [ends, edge] : edges_)
      if (edge.length > 0.0) mesh_.edges.push_back(edge);
    return std::move(mesh_);
  }

 private:
  double inside(int i, int j) const {
    if (i < 0 || j < 0 || i + 1 >= nodes_.columns() || j + 1 >= nodes_.rows()) return 0.0;
    return shares_[std::size_t(j * (nodes_.columns() - 1) + i)];
  }
  // cells next to those on the face are there too, for what lies between two probes of the trimming
  bool near_face(int i, int j) const {
    for (int b = j - 1; b <= j + 1; ++b)
      for (int a = i - 1; a <= i + 1; ++a)
        if (inside(a, b) > 0.0) return true;
    return false;
  }

  ChartMesh::Corner corner(int i, int j) const { return {nodes_.vertex(i, j), nodes_.uv(i, j)}; }

  void add_cell(int i, int j) {
    const ChartMesh::Corner c[4] = {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1),
                                    corner(i, j + 1)};
    const auto& p = mesh_.positions;
    auto at = [&](int k) { return p[std::size_t(c[k].vertex)]; };
    auto normal = [&](int k) { return mesh_.normals[std::size_t(c[k].vertex)]; };
    const Vec3 cross = (at(2) - at(0)).cross(at(3) - at(1));
    const double area = 0.5 * cross.norm();
    const double on = inside(i, j);
    mesh_.area += on * area;
    const Vec3 turned = (normal(2) - normal(0)).cross(normal(3) - normal(1));
    mesh_.curvature += on * 0.5 * turned.norm() * (turned.dot(cross) < 0.0 ? -1.0 : 1.0);
    // the diagonal turns from cell to cell, so that no direction is preferred
    const int order[2][6] = {{0, 1, 2, 0, 2, 3}, {0, 1, 3, 1, 2, 3}};
    const int used = (i + j) % 2;
    for (int way = 0; way < 2; ++way)
      for (int t = 0; t < 6; t += 3) {
        const int* o = order[way] + t;
        if (is_flat(c[o[0]].vertex, c[o[1]].vertex, c[o[2]].vertex)) continue;
        mesh_.unrolling.push_back({c[o[0]].vertex, c[o[1]].vertex, c[o[2]].vertex});
        if (way != used) continue;
        mesh_.triangles.push_back({c[o[0]], c[o[1]], c[o[2]]});
        mesh_.on_face.push_back(on > 0.0);
      }
    for (const auto& [a, b] : {std::pair(0, 1), {1, 2}, {2, 3}, {3, 0}, {0, 2}, {1, 3}})
      add_edge(c[a].vertex, c[b].vertex, area * (on > 0.0 ? 1.0 : 0.1));
  }

  static bool is_flat(int a, int b, int c) { return a == b || b == c || c == a; }

  void add_edge(int a, int b, double weight) {
    if (a == b) return;
    ChartMesh::Edge& edge = edges_[{std::min(a, b), std::max(a, b)}];
    const auto i = std::size_t(a), j = std::size_t(b);
    if (edge.weight == 0.0) {
      edge = {a, b, 0.0, 0.0};
      edge.length =
          along_surface(mesh_.positions[i], mesh_.normals[i], mesh_.positions[j], mesh_.normals[j]);
    }
    edge.weight += weight;
  }

  const Nodes& nodes_;
  std::vector<double> shares_;
  std::map<std::pair<int, int>, ChartMesh::Edge> edges_;
  ChartMesh mesh_;
};

}  // namespace

double along_surface(const Vec3& a, const Vec3& normal_a, const Vec3& b, const Vec3& normal_b) {
  const Vec3 chord = b - a;
  const double length = chord.norm();
  if (!(length > 0.0)) return 0.0;
  const double bend = (normal_b - normal_a).dot(chord) / length;
  return length * (1.0 + bend * bend / 24.0);
}

ChartMesh chart_mesh(const CurvedFace& face, const Box2& rectangle, int cells) {
  const Probes along_u = probe(face, rectangle, 0), along_v = probe(face, rectangle, 1);
  const double cell = std::sqrt(along_u.length * along_v.length / cells);
  const Nodes nodes(face, grid_lines(along_u, cell, rectangle.min().x(), rectangle.max().x()),
                    grid_lines(along_v, cell, rectangle.min().y(), rectangle.max().y()));
  ChartMesh mesh = Builder(nodes, shares_inside(face, nodes)).build();
  mesh.length_u = along_u.length;
  mesh.length_v = along_v.length;
  return mesh;
}

}  // namespace patchmill::patch

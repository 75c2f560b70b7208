// Halving of triangles; see face_mesh.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/face_mesh.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"

#include <algorithm>

#include <fmt/format.h>

namespace patchmill {
namespace {

using Index = std::int32_t;
using Corners = std::array<Index, 3>;

constexpr int kMostPasses = 40;  // each halves the longest edges
constexpr Index kWhole = -1;     // the middle of an edge that is not cut

Vec3 vec(const gp_Pnt& p) {
  return {p.X(), p.Y(), p.Z()};
}

/// The place in the middle of an edge of a triangle, and how far the chord is from there [mm].
struct Middle {
  FaceNode node;
  double off = 0.0;
};

class Refinement {
 public:
  Refinement(FaceMesh& mesh, double deflection) : mesh_(mesh), deflection_(deflection) {}

  /// Cuts what is too far off once; whether there was anything.
  bool pass() {
    settled_.resize(mesh_.corners.size(), 0);
    for (std::size_t i = 0; i < mesh_.corners.size(); ++i) {
      stop_point();
      bool cut = collapsed(mesh_.corners[i]);
      for (int k = 0; k < 3 && !settled_[i]; ++k) cut = middle_of(i, k) != kWhole || cut;
      if (!cut && !settled_[i] && middle_is_off(i)) cut_longest(i);
      settled_[i] = !cut;
    }
    std::vector<Corners> corners;
    std::vector<Index> face;
    std::vector<char> settled;
    std::swap(corners, mesh_.corners);
    std::swap(face, mesh_.face);
    std::swap(settled, settled_);
    bool any = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      stop_point();
      const bool cut = cut_at_middles(corners[i], face[i]);
      settled_.resize(mesh_.corners.size(), cut ? 0 : settled[i]);
      any = any || cut;
    }
    return any;
  }

 private:
  Index vertex(Index node) { return mesh_.same.of(node); }
  const Vec3& point(Index node) { return mesh_.nodes[vertex(node)].point; }
  bool collapsed(const Corners& t) {
    const Index a = vertex(t[0]), b = vertex(t[1]), c = vertex(t[2]);
    return a == b || b == c || c == a;
  }
  std::uint64_t chord(Index a, Index b) { return FaceMesh::pair(vertex(a), vertex(b)); }

  /// The node in the middle of the k-th edge of a triangle if that is cut, decided where it is met first.
  Index middle_of(std::size_t i, int k) {
    const Corners& t = mesh_.corners[i];
    if (collapsed(t)) return kWhole;
    const Index a = t[k], b = t[(k + 1) % 3];
    const auto [known, is_new] = middles_.try_emplace(chord(a, b), kWhole);
    if (!is_new) return known->second;
    const Middle middle = middle_between(a, b, mesh_.face[i]);
    if (middle.off > deflection_) known->second = cut_edge(a, b, middle.node);
    return known->second;
  }

  /// Cuts the longest edge of a triangle.
  void cut_longest(std::size_t i) {
    const Corners& t = mesh_.corners[i];
    int longest = 0;
    const auto length = [&](int k) { return (point(t[(k + 1) % 3]) - point(t[k])).norm(); };
    for (int k = 1; k < 3; ++k)
      if (length(k) > length(longest)) longest = k;
    const Index a = t[longest], b = t[(longest + 1) % 3];
    middles_[chord(a, b)] = cut_edge(a, b, middle_between(a, b, mesh_.face[i]).node);
  }

  bool middle_is_off(std::size_t i) {
    const Corners& t = mesh_.corners[i];
    gp_XY at(0.0, 0.0);
    for (const Index c : t) {
      if (mesh_.nodes[c].pole != Pole::None) return false;
      at += mesh_.nodes[c].at.XY() / 3.0;
    }
    const Vec3 chord = (point(t[0]) + point(t[1]) + point(t[2])) / 3.0;
    return off(mesh_.face[i], at, chord).off > deflection_;
  }

  /// A place on a surface and how far from it another point is, along the normal.
  Middle off(Index face, const gp_XY& at, const Vec3& from) {
    Middle found;
    found.node.at = at;
    gp_Pnt p;
    gp_Vec du, dv;
    mesh_.surfaces[face]->D1(at.X(), at.Y(), p, du, dv);
    found.node.point = vec(p);
    const gp_Vec normal = du.Crossed(dv);
    const Vec3 way = found.node.point - from;
    found.off = normal.Magnitude() > 1e-12 * (du.Magnitude() * dv.Magnitude() + 1e-300)
                    ? std::abs(Vec3(normal.X(), normal.Y(), normal.Z()).normalized().dot(way))
                    : way.norm();
    return found;
  }

  Middle middle_between(Index a, Index b, Index face) {
    const Vec3 chord = 0.5 * (point(a) + point(b));
    const auto piece = mesh_.pieces.find(FaceMesh::pair(a, b));
    if (piece == mesh_.pieces.end()) return off(face, between(a, b), chord);
    Middle found;
    found.node = on_edge(piece->second);
    const Vec3 way = found.node.point - chord, along = (point(b) - point(a)).normalized();
    found.off = (way - way.dot(along) * along).norm();
    return found;
  }

  /// The parameters between two nodes of a face; at a pole the other one tells.
  gp_XY between(Index a, Index b) const {
    gp_XY p = mesh_.nodes[a].at.XY(), q = mesh_.nodes[b].at.XY();
    const auto take = [](gp_XY& from, Pole pole, const gp_XY& other) {
      if (pole == Pole::U) from.SetX(other.X());
      if (pole == Pole::V) from.SetY(other.Y());
    };
    take(p, mesh_.nodes[a].pole, q);
    take(q, mesh_.nodes[b].pole, p);
    return 0.5 * (p + q);
  }

  FaceNode on_edge(const EdgePiece& piece) const {
    const FaceEdge& edge = mesh_.edges[piece.edge];
    const double middle = 0.5 * (piece.from + piece.to);
    return {vec(edge.curve->Value(middle)), edge.on_face->Value(middle), Pole::None};
  }

  /// A node of its own in an edge between two nodes of one face. The two parts of a stretch of the shape's edge are
  /// such stretches.
  Index cut_edge(Index a, Index b, const FaceNode& middle) {
    const Index node = mesh_.add(middle);
    cuts_[FaceMesh::pair(a, b)] = node;
    const auto found = mesh_.pieces.find(FaceMesh::pair(a, b));
    if (found == mesh_.pieces.end()) return node;
    const EdgePiece piece = found->second;
    const double half = 0.5 * (piece.from + piece.to);
    mesh_.pieces[FaceMesh::pair(std::min(a, b), node)] = {piece.edge, piece.from, half};
    mesh_.pieces[FaceMesh::pair(std::max(a, b), node)] = {piece.edge, piece.to, half};
    return node;
  }

  /// The node of this face in the middle of an edge that is cut, one vertex with those of other faces.
  Index own_middle(Index a, Index b, Index face) {
    const auto cut = middles_.find(chord(a, b));
    if (cut == middles_.end() || cut->second == kWhole) return kWhole;
    const Index first = cut->second;
    const auto own = cuts_.find(FaceMesh::pair(a, b));
    if (own != cuts_.end()) return own->second;
    const Index node = cut_edge(a, b, middle_between(a, b, face).node);
    mesh_.same.unite(first, node);
    return node;
  }

  /// Adds what a triangle is cut into, or the triangle; whether it is cut.
  bool cut_at_middles(const Corners& t, Index face) {
    Corners m{kWhole, kWhole, kWhole};
    int count = 0;
    if (!collapsed(t))
      for (int k = 0; k < 3; ++k) {
        m[k] = own_middle(t[k], t[(k + 1) % 3], face);
        if (m[k] != kWhole) ++count;
      }
    const auto add = [&](Index a, Index b, Index c) {
      mesh_.corners.push_back({a, b, c});
      mesh_.face.push_back(face);
    };
    int k = 0;  // the edge from which on the others are told
    while (count == 1 && m[k] == kWhole) ++k;
    while (count == 2 && m[(k + 2) % 3] != kWhole) ++k;
    const Index a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
    const Index ab = m[k], bc = m[(k + 1) % 3], ca = m[(k + 2) % 3];
    if (count == 0) {
      add(a, b, c);
    } else if (count == 1) {
      add(a, ab, c);
      add(ab, b, c);
    } else {
      add(ab, b, bc);
      if (count == 3) {
        add(a, ab, ca);
        add(ca, bc, c);
        add(ab, bc, ca);
      } else if ((point(a) - point(bc)).norm() < (point(ab) - point(c)).norm()) {
        add(a, ab, bc);
        add(a, bc, c);
      } else {
        add(a, ab, c);
        add(ab, bc, c);
      }
    }
    return count > 0;
  }

  FaceMesh& mesh_;
  double deflection_;
  std::unordered_map<std::uint64_t, Index> middles_;  // of edges, by their vertices
  std::unordered_map<std::uint64_t, Index> cuts_;     // the same, by nodes of one face
  std::vector<char> settled_;  // triangles that were looked at and need no cut of their own
};

}  // namespace

void refine(FaceMesh& mesh, double deflection, double most) {
  Refinement refinement(mesh, deflection);
  for (int pass = 0; pass < kMostPasses && refinement.pass(); ++pass)
    if (static_cast<double>(mesh.corners.size()) > most)
      throw InputError(
          "Deflection",
          fmt::format("{:.3g} mm, more than {:.3g} million triangles", deflection, 1e-6 * most),
          fmt::format("give {:.3g} mm or more.", 2.0 * deflection));
}

}  // namespace patchmill

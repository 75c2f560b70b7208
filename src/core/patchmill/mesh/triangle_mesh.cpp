// Closed triangle meshes: checks and measures.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/mesh/triangle_mesh.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <tbb/parallel_sort.h>

namespace patchmill::mesh {
namespace {

Vec3 cross_of(const TriangleMesh& mesh, const std::array<std::int32_t, 3>& t) {
  const Vec3& a = mesh.vertices[t[0]];
  return (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
}

// Edges that are met more often one way than the other.
std::size_t unmatched_edges(const TriangleMesh& mesh) {
  struct Edge {
    std::int32_t a, b;
    int way;
    bool operator<(const Edge& o) const { return a != o.a ? a < o.a : b < o.b; }
  };
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const std::int32_t a = t[k], b = t[(k + 1) % 3];
      edges.push_back(a < b ? Edge{a, b, 1} : Edge{b, a, -1});
    }
  tbb::parallel_sort(edges.begin(), edges.end());
  stop_point();
  std::size_t open = 0;
  for (std::size_t i = 0; i < edges.size();) {
    int balance = 0;
    std::size_t j = i;
    for (; j < edges.size() && !(edges[i] < edges[j]); ++j) balance += edges[j].way;
    if (balance != 0) ++open;
    i = j;
  }
  return open;
}

}  // namespace

void require_indices(const TriangleMesh& mesh, const char* property) {
  if (mesh.triangles.empty())
    throw InputError(property, "0 triangles", "give a solid with a tessellated surface.");
  const auto n = static_cast<std::int32_t>(mesh.vertices.size());
  for (const auto& t : mesh.triangles)
    for (const std::int32_t v : t)
      if (v < 0 || v >= n)
        throw InputError(property, fmt::format("corner {} of {} vertices", v, n),
                         "give triangles whose corners are vertices of the mesh.");
  for (const Vec3& v : mesh.vertices)
    if (!v.allFinite()) throw InputError(property, "a vertex at infinity", "give finite vertices.");
}

Box bounds(const TriangleMesh& mesh) {
  Box box;
  for (const Vec3& v : mesh.vertices) box.include(v);
  return box;
}

double volume(const TriangleMesh& mesh) {
  if (mesh.vertices.empty()) return 0.0;
  const Vec3 o = mesh.vertices[0];
  double six = 0.0;
  for (const auto& t : mesh.triangles)
    six += (mesh.vertices[t[0]] - o).dot((mesh.vertices[t[1]] - o).cross(mesh.vertices[t[2]] - o));
  return six / 6.0;
}

double surface_area(const TriangleMesh& mesh) {
  double twice = 0.0;
  for (const auto& t : mesh.triangles) twice += cross_of(mesh, t).norm();
  return twice / 2.0;
}

void require_closed(const TriangleMesh& mesh, const char* property) {
  require_indices(mesh, property);
  if (const std::size_t open = unmatched_edges(mesh))
    throw InputError(property, fmt::format("an open shell, {} unmatched edges", open),
                     "give a closed solid; mend the gaps or the flipped triangles.");
  if (!(volume(mesh) > 0.0))
    throw InputError(property, fmt::format("volume {} mm3", volume(mesh)),
                     "give a solid whose surface faces outwards.");
}

TriangleMesh join_vertices(const TriangleMesh& mesh) {
  const auto& v = mesh.vertices;
  std::vector<std::int32_t> order(v.size()), name(v.size());
  std::iota(order.begin(), order.end(), 0);
  const auto less = [&](std::int32_t a, std::int32_t b) {
    return std::lexicographical_compare(v[a].data(), v[a].data() + 3, v[b].data(), v[b].data() + 3);
  };
  std::sort(order.begin(), order.end(), less);
  TriangleMesh out;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || v[order[i]] != v[order[i - 1]]) out.vertices.push_back(v[order[i]]);
    name[order[i]] = static_cast<std::int32_t>(out.vertices.size()) - 1;
  }
  out.triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles)
    out.triangles.push_back({name[t[0]], name[t[1]], name[t[2]]});
  return out;
}

TriangleMesh weld(const TriangleMesh& mesh) {
  TriangleMesh out = join_vertices(mesh);
  const auto lost = [](const std::array<std::int32_t, 3>& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  };
  out.triangles.erase(std::remove_if(out.triangles.begin(), out.triangles.end(), lost),
                      out.triangles.end());
  return out;
}

std::vector<std::array<Vec3, 3>> corner_normals(const TriangleMesh& mesh, Angle crease) {
  const std::size_t n = mesh.triangles.size();
  std::vector<Vec3> face(n);
  std::vector<std::array<double, 3>> weight(n);
  std::vector<std::vector<std::int32_t>> around(mesh.vertices.size());
  for (std::size_t i = 0; i < n; ++i) {
    const auto& t = mesh.triangles[i];
    face[i] = cross_of(mesh, t).normalized();
    for (int k = 0; k < 3; ++k) {
      const Vec3 p = mesh.vertices[t[(k + 1) % 3]] - mesh.vertices[t[k]];
      const Vec3 q = mesh.vertices[t[(k + 2) % 3]] - mesh.vertices[t[k]];
      weight[i][k] = Angle::between(p, q).radians();
      around[t[k]].push_back(static_cast<std::int32_t>(3 * i) + k);
    }
  }
  const double least = std::cos(crease.radians());
  std::vector<std::array<Vec3, 3>> out(n);
  for (std::size_t i = 0; i < n; ++i)
    for (int k = 0; k < 3; ++k) {
      Vec3 sum = Vec3::Zero();
      for (const std::int32_t c : around[mesh.triangles[i][k]])
        if (face[c / 3].dot(face[i]) >= least) sum += weight[c / 3][c % 3] * face[c / 3];
      out[i][k] = sum.norm() > 1e-12 ? Vec3(sum.normalized()) : face[i];
    }
  return out;
}

TriangleMesh box_mesh(const Vec3& lo, const Vec3& hi) {
  if (!((hi - lo).minCoeff() > 0.0) || !lo.allFinite() || !hi.allFinite())
    throw InputError("Box",
                     fmt::format("({:g}, {:g}, {:g}) to ({:g}, {:g}, {:g}) mm", lo.x(), lo.y(),
                                 lo.z(), hi.x(), hi.y(), hi.z()),
                     "give the least corner first; all sides must be longer than zero.");
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.emplace_back(i & 1 ? hi.x() : lo.x(), i & 2 ? hi.y() : lo.y(),
                               i & 4 ? hi.z() : lo.z());
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

}  // namespace patchmill::mesh

// LatticeMesh: a triangular lattice that grows over a sampled surface node by node, on the faces and a
// few layers beyond. What low_distortion.cpp relaxes.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/surface_lattice.h"
#include "patchmill/patch/surface_walk.h"

#include <map>

namespace patchmill::patch {

/// The six neighbours of a lattice point, counter-clockwise.
constexpr int kLatticeRing[6][2] = {{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}};

inline LatticePoint neighbour(const LatticePoint& p, int side) {
  return {p[0] + kLatticeRing[side % 6][0], p[1] + kLatticeRing[side % 6][1]};
}

/// Layers sent out over the faces' border to find other parts of them; each gets half an edge further,
/// or more.
constexpr int kGapLayers = 8;

/// Nodes by index, the start first. They are live where the map is to be good: on the faces, not too
/// steep, and within the limit.
struct LatticeMesh {
  const TexturePlane& plane;
  const SurfaceSampler& sampler;
  double edge;          ///< H: wanted distance of neighbours along the surface [mm]
  double least_cosine;  ///< of the slope of live nodes
  Box2 limit;           ///< of places of live nodes [mm]
  std::vector<LatticePoint> at;
  std::vector<WalkPoint> points;
  std::vector<char> is_live;  ///< once lost, for good: nodes that come and go keep all from rest
  std::map<LatticePoint, int> index;

  /// Index of the node at a lattice point, or -1.
  int find(const LatticePoint& p) const {
    const auto found = index.find(p);
    return found == index.end() ? -1 : found->second;
  }
  /// Whether a point is on a face, not steeper than the least cosine, and within the limit.
  bool live(const WalkPoint& p) const {
    return p.on_face && -p.normal.dot(plane.direction) >= least_cosine && limit.contains(p.place);
  }
  /// Adds a node that is not there yet.
  void add(const LatticePoint& p, const WalkPoint& point) {
    index[p] = static_cast<int>(at.size());
    at.push_back(p);
    points.push_back(point);
    is_live.push_back(live(point));
  }
};

/// Adds a layer of nodes around those at most `deepest` steps away from live ones: only live nodes, or
/// all. Returns whether there were any live ones.
bool grow(LatticeMesh& mesh, int deepest, bool only_live);

/// Brings all nodes on the surface at new places. A node that is off the faces lies on what carries on
/// its neighbours, which are placed before it. Unless `again`, a node that was off stays so. Returns
/// whether any node came back on the faces.
bool place_nodes(LatticeMesh& mesh, const std::vector<Vec2>& places, bool again);

/// Leaves only nodes at most `layers` steps away from live ones, and the start.
void forget_outside(LatticeMesh& mesh, int layers);

}  // namespace patchmill::patch

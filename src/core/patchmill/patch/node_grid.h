// NodeGrid: places in the texture plane on a rectangle of lattice indices, some of them missing,
// and smooth interpolation between them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/lattice.h"

#include <vector>

namespace patchmill::patch {

/// Places of lattice points, with what is between them.
class NodeGrid {
 public:
  /// All nodes missing. `first` and `last` are the corners of the index range, both included.
  NodeGrid(const LatticePoint& first, const LatticePoint& last);

  /// Whether a lattice point is within the range.
  bool holds(const LatticePoint& p) const {
    return p[0] >= first_[0] && p[0] <= last_[0] && p[1] >= first_[1] && p[1] <= last_[1];
  }
  /// The node's place; not finite where it is missing or beyond the range.
  Vec2 node(const LatticePoint& p) const;
  /// Sets a node within the range.
  void set(const LatticePoint& p, const Vec2& place) { places_[index(p)] = place; }

  /// Place of coordinates between the nodes: exact on nodes, cubic (Catmull-Rom) between them, of
  /// lower order where nodes are missing, and not finite beyond the nodes around.
  Vec2 at(const Vec2& coordinates) const;

  /// The lowest corner of the range.
  const LatticePoint& first() const { return first_; }
  /// The highest corner of the range.
  const LatticePoint& last() const { return last_; }

 private:
  std::size_t index(const LatticePoint& p) const {
    return static_cast<std::size_t>(p[1] - first_[1]) * columns_ +
           static_cast<std::size_t>(p[0] - first_[0]);
  }
  Vec2 along_row(double x, int i, int j) const;

  LatticePoint first_, last_;
  std::size_t columns_;
  std::vector<Vec2> places_;
};

}  // namespace patchmill::patch

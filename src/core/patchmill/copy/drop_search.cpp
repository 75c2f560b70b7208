// Branch and bound for a dropped ball; see drop_search.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/copy/drop_search.h"

#include <algorithm>

namespace patchmill::copy {
namespace {

// The children whose bits are set, the one of the highest bound first.
template <typename Visit>
void highest_first(unsigned children, const mesh::DropNode::Row& bound, const Visit& visit) {
  while (children != 0) {
    int highest = __builtin_ctz(children);
    for (unsigned rest = children & (children - 1); rest != 0; rest &= rest - 1) {
      const int i = __builtin_ctz(rest);
      if (bound[i] > bound[highest]) highest = i;
    }
    if (!visit(highest)) return;
    children &= ~(1u << highest);
  }
}

// What is still to be looked at, the most promising on top.
struct Stack {
  struct Item {
    std::int32_t child;  // as in DropNode
    float bound;
  };
  Item item[16 * mesh::kDropWidth];  // a tree of 2^31 triangles is ten nodes deep
  int top = 0;

  // The children whose bits are set, above what is there; of these the highest on top.
  void push(const mesh::DropNode& node, unsigned children, const mesh::DropNode::Row& bound) {
    const int first = top;
    for (; children != 0; children &= children - 1) {
      const int i = __builtin_ctz(children);
      int at = top++;
      for (; at > first && item[at - 1].bound > bound[i]; --at) item[at] = item[at - 1];
      item[at] = {node.child[i], bound[i]};
    }
  }
};

}  // namespace

DropSearch::DropSearch(const mesh::TriangleBvh& bvh, double x, double y, double radius,
                       double floor)
    : bvh_(bvh),
      x_(x),
      y_(y),
      radius_(radius),
      floor_(floor),
      ball_(mesh::drop_ball_over(bvh.drops(), x, y, radius)),
      lowest_(mesh::drop_floor(bvh.drops(), floor)) {}

void DropSearch::touch(std::int32_t triangle) {
  const double height = drop_ball_on(bvh_.triangles()[triangle], x_, y_, radius_);
  if (height_ == kNoContact) guess_ = triangle;
  if (height <= height_) return;
  height_ = height;
  triangle_ = triangle;
  lowest_ = mesh::drop_floor(bvh_.drops(), std::max(height, floor_));
}

void DropSearch::look_at(const mesh::DropLeaf& leaf) {
  mesh::DropNode::Row bound;
  highest_first(mesh::drop_bounds(leaf, ball_, lowest_, bound), bound, [&](int i) {
    if (bound[i] <= lowest_) return false;
    if (leaf.node.child[i] != guess_) touch(leaf.node.child[i]);
    return true;
  });
}

void DropSearch::look_at_all() {
  const mesh::DropTree& tree = bvh_.drops();
  mesh::DropNode::Row bound;
  Stack stack;
  const auto open = [&](const mesh::DropNode& node) {
    stack.push(node, mesh::drop_bounds(node, ball_, lowest_, bound), bound);
  };
  open(tree.nodes()[0]);
  while (stack.top > 0) {
    const Stack::Item next = stack.item[--stack.top];
    if (next.bound <= lowest_) continue;
    if (next.child >= 0)
      open(tree.nodes()[next.child]);
    else
      look_at(tree.leaves()[~next.child]);
  }
}

}  // namespace patchmill::copy

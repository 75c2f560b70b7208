// Lines of a tool path and of its axes; see path_nodes.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/path_nodes.h"

#include "scene/shapes.h"

#include <algorithm>

namespace patchmill::scene {
namespace {

constexpr std::size_t kChunk = 20000;  // moves in one node: cached, and culled, together

void add_moves(Polylines& lines, const ToolPath& path, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last;) {
    const std::size_t begin = lines.vertices.size();
    const MoveKind kind = path.moves[i].kind;
    const Rgba colour = move_colour(kind);
    lines.add(i == 0 ? path.start.tip : path.moves[i - 1].end.tip, colour);
    for (; i < last && path.moves[i].kind == kind; ++i) lines.add(path.moves[i].end.tip, colour);
    lines.close_from(begin);
  }
}

}  // namespace

Display path_display(const ToolPath& path, std::size_t first, std::size_t last) {
  last = std::min(last, path.moves.size());
  Display display;
  for (std::size_t i = first; i < last; i += kChunk) {
    Polylines lines;
    add_moves(lines, path, i, std::min(i + kChunk, last));
    display.push_back(line_node(lines, 1.0f).file());
  }
  return display;
}

Display path_axis_display(const ToolPath& path, double length, std::size_t most) {
  Polylines lines;
  const std::size_t count = path.moves.size();
  const std::size_t stride = std::max<std::size_t>(1, count / std::max<std::size_t>(1, most));
  for (std::size_t i = 0; i < count; i += stride) {
    const ToolPose& pose = path.moves[i].end;
    if (path.moves[i].kind == MoveKind::Rapid) continue;
    const std::size_t first = lines.vertices.size();
    lines.add(pose.tip, 0x6a3d9aff);
    lines.add(pose.tip + length * pose.axis, 0x6a3d9aff);
    lines.close_from(first);
  }
  return {line_node(lines, 1.0f).file()};
}

}  // namespace patchmill::scene

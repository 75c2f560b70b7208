// Linking of cuts; see path_builder.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/copy/path_builder.h"

namespace patchmill::copy {

PathBuilder::PathBuilder(const CopyOptions& options, FreeAbove free_above)
    : options_(options),
      free_above_(std::move(free_above)),
      safe_(options.stock.hi.z() + options.clearance),
      tip_(options.stock.lo.x(), options.stock.lo.y(), safe_) {
  path_.tool = options.tool;
  path_.spindle = options.spindle;
  path_.start = {tip_, Vec3::UnitZ()};
}

void PathBuilder::rapid(const Vec3& tip) {
  if (tip == tip_) return;
  Move move;
  move.end.tip = tip;
  path_.moves.push_back(move);
  tip_ = tip;
}

void PathBuilder::feed(const Vec3& tip, MoveKind kind) {
  if (tip == tip_) return;
  Move move;
  move.end.tip = tip;
  move.kind = kind;
  move.turns = options_.spindle.speed * (tip - tip_).norm() / options_.feed;
  path_.moves.push_back(move);
  tip_ = tip;
}

void PathBuilder::cut(const std::vector<Vec3>& centres) {
  if (centres.size() < 2) return;
  if (!free_above_) return cut_from_above(centres);
  const std::size_t n = centres.size();
  std::size_t first = 0, last = n - 1;
  while (first < n && !free_above_(centres[first])) ++first;
  if (first == n) {
    ++unreached_;
    return;
  }
  while (!free_above_(centres[last])) --last;
  std::vector<Vec3> way;
  for (std::size_t i = first; i > 0; --i) way.push_back(centres[i]);
  way.insert(way.end(), centres.begin(), centres.end());
  for (std::size_t i = n - 1; i > last; --i) way.push_back(centres[i - 1]);
  cut_from_above(way);
}

void PathBuilder::cut_from_above(const std::vector<Vec3>& centres) {
  const Vec3 down(0, 0, options_.tool.corner());
  const Vec3 first = centres.front() - down;
  if ((first - tip_).norm() > 1e-9) {
    rapid({tip_.x(), tip_.y(), safe_});
    rapid({first.x(), first.y(), safe_});
    feed(first, MoveKind::Link);
  }
  for (std::size_t i = 1; i < centres.size(); ++i) feed(centres[i] - down, MoveKind::Cut);
}

CopiedPath PathBuilder::finish() {
  rapid({tip_.x(), tip_.y(), safe_});
  return {std::move(path_), unreached_};
}

}  // namespace patchmill::copy

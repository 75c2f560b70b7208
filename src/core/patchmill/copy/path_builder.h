// Puts polylines of ball centres together to a tool path with an upright tool: rapid over the next
// beginning, feed down, cut, rapid up. Below an overhang it begins at the first place from which the ball can
// be lifted freely, goes back to the beginning, and afterwards to the last such place.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/copy/copy_milling.h"

#include <functional>
#include <vector>

namespace patchmill::copy {

/// True where nothing of the part is above a ball with this centre [mm].
using FreeAbove = std::function<bool(const Vec3& centre)>;

/// Makes one ToolPath of lines that are to be cut.
class PathBuilder {
 public:
  /// The tool begins at the safe height over the low corner of the stock.
  /// `free_above` empty: true everywhere.
  explicit PathBuilder(const CopyOptions& options, FreeAbove free_above = {});
  /// Cuts along ball centres [mm]; a polyline that begins where the last one ended is just gone on
  /// with. One of which no point can be reached from above is left out, and counted.
  void cut(const std::vector<Vec3>& centres);
  /// Lifts the tool and gives the path; no more may be cut after it.
  CopiedPath finish();

 private:
  void cut_from_above(const std::vector<Vec3>& centres);
  void rapid(const Vec3& tip);
  void feed(const Vec3& tip, MoveKind kind);
  const CopyOptions& options_;
  FreeAbove free_above_;
  double safe_;
  int unreached_ = 0;
  Vec3 tip_;
  ToolPath path_;
};

}  // namespace patchmill::copy

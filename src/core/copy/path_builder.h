// Puts polylines of ball centres together to a tool path with an upright tool: rapid over the next
// beginning, feed down, cut, rapid up.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "core/copy/copy_milling.h"

#include <vector>

namespace patchmill {

class PathBuilder {
 public:
  /// The tool begins at the safe height over the low corner of the stock.
  explicit PathBuilder(const CopyOptions& options);
  /// Cuts along ball centres [mm]; a polyline that begins where the last one ended is just gone on
  /// with.
  void cut(const std::vector<Vec3>& centres);
  ToolPath finish();

 private:
  void rapid(const Vec3& tip);
  void feed(const Vec3& tip, MoveKind kind);
  const CopyOptions& options_;
  double safe_;
  Vec3 tip_;
  ToolPath path_;
};

}  // namespace patchmill

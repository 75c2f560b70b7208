// One move of a tool held against a part: how far the cutting end and each section of the tool come too near to it at
// most. Where the distance of a moved section is known (PartShape::swept), a move without a turn takes one search, and
// one that turns is halved until what the turn may add does not matter. Else, and where the tool is inside the part,
// the move is walked in steps.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/collision/clearance.h"

namespace patchmill::collision {

/// One move, as a pose for each fraction of it.
struct Swing {
  ToolPose from, to;
  Eigen::Quaterniond turn;
  double angle;  ///< [rad]

  /// From one pose to the next; the axis turns the shorter way.
  Swing(const ToolPose& from, const ToolPose& to);

  /// The pose at a fraction of the move, 0 .. 1.
  ToolPose at(double fraction) const;
  /// Longest way of a point of the tool within `reach` of the tip [mm].
  double length(double reach) const { return (to.tip - from.tip).norm() + angle * reach; }
};

/// Checks moves of one tool against one part.
class MoveCheck {
 public:
  /// All of them must outlive it; findings and unknown moves are added to the report.
  MoveCheck(const Tool& tool, const PartShape& part, const ClearanceOptions& options,
            ClearanceReport& report)
      : tool_(tool), part_(part), options_(options), report_(report) {}

  /// The ball, or all points within the corner's radius of the core of the cutting end.
  void end(std::int64_t number, const Swing& swing);
  /// The same of a section above the cutting end.
  void section(std::int64_t number, const Swing& swing, const ToolSection& section);

 private:
  /// All that is within `around` [mm] of a section; nothing of it is further than `reach` from the tip. It may come
  /// as near as -`allowed`.
  struct Piece {
    ToolSection section;
    double around, reach, allowed;
  };
  struct Sweep;

  Piece piece_of(const ToolSection& section, double around) const;
  Sweep sweep_of(const Swing& swing, const Piece& piece, double from, double to) const;
  bool sweep(const Swing& swing, const Piece& piece, double from, double to,
             ClearanceFinding& worst) const;
  SectionDistance nearest(const Piece& piece, const ToolPose& pose, double enough) const;
  void check(std::int64_t number, const Swing& swing, const Piece& piece);
  void walk(const Swing& swing, const Piece& piece, ClearanceFinding& worst);
  Vec3 foot(const Vec3& from, double distance) const;

  const Tool& tool_;
  const PartShape& part_;
  const ClearanceOptions& options_;
  ClearanceReport& report_;
};

}  // namespace patchmill::collision

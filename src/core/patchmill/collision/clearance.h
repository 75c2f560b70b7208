// Gouge and collision: does the cutting end, the shank or the holder go deeper into the part than allowed,
// anywhere on a path, links and rapids included? By the distance of what the tool sweeps on a move
// where it is known; else in steps: the distance to the part changes no faster than the tool moves,
// so a step may be as long as the clearance allows. Nothing is jumped over (move_check.h).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/collision/frustum.h"
#include "patchmill/geometry/progress.h"
#include "patchmill/path/tool_path.h"

#include <functional>
#include <limits>
#include <string>

namespace patchmill::collision {

/// Signed distance [mm] of a place from the part as it is to be: positive outside, negative inside.
/// Must not change faster than the place does. NaN: not known there. Is called from several
/// threads at once.
using PartDistance = std::function<double(const Vec3&)>;

/// How near a section comes to the part, negative by how deep the part reaches into it, and where [mm].
struct SectionDistance {
  double distance = std::numeric_limits<double>::infinity();
  Vec3 place = Vec3::Zero();
};

/// The same of a section that moves without a turn. `inside`: all of what it sweeps is inside the part.
struct SweptSection : SectionDistance {
  double fraction = 0.0;  ///< of the travel, 0 .. 1, where it is nearest
  bool inside = false;
};

/// The part to check against.
struct PartShape {
  PartDistance distance;
  /// Distance of a section at a pose; where it is above `enough`, anything from there to it will do. Empty:
  /// the section is searched by `distance`, which takes long where flat meets flat.
  std::function<SectionDistance(const ToolSection&, const ToolPose&, double enough)> section;
  /// Distance of a section that goes from a pose along a travel [mm] without a turn, from the part's surface, found
  /// to `within` [mm] or a fiftieth of what it is below `enough`; where it is above `enough`, anything from there to
  /// it will do. Empty: moves are walked in steps.
  std::function<SweptSection(const ToolSection&, const ToolPose&, const Vec3& travel, double enough,
                             double within)>
      swept;

  PartShape() = default;
  /// A part of which only the distance of points is known.
  /// A part of which only the distance of points is known.
  template <class Distance>
  PartShape(Distance known) : distance(std::move(known)) {}  // NOLINT: a distance is a shape
};

/// What is allowed, and how closely it is looked at.
struct ClearanceOptions {
  double tolerance = 0.002;  ///< ball and flutes may go so deep below the part's surface [mm]
  double clearance = 0.1;    ///< shank and holder must keep so far away from it [mm]
  double resolution =
      0.001;  ///< what is deeper than allowed by more than this is surely found [mm]
  std::size_t most_findings = 1000;  ///< after so many, the check stops
  std::size_t first_move = 0;        ///< moves before it start nobody knows where and are left out
  bool cutting = true;  ///< look at the cutting end and flutes too, not at shank and holder only
};

/// One stretch of a move that comes too near, at its worst place.
struct ClearanceFinding {
  ToolPart part = ToolPart::Ball;
  std::int64_t move = 0;      ///< number of the move in the path
  double share = 0.0;         ///< of the move, 0 .. 1, where it is worst
  Vec3 place = Vec3::Zero();  ///< on the part, or of the section if only a distance is known [mm]
  double depth =
      0.0;  ///< by which the allowed distance is fallen short of [mm], > 0; within a tenth
};

enum class ClearanceOutcome : std::uint8_t {
  Clear,
  Violated,
  Unknown  ///< the distance was not known at some place, or the check was stopped: not a pass
};

/// What a check found.
struct ClearanceReport {
  ClearanceOutcome outcome = ClearanceOutcome::Unknown;
  std::vector<ClearanceFinding>
      findings;                    ///< the worst of each part of the tool on each move, in order
  std::int64_t unknown_moves = 0;  ///< moves with a place of unknown distance
  std::string reason;              ///< why Unknown, a sentence
};

/// Checks the path's tool with all its sections on every move, from its start to its end on a straight line of the
/// tip, the axis turning evenly. A part without a distance, or a first move beyond the last one: Unknown. Errors:
/// InputError naming BallRadius, Tolerance or Clearance (0 .. 1e6 mm), Resolution (1e-6 .. 1e6 mm), or what
/// require_valid(Tool) names.
ClearanceReport check_clearance(const ToolPath& path, const PartShape& part,
                                const ClearanceOptions& options = {},
                                const Progress& progress = {});

/// The same with `sections` in the place of the tool's own. Errors: also InputError naming ToolSection.
ClearanceReport check_sections(const ToolPath& path, const std::vector<ToolSection>& sections,
                               const PartShape& part, const ClearanceOptions& options = {},
                               const Progress& progress = {});

}  // namespace patchmill::collision

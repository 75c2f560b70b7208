// Motions of G-code that are more than a straight line: arcs and drilling cycles, as lines. Reader and writers
// share them: what a control has no word for is written as the moves that the word means.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/vec.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace patchmill::gcode {

/// G17, G18 and G19: the plane that an arc turns in, and the axis across it.
enum class ArcPlane : std::uint8_t { XY, ZX, YZ };

/// An arc or helix.
struct Arc {
  Vec3 from, to;  ///< [mm]
  Vec3 centre;    ///< its coordinate across the plane does not count
  ArcPlane plane = ArcPlane::XY;
  bool clockwise = false;  ///< seen from the positive end of the axis across
  int turns = 1;           ///< P: whole turns that are begun
};

/// Angle [rad] that the arc turns through, > 0: from 0 (exclusive) to 2 pi, and 2 pi for each further turn.
double arc_angle(const Arc& arc);
/// Length of the arc or helix [mm].
double arc_length(const Arc& arc);
/// Greatest difference of the radii at start, end and as meant [mm].
double arc_spread(const Arc& arc);

/// Points after `from`, the last of which is `to`, that leave the arc by no more than `chord` [mm].
std::vector<Vec3> arc_points(const Arc& arc, double chord);

/// The centre of an arc of radius `radius` [mm] (G2 R); negative: the longer way. None if the ends are farther
/// apart than the diameter, or the same.
std::optional<Vec3> arc_centre(const Vec3& from, const Vec3& to, double radius, ArcPlane plane,
                               bool clockwise);

/// A drilling cycle as it is in force.
struct DrillingCycle {
  int code = 810;          ///< 730, 810, 820, 830, 850, 890: G words in tenths
  double bottom = 0.0;     ///< Z [mm]
  double retract = 0.0;    ///< R [mm]
  double initial = 0.0;    ///< Z before the cycle [mm]
  double peck = 0.0;       ///< Q [mm], > 0 for G73 and G83
  double seconds = 0.0;    ///< P
  bool to_initial = true;  ///< G98; else G99
};

/// One straight move of a drilling cycle.
struct CycleStep {
  /// What it does.
  enum class Kind : std::uint8_t { Rapid, Feed, Dwell } kind = Kind::Rapid;
  double z = 0.0;        ///< height at its end [mm]
  double seconds = 0.0;  ///< of a dwell
};

/// The moves in Z of one hole once the tool stands over it at the height R or higher; they begin with the rapid to
/// R. Errors: InputError naming Path if the bottom is above R, or a peck is missing.
std::vector<CycleStep> cycle_steps(const DrillingCycle& cycle);

}  // namespace patchmill::gcode

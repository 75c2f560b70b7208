// Sweeps and steps along a move; see move_check.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/collision/move_check.h"

#include "patchmill/collision/cell_search.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace patchmill::collision {
namespace {

constexpr double kDisc = 1e-6;  // least height of a frustum [mm]
constexpr double kWithin =
    0.1;  // fraction of a depth, and of the resolution, to which they are found

}  // namespace

Swing::Swing(const ToolPose& a, const ToolPose& b)
    : from(a),
      to(b),
      turn(Eigen::Quaterniond::FromTwoVectors(a.axis, b.axis)),
      angle(Angle::between(a.axis, b.axis).radians()) {}

ToolPose Swing::at(double fraction) const {
  const Vec3 axis = angle > 0.0
                        ? Vec3(Eigen::Quaterniond::Identity().slerp(fraction, turn) * from.axis)
                        : from.axis;
  return {from.tip + fraction * (to.tip - from.tip), axis};
}

/// A section that moves without a turn, and how far [mm] that is from a part of a move at most.
struct MoveCheck::Sweep {
  ToolSection section;
  ToolPose pose;
  Vec3 travel = Vec3::Zero();
  double off = 0.0;
};

MoveCheck::Piece MoveCheck::piece_of(const ToolSection& section, double around) const {
  const double reach =
      std::hypot(section.to, std::max(section.radius_from, section.radius_to)) + around;
  return {section, around, reach, cuts(section.part) ? options_.tolerance : -options_.clearance};
}

void MoveCheck::end(std::int64_t number, const Swing& swing) {
  const double r = tool_.corner();
  if (tool_.is_ball()) {
    check(number, swing, piece_of({ToolPart::Ball, 0.0, 0.0, 0.0, 0.0}, r));
    return;
  }
  const Frustum core = tool_.end_core();
  check(number, swing,
        piece_of({ToolPart::End, core.from, core.to, core.radius_from, core.radius_to}, r));
}

void MoveCheck::section(std::int64_t number, const Swing& swing, const ToolSection& section) {
  check(number, swing, piece_of(section, 0.0));
}

// The centre of a ball goes along a line: a frustum without a radius, and that is all. With a turn it leaves its chord
// by the error of an interpolation, angle²/8 of the radius. A section keeps the axis in the middle of the turn.
MoveCheck::Sweep MoveCheck::sweep_of(const Swing& swing, const Piece& piece, double from,
                                     double to) const {
  const ToolPose first = swing.at(from), last = swing.at(to);
  const double angle = (to - from) * swing.angle;
  if (piece.section.part == ToolPart::Ball) {
    const Vec3 start = ball_centre(first, piece.around);
    const Vec3 way = ball_centre(last, piece.around) - start;
    const double length = way.norm();
    return {{ToolPart::Ball, 0.0, std::max(length, kDisc), 0.0, 0.0},
            {start, length > 0.0 ? Vec3(way / length) : first.axis},
            Vec3::Zero(),
            piece.around * angle * angle / 8.0};
  }
  return {piece.section,
          {first.tip, swing.at(0.5 * (from + to)).axis},
          last.tip - first.tip,
          0.5 * angle * piece.reach};
}

/// The worst of a part of a move, if it is worse than the worst so far by more than a tenth. False if the core of the
/// piece is, or may be, all inside the part somewhere: no distance from the surface tells how deep that is.
bool MoveCheck::sweep(const Swing& swing, const Piece& piece, double from, double to,
                      ClearanceFinding& worst) const {
  const bool ball = piece.section.part == ToolPart::Ball;
  const Sweep s = sweep_of(swing, piece, from, to);
  const double within = kWithin * std::max(options_.resolution, 0.5 * worst.depth);
  const auto swept = [&](const Sweep& part, double matters) {
    return part_.swept(part.section, part.pose, part.travel, matters, within);
  };
  const double limit = piece.around - piece.allowed;
  const double matters = limit - (1.0 + kWithin) * worst.depth + s.off;
  SweptSection found = swept(s, matters);
  if (found.inside || (piece.around > 0.0 && found.distance < kWithin * piece.around)) return false;
  if (found.distance >= matters) return true;
  if (ball)
    found.fraction =
        std::clamp((found.place - s.pose.tip).dot(s.pose.axis) / s.section.to, 0.0, 1.0);
  const double fraction = from + found.fraction * (to - from);
  if (s.off > 0.0) found = swept(sweep_of(swing, piece, fraction, fraction), limit);
  if (limit - found.distance > worst.depth) {
    worst.depth = limit - found.distance;
    worst.share = fraction;
    worst.place = found.place;
  }
  if (s.off <= 0.5 * std::max(options_.resolution, kWithin * worst.depth)) return true;
  const double middle = 0.5 * (from + to);
  const bool second = fraction > middle;  // where it is worst is looked at first
  return sweep(swing, piece, second ? middle : from, second ? to : middle, worst) &&
         sweep(swing, piece, second ? from : middle, second ? middle : to, worst);
}

/// How near a piece comes at a pose; at `enough` and beyond anything from there on will do.
SectionDistance MoveCheck::nearest(const Piece& piece, const ToolPose& pose, double enough) const {
  if (piece.section.part == ToolPart::Ball) {
    const Vec3 centre = ball_centre(pose, piece.around);
    const double d = part_.distance(centre);
    return {d - piece.around, d - piece.around < -piece.allowed ? foot(centre, d) : centre};
  }
  SectionDistance found;
  if (part_.swept) {
    const double limit = piece.around - piece.allowed;
    const SweptSection deep =
        part_.swept(piece.section, pose, Vec3::Zero(), limit, kWithin * options_.resolution);
    const Vec3 middle = pose.tip + 0.5 * (piece.section.from + piece.section.to) * pose.axis;
    if (deep.inside) return {part_.distance(middle) - piece.around, middle};
    if (deep.distance < limit) return {deep.distance - piece.around, deep.place};
  }
  if (part_.section) {
    found = part_.section(piece.section, pose, enough + piece.around);
  } else {
    CellSearch search(piece.section, part_.distance, 0.5 * options_.resolution);
    found = search.find(pose, piece.around - piece.allowed, enough + piece.around);
  }
  const double core = found.distance;
  found.distance -= piece.around;
  // what is no nearer than a limit stays so, whatever rounding does
  for (const double known : {-piece.allowed, enough})
    if (core >= known + piece.around) found.distance = std::max(found.distance, known);
  return found;
}

void MoveCheck::check(std::int64_t number, const Swing& swing, const Piece& piece) {
  ClearanceFinding worst{piece.section.part, number, 0.0, Vec3::Zero(), 0.0};
  if (!part_.swept || !sweep(swing, piece, 0.0, 1.0, worst)) walk(swing, piece, worst);
  if (worst.depth > 0.0) report_.findings.push_back(worst);
}

/// In steps: the distance changes no faster than the piece moves, so that nothing is worse than the worst so far by
/// more than a tenth before it has moved by what is missing to that.
void MoveCheck::walk(const Swing& swing, const Piece& piece, ClearanceFinding& worst) {
  const double length = swing.length(piece.reach);
  double share = 0.0;
  while (true) {
    const SectionDistance now =
        nearest(piece, swing.at(share), (1.0 - share) * length - piece.allowed);
    if (std::isnan(now.distance)) {
      ++report_.unknown_moves;
      report_.reason =
          fmt::format("The distance to the part is not known at ({:.3f}, {:.3f}, {:.3f}), move {}.",
                      now.place.x(), now.place.y(), now.place.z(), worst.move);
      return;
    }
    const double room = now.distance + piece.allowed;
    if (-room > worst.depth) {
      worst.depth = -room;
      worst.share = share;
      worst.place = now.place;
    }
    if (share >= 1.0 || !(length > 0.0)) return;
    const double step = std::max(room + (1.0 + kWithin) * worst.depth, options_.resolution);
    share = std::min(share + step / length, 1.0);
  }
}

/// Nearest place of the part: down the gradient of the distance.
Vec3 MoveCheck::foot(const Vec3& from, double d) const {
  const double h = 1e-4;
  Vec3 gradient;
  for (int k = 0; k < 3; ++k)
    gradient[k] =
        part_.distance(from + h * Vec3::Unit(k)) - part_.distance(from - h * Vec3::Unit(k));
  return gradient.norm() > 0.0 ? Vec3(from - d * gradient.normalized()) : from;
}

}  // namespace patchmill::collision

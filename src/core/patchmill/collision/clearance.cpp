// Conservative advancement along a path; see clearance.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/collision/clearance.h"

#include "patchmill/collision/cell_search.h"
#include "patchmill/geometry/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

namespace patchmill::collision {
namespace {

using Nearest = SectionDistance;

constexpr double kDisc = 1e-6;  // thickness of the disc in the end of a cutter that is no ball [mm]

/// One move, as a pose for each share of it.
struct Swing {
  ToolPose from, to;
  Eigen::Quaterniond turn;
  double angle;

  Swing(const ToolPose& a, const ToolPose& b)
      : from(a),
        to(b),
        turn(Eigen::Quaterniond::FromTwoVectors(a.axis, b.axis)),
        angle(Angle::between(a.axis, b.axis).radians()) {}

  ToolPose at(double share) const {
    const Vec3 axis = angle > 0.0
                          ? Vec3(Eigen::Quaterniond::Identity().slerp(share, turn) * from.axis)
                          : from.axis;
    return {from.tip + share * (to.tip - from.tip), axis};
  }
  /// Longest way of a point of the tool within `reach` of the tip [mm].
  double length(double reach) const { return (to.tip - from.tip).norm() + angle * reach; }
};

class Checker {
 public:
  Checker(const ToolPath& path, const PartShape& part, const ClearanceOptions& options,
          ClearanceReport& report)
      : path_(path), part_(part), options_(options), report_(report) {}

  /// Walks a move; `nearest(pose, enough)` gives the distance that is allowed to fall to
  /// -`allowed`.
  template <class Nearness>
  void walk(std::int64_t number, const Swing& swing, ToolPart part, double reach, double allowed,
            Nearness&& nearest) {
    const double length = swing.length(reach);
    double share = 0.0;
    std::optional<ClearanceFinding> worst;
    while (true) {
      const Nearest now = nearest(swing.at(share), -allowed, (1.0 - share) * length - allowed);
      if (std::isnan(now.distance)) {
        ++report_.unknown_moves;
        report_.reason = fmt::format(
            "The distance to the part is not known at ({:.3f}, {:.3f}, {:.3f}), move {}.",
            now.place.x(), now.place.y(), now.place.z(), number);
        break;
      }
      const double room = now.distance + allowed;
      if (room < 0.0 && (!worst || -room > worst->depth))
        worst = {part, number, share, now.place, -room};
      if (room >= 0.0) keep(worst);
      if (share >= 1.0) break;
      // so deep in the part, the tool is not out of it within the same travel
      const double step = std::max(room < 0.0 ? -0.1 * room : room, options_.resolution);
      share = std::min(share + step / length, 1.0);
      if (!(length > 0.0)) share = 1.0;
    }
    keep(worst);
  }

  void ball(std::int64_t number, const Swing& swing) {
    const double r = path_.tool.radius;
    walk(number, swing, ToolPart::Ball, r, options_.tolerance,
         [&](const ToolPose& pose, double, double) {
           const Vec3 centre = ball_centre(pose, r);
           const double d = part_.distance(centre);
           return Nearest{d - r, d - r < -options_.tolerance ? foot(centre, d) : centre};
         });
  }

  /// The cutting end: all points within the corner's radius of a disc, the lower end of the cutter's core.
  void end(std::int64_t number, const Swing& swing) {
    const Tool& tool = path_.tool;
    if (tool.is_ball()) return ball(number, swing);
    const double r = tool.corner();
    const Frustum disc = tool.core(r + kDisc);
    section(number, swing, {ToolPart::End, disc.from, disc.to, disc.radius_from, disc.radius_to},
            r);
  }

  /// A piece of the tool, thicker by `around` on all sides [mm].
  void section(std::int64_t number, const Swing& swing, const ToolSection& piece,
               double around = 0.0) {
    const double reach =
        std::hypot(piece.to, std::max(piece.radius_from, piece.radius_to)) + around;
    const bool cuts = piece.part == ToolPart::Flute || piece.part == ToolPart::End;
    const double allowed = cuts ? options_.tolerance : -options_.clearance;
    // what is no nearer than a limit stays so, whatever rounding does
    const auto outside = [&](const Nearest& core, double limit, double enough) {
      Nearest found{core.distance - around, core.place};
      for (const double known : {limit, enough})
        if (core.distance >= known + around) found.distance = std::max(found.distance, known);
      return found;
    };
    if (part_.section) {
      walk(number, swing, piece.part, reach, allowed,
           [&](const ToolPose& pose, double limit, double enough) {
             return outside(part_.section(piece, pose, enough + around), limit, enough);
           });
      return;
    }
    CellSearch search(piece, part_.distance, 0.5 * options_.resolution);
    walk(number, swing, piece.part, reach, allowed,
         [&](const ToolPose& pose, double limit, double enough) {
           return outside(search.find(pose, limit + around, enough + around), limit, enough);
         });
  }

 private:
  /// Nearest place of the part: down the gradient of the distance.
  Vec3 foot(const Vec3& from, double d) const {
    const double h = 1e-4;
    Vec3 gradient;
    for (int k = 0; k < 3; ++k)
      gradient[k] =
          part_.distance(from + h * Vec3::Unit(k)) - part_.distance(from - h * Vec3::Unit(k));
    return gradient.norm() > 0.0 ? Vec3(from - d * gradient.normalized()) : from;
  }

  void keep(std::optional<ClearanceFinding>& worst) {
    if (worst) report_.findings.push_back(*worst);
    worst.reset();
  }

  const ToolPath& path_;
  const PartShape& part_;
  const ClearanceOptions& options_;
  ClearanceReport& report_;
};

void require_valid(const ToolPath& path, const std::vector<ToolSection>& sections,
                   const ClearanceOptions& options) {
  require_positive("BallRadius", path.tool.radius, "mm");
  require_valid(path.tool);
  require_in_range("Tolerance", options.tolerance, 0.0, 1e6, "mm");
  require_in_range("Clearance", options.clearance, 0.0, 1e6, "mm");
  require_in_range("Resolution", options.resolution, 1e-6, 1e6, "mm");
  const double most = 1e6;
  for (const ToolSection& s : sections)
    if (!(s.from >= 0.0 && s.from < s.to && s.to <= most) ||
        !(std::min(s.radius_from, s.radius_to) >= 0.0) || !(s.radius_from <= most) ||
        !(s.radius_to <= most))
      throw InputError(
          "ToolSection",
          fmt::format("{} from {} to {} mm, radii {} and {} mm", name(s.part), s.from, s.to,
                      s.radius_from, s.radius_to),
          "a section goes upward from 0 or more, has radii of 0 or more, and all are at "
          "most 1e6 mm.");
}

void check_moves(const ToolPath& path, const std::vector<ToolSection>& sections,
                 const PartShape& part, const ClearanceOptions& options, std::size_t from,
                 std::size_t to, ClearanceReport& report) {
  Checker checker(path, part, options, report);
  for (std::size_t i = from; i < to && report.findings.size() < options.most_findings; ++i) {
    const Swing swing(i > 0 ? path.moves[i - 1].end : path.start, path.moves[i].end);
    const auto number = static_cast<std::int64_t>(i);
    checker.end(number, swing);
    for (const ToolSection& piece : sections) checker.section(number, swing, piece);
  }
}

}  // namespace

const char* name(ToolPart part) {
  switch (part) {
    case ToolPart::Ball:
      return "ball";
    case ToolPart::End:
      return "cutting end";
    case ToolPart::Flute:
      return "flute";
    case ToolPart::Shank:
      return "shank";
    default:
      return "holder";
  }
}

ClearanceReport check_clearance(const ToolPath& path, const std::vector<ToolSection>& sections,
                                const PartShape& part, const ClearanceOptions& options,
                                const Progress& progress) {
  require_valid(path, sections, options);
  ClearanceReport report;
  if (!part.distance) report.reason = "There is no shape of the part to measure distances from.";
  if (options.first_move > 0 && options.first_move >= path.moves.size())
    report.reason = "No move of the path was looked at.";
  if (!report.reason.empty()) return report;
  constexpr std::size_t kBlock = 64, kRound = 16;  // moves checked by one thread, blocks in a round
  const std::size_t count = path.moves.size();
  bool stopped = false;
  for (std::size_t begin = options.first_move; begin < count && !stopped;
       begin += kBlock * kRound) {
    std::array<ClearanceReport, kRound> blocks;
    tbb::parallel_for(std::size_t{0}, kRound, [&](std::size_t k) {
      const std::size_t from = begin + k * kBlock;
      check_moves(path, sections, part, options, from, std::min(from + kBlock, count), blocks[k]);
    });
    for (const ClearanceReport& block : blocks) {
      report.findings.insert(report.findings.end(), block.findings.begin(), block.findings.end());
      report.unknown_moves += block.unknown_moves;
      if (report.reason.empty()) report.reason = block.reason;
    }
    const double share =
        static_cast<double>(std::min(begin + kBlock * kRound, count)) / static_cast<double>(count);
    stopped = report.findings.size() >= options.most_findings || !go_on(progress, share);
  }
  if (report.findings.size() > options.most_findings) report.findings.resize(options.most_findings);
  if (!report.findings.empty())
    report.outcome = ClearanceOutcome::Violated;
  else if (!stopped && report.unknown_moves == 0)
    report.outcome = ClearanceOutcome::Clear;
  if (stopped && report.reason.empty()) report.reason = "The check was stopped before its end.";
  return report;
}

}  // namespace patchmill::collision

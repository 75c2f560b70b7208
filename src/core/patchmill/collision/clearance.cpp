// Conservative advancement along a path; see clearance.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/collision/clearance.h"

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

struct FrustumCell {
  double low[3], high[3];  // height, share of the radius, azimuth
};

class FrustumSearch {
 public:
  FrustumSearch(const ToolSection& section, const PartDistance& distance, double resolution)
      : section_(section), distance_(distance), resolution_(resolution) {}

  /// Least distance of the frustum. Where it is above `limit` a lower bound will do: above
  /// `enough`, or half of what there is over the limit. Below `limit` it is found to a fiftieth of
  /// the shortfall; never finer than the resolution. NaN distance if it is unknown anywhere that
  /// matters.
  Nearest find(const ToolPose& pose, double limit, double enough) {
    pose_ = pose;
    x_ = any_normal_to(pose.axis);
    y_ = pose.axis.cross(x_);
    best_ = {};
    queue_ = {};
    push({{section_.from, 0.0, 0.0}, {section_.to, 1.0, 2.0 * kPi}});
    while (!queue_.empty() && !std::isnan(best_.distance)) {
      const Entry entry = queue_.top();
      const double over = best_.distance - limit;
      const double fine = std::max(resolution_, over < 0.0 ? -0.02 * over : 0.5 * over);
      if (entry.bound > enough || best_.distance - entry.bound <= fine) {
        if (entry.bound > limit) return {entry.bound, best_.place};
        break;
      }
      queue_.pop();
      halve(entry.cell);
    }
    return best_;
  }

 private:
  struct Entry {
    double bound;
    FrustumCell cell;
    bool operator<(const Entry& other) const { return bound > other.bound; }
  };

  double radius_at(double height) const {
    const double share = (height - section_.from) / (section_.to - section_.from);
    return section_.radius_from + share * (section_.radius_to - section_.radius_from);
  }

  /// Radius of a ball around the cell's middle that holds the cell.
  double size(const FrustumCell& c) const {
    const double r = std::max(radius_at(c.low[0]), radius_at(c.high[0])) * c.high[1];
    const double dr =
        0.5 * (c.high[1] - c.low[1]) * std::max(section_.radius_from, section_.radius_to) +
        0.5 * std::abs(radius_at(c.high[0]) - radius_at(c.low[0]));
    const double round = std::min(0.5 * (c.high[2] - c.low[2]), 2.0) * r;
    return std::hypot(0.5 * (c.high[0] - c.low[0]), std::min(dr + round, 2.0 * r));
  }

  void push(const FrustumCell& c) {
    const double height = 0.5 * (c.low[0] + c.high[0]), azimuth = 0.5 * (c.low[2] + c.high[2]);
    const double r = 0.5 * (c.low[1] + c.high[1]) * radius_at(height);
    const Vec3 place =
        pose_.tip + height * pose_.axis + r * (std::cos(azimuth) * x_ + std::sin(azimuth) * y_);
    const double d = distance_(place);
    if (d < best_.distance || std::isnan(d)) best_ = {d, place};
    queue_.push({d - size(c), c});
  }

  /// Halves a cell where it is longest.
  void halve(const FrustumCell& cell) {
    const double r = std::max(radius_at(cell.low[0]), radius_at(cell.high[0]));
    const double length[3] = {cell.high[0] - cell.low[0], (cell.high[1] - cell.low[1]) * r,
                              (cell.high[2] - cell.low[2]) * r * cell.high[1]};
    const auto axis = std::max_element(length, length + 3) - length;
    const double middle = 0.5 * (cell.low[axis] + cell.high[axis]);
    FrustumCell lower = cell, upper = cell;
    lower.high[axis] = upper.low[axis] = middle;
    push(lower);
    push(upper);
  }

  const ToolSection& section_;
  const PartDistance& distance_;
  double resolution_;
  ToolPose pose_;
  Vec3 x_, y_;
  Nearest best_;
  std::priority_queue<Entry> queue_;
};

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

  void section(std::int64_t number, const Swing& swing, const ToolSection& piece) {
    const double reach = std::hypot(piece.to, std::max(piece.radius_from, piece.radius_to));
    const double allowed = piece.part == ToolPart::Flute ? options_.tolerance : -options_.clearance;
    if (part_.section) {
      walk(number, swing, piece.part, reach, allowed,
           [&](const ToolPose& pose, double, double enough) {
             return part_.section(piece, pose, enough);
           });
      return;
    }
    FrustumSearch search(piece, part_.distance, 0.5 * options_.resolution);
    walk(number, swing, piece.part, reach, allowed,
         [&](const ToolPose& pose, double limit, double enough) {
           return search.find(pose, limit, enough);
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
    checker.ball(number, swing);
    for (const ToolSection& piece : sections) checker.section(number, swing, piece);
  }
}

}  // namespace

const char* name(ToolPart part) {
  switch (part) {
    case ToolPart::Ball:
      return "ball";
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

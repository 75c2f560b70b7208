// Finding tooth passes; see tooth_pass.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/marks/tooth_pass.h"

#include "patchmill/geometry/stop.h"
#include "patchmill/marks/base_lookup.h"

#include <algorithm>
#include <cmath>

namespace patchmill::marks {
namespace {

constexpr double kSample = 0.1;      // [rad], along a pass when looking for where it cuts
constexpr double kWidestHalf = 1.2;  // [rad], half of the widest pass; < pi/2 for the kernel
// [rad], of adjoining passes: no cell falls between them by rounding, one that is cut twice does no
// harm
constexpr double kOverlap = 1e-4;
constexpr double kTurn = 2.0 * kPi;

/// Depth of the edge below the ball centre along -n, where it is deepest. The edge goes from the
/// tip to the equator in the half-plane of `direction`.
double edge_depth(double radius, const Vec3& direction, const Vec3& axis, const Vec3& normal) {
  const double out = -direction.dot(normal), down = axis.dot(normal);
  if (out > 0.0 && down > 0.0) return radius * std::hypot(out, down);
  return radius * std::max(out, down);
}

/// Finds the passes of one flute in one run.
class PassFinder {
 public:
  PassFinder(const ToolMotion& motion, const Cutter& cutter, const SurfaceGrid& grid, double stock,
             std::size_t run, int flute)
      : motion_(motion),
        cutter_(cutter),
        grid_(grid),
        run_(motion.runs[run]),
        run_number_(static_cast<std::int32_t>(run)),
        flute_(flute),
        radius_(edge_radius(cutter, flute)),
        stock_(stock) {
    // over a curved base the height over the tangent plane is only near to that over the base
    if (grid.curved()) stock_ = 1.5 * std::max(stock, 0.0) + 0.02 * radius_;
  }

  std::vector<ToothPass> find() {
    locate();
    const double begin = run_.nodes.front().turned, end = run_.nodes.back().turned;
    for (std::size_t k = 0; k < middles_.size(); ++k) {
      const double m = middles_[k].turned;
      const double from = k == 0 ? begin : 0.5 * (middles_[k - 1].turned + m);
      const double to = k + 1 == middles_.size() ? end : 0.5 * (m + middles_[k + 1].turned);
      examine(middles_[k], std::max(from, begin), std::min(to, end));
    }
    return std::move(passes_);
  }

 private:
  struct Middle {
    double turned;
    std::size_t piece;
  };

  /// Spindle angle at which the flute is over the contact point, for the tool as at this node; of
  /// the angles that differ by whole turns the one nearest to `near`.
  double over_contact(const MotionNode& node, double near) const {
    const Vec3 n = base_under(grid_, node.centre, radius_).normal;
    const double azimuth =
        std::atan2(-n.dot(node.axis.cross(node.housing_x)), -n.dot(node.housing_x));
    const double z = cutter_.ball.radius * (1.0 - n.dot(node.axis));
    const double angle = sign_of(motion_.sense) * (azimuth - kTurn * flute_ / cutter_.ball.flutes) +
                         helix_rate(cutter_) * z;
    return angle - kTurn * std::round((angle - near) / kTurn);
  }

  /// Moments at which the flute is over the contact point: `turned` = over_contact modulo a turn,
  /// the latter taken as linear from node to node; also one turn before and after the run.
  void locate() {
    const auto& nodes = run_.nodes;
    double before = over_contact(nodes.front(), 0.0);
    add(nodes.front().turned - kTurn, nodes.front().turned, before, before, 0);
    for (std::size_t j = 0; j + 1 < nodes.size(); ++j) {
      const double after = over_contact(nodes[j + 1], before);
      add(nodes[j].turned, nodes[j + 1].turned, before, after, j);
      before = after;
    }
    add(nodes.back().turned, nodes.back().turned + kTurn, before, before, nodes.size() - 2);
    std::sort(middles_.begin(), middles_.end(),
              [](const Middle& a, const Middle& b) { return a.turned < b.turned; });
    // a moment at a node may have been found in both of its pieces
    const auto same = [](const Middle& a, const Middle& b) { return b.turned - a.turned < 1e-6; };
    middles_.erase(std::unique(middles_.begin(), middles_.end(), same), middles_.end());
  }

  void add(double from, double to, double over_from, double over_to, std::size_t piece) {
    const double a = (from - over_from) / kTurn, b = (to - over_to) / kTurn;
    for (double k = std::ceil(std::min(a, b)); k < std::max(a, b); k += 1.0)
      middles_.push_back({from + (k - a) / (b - a) * (to - from), piece});
  }

  /// Keeps the part of begin .. end in which the edge reaches below the stock.
  void examine(const Middle& middle, double begin, double end) {
    if (!(begin < end) || clear(middle.piece, begin, end)) return;
    const int samples = 1 + static_cast<int>((end - begin) / kSample);
    const double step = (end - begin) / samples;
    std::size_t piece = piece_at(run_, middle.piece, begin);
    int first = -1, last = -1;
    for (int i = 0; i <= samples; ++i) {
      const double turned = begin + i * step;
      piece = piece_at(run_, piece, turned);
      if (!cutting(node_at(run_, piece, turned))) continue;
      if (first < 0) first = i;
      last = i;
    }
    if (first >= 0)
      split(middle, begin + std::max(first - 1, 0) * step,
            begin + std::min(last + 1, samples) * step);
  }

  double height(const Vec3& centre) const {
    return base_under(grid_, centre, radius_).height(centre);
  }

  /// Least height of the ball centre over the base in begin .. end: it is at a node or at an end,
  /// since the centre moves on straight lines.
  double least_height(std::size_t near, double begin, double end) const {
    std::size_t piece = piece_at(run_, near, begin);
    double least = height(node_at(run_, piece, begin).centre);
    for (; run_.nodes[piece + 1].turned < end && piece + 2 < run_.nodes.size(); ++piece)
      least = std::min(least, height(run_.nodes[piece + 1].centre));
    return std::min(least, height(node_at(run_, piece, end).centre));
  }

  bool clear(std::size_t near, double begin, double end) const {
    return least_height(near, begin, end) - radius_ >= stock_;
  }

  bool cutting(const MotionNode& node) const {
    const BaseUnder base = base_under(grid_, node.centre, radius_);
    const double over = base.height(node.centre);
    if (!(over - radius_ < stock_)) return false;
    // a helical edge is spread over more azimuths than the half-plane at the contact
    if (cutter_.helix.radians() > 0.0) return true;
    const Vec3 out = edge_direction(node, motion_.sense, cutter_, flute_, 0.0);
    return over - edge_depth(radius_, out, node.axis, base.normal) < stock_;
  }

  void split(const Middle& middle, double low, double high) {
    const bool whole = low > middle.turned - kWidestHalf && high < middle.turned + kWidestHalf;
    const int pieces = whole ? 1 : 1 + static_cast<int>((high - low) / (2.0 * kWidestHalf));
    for (int i = 0; i < pieces; ++i) {
      const double from = low + (high - low) * i / pieces;
      const double to = low + (high - low) * (i + 1) / pieces;
      keep(whole ? middle.turned : 0.5 * (from + to), from, to, middle.piece);
    }
  }

  void keep(double middle, double from, double to, std::size_t near) {
    ToothPass pass;
    pass.middle = middle;
    pass.low = static_cast<float>(from - middle - kOverlap);
    pass.high = static_cast<float>(to - middle + kOverlap);
    pass.run = run_number_;
    pass.node = static_cast<std::int32_t>(piece_at(run_, near, middle));
    pass.flute = flute_;
    const double drop = least_height(near, from, to) - stock_;
    // the square root loses nothing to rounding: a touch more than the exact reach
    pass.reach =
        static_cast<float>(std::sqrt(std::max(radius_ * radius_ - drop * drop, 0.0)) + 1e-5);
    if (drop <= 0.0) pass.reach = static_cast<float>(radius_ + 1e-5);
    box(pass, from, to);
    if (on_grid(pass)) passes_.push_back(pass);
  }

  /// Box of the cells in reach, in plane coordinates.
  void box(ToothPass& pass, double from, double to) const {
    Vec2 least = Vec2::Constant(1e300), most = -least;
    const auto take = [&](const Vec3& centre) {
      const Vec2 p = project(grid_.plane, base_under(grid_, centre, radius_).foot);
      least = least.cwiseMin(p);
      most = most.cwiseMax(p);
    };
    std::size_t piece = piece_at(run_, static_cast<std::size_t>(pass.node), from);
    take(node_at(run_, piece, from).centre);
    for (; run_.nodes[piece + 1].turned < to && piece + 2 < run_.nodes.size(); ++piece)
      take(run_.nodes[piece + 1].centre);
    take(node_at(run_, piece, to).centre);
    const double slant = std::abs(grid_.plane.direction.dot(plane_normal(grid_.plane)));
    const double reach = pass.reach * (grid_.curved() ? 1.25 / slant : 1.0);
    for (int k = 0; k < 2; ++k) {
      pass.least[k] = static_cast<float>(least[k] - reach - 1e-5 * std::abs(least[k]));
      pass.most[k] = static_cast<float>(most[k] + reach + 1e-5 * std::abs(most[k]));
    }
  }

  bool on_grid(const ToothPass& pass) const {
    const Vec2 last = grid_.plane_point(grid_.columns - 1, grid_.rows - 1);
    return pass.least[0] <= last.x() && pass.least[1] <= last.y() &&
           pass.most[0] >= grid_.first.x() && pass.most[1] >= grid_.first.y();
  }

  const ToolMotion& motion_;
  const Cutter& cutter_;
  const SurfaceGrid& grid_;
  const MotionRun& run_;
  std::int32_t run_number_;
  std::int32_t flute_;
  double radius_, stock_;
  std::vector<Middle> middles_;
  std::vector<ToothPass> passes_;
};

}  // namespace

double edge_radius(const Cutter& cutter, int flute) {
  return cutter.ball.radius +
         (cutter.runout.empty() ? 0.0 : cutter.runout[static_cast<std::size_t>(flute)]);
}

double helix_rate(const Cutter& cutter) {
  return std::tan(cutter.helix.radians()) / cutter.ball.radius;
}

Vec3 edge_direction(const MotionNode& node, SpindleSense sense, const Cutter& cutter, int flute,
                    double z) {
  const double azimuth =
      sign_of(sense) * (node.turned - helix_rate(cutter) * z) + kTurn * flute / cutter.ball.flutes;
  return std::cos(azimuth) * node.housing_x + std::sin(azimuth) * node.axis.cross(node.housing_x);
}

MotionNode node_at(const MotionRun& run, std::size_t piece, double turned) {
  const MotionNode &a = run.nodes[piece], &b = run.nodes[piece + 1];
  const double share = (turned - a.turned) / (b.turned - a.turned);
  return {turned, a.centre + share * (b.centre - a.centre), a.axis + share * (b.axis - a.axis),
          a.housing_x + share * (b.housing_x - a.housing_x)};
}

std::size_t piece_at(const MotionRun& run, std::size_t near, double turned) {
  const auto& nodes = run.nodes;
  std::size_t piece = std::min(near, nodes.size() - 2);
  while (piece > 0 && nodes[piece].turned > turned) --piece;
  while (piece + 2 < nodes.size() && nodes[piece + 1].turned <= turned) ++piece;
  return piece;
}

std::vector<ToothPass> find_passes(const ToolMotion& motion, const Cutter& cutter,
                                   const SurfaceGrid& grid, double stock) {
  require_valid(cutter);
  require_valid(grid);
  const auto flutes = static_cast<std::size_t>(cutter.ball.flutes);
  std::vector<std::vector<ToothPass>> found(motion.runs.size() * flutes);
  patchmill::parallel_for(std::size_t{0}, found.size(), [&](std::size_t k) {
    found[k] =
        PassFinder(motion, cutter, grid, stock, k / flutes, static_cast<int>(k % flutes)).find();
  });
  std::size_t count = 0;
  for (const auto& passes : found) count += passes.size();
  std::vector<ToothPass> all;
  all.reserve(count);
  for (auto& passes : found) {
    all.insert(all.end(), passes.begin(), passes.end());
    std::vector<ToothPass>().swap(passes);
  }
  return all;
}

}  // namespace patchmill::marks

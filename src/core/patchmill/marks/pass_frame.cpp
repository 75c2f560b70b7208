// Preparing a tooth pass for the kernel; see pass_frame.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/marks/pass_frame.h"

#include "patchmill/marks/base_lookup.h"

#include <algorithm>
#include <cmath>

namespace patchmill::marks {
namespace {

constexpr double kSlight = 1e-7;  // [mm/rad, 1/rad]; changes of velocity below this are none

/// Ball centre and housing directions at a node, in the frame of the pass. `b` already has the sign
/// of the spindle, so that the edge moves from a towards b.
struct State {
  Vec3 c, a, b, t;
};
State operator-(const State& p, const State& q) {
  return {p.c - q.c, p.a - q.a, p.b - q.b, p.t - q.t};
}
State operator*(double k, const State& p) {
  return {k * p.c, k * p.a, k * p.b, k * p.t};
}
bool slight(const State& p) {
  return p.c.norm() < kSlight && p.a.norm() < kSlight && p.b.norm() < kSlight &&
         p.t.norm() < kSlight;
}

void copy(const Vec3& from, float to[3]) {
  for (int k = 0; k < 3; ++k) to[k] = static_cast<float>(from[k]);
}

class Preparer {
 public:
  Preparer(const ToothPass& pass, const ToolMotion& motion, const Cutter& cutter,
           const SurfaceGrid& grid)
      : pass_(pass),
        run_(motion.runs[static_cast<std::size_t>(pass.run)]),
        cutter_(cutter),
        sense_(motion.sense),
        piece_(static_cast<std::size_t>(pass.node)) {
    const MotionNode middle = node_at(run_, piece_, pass.middle);
    const BaseUnder base = base_under(grid, middle.centre, edge_radius(cutter, pass.flute));
    if (!grid.curved())
      to_frame_ << grid.plane.x_axis.transpose(), grid.plane.y_axis.transpose(),
          base.normal.transpose();
    else
      to_frame_.setIdentity();
    normal_ = to_frame_ * base.normal;
    contact_height_ = cutter.ball.radius * (1.0 - base.normal.dot(middle.axis));
    azimuth_ = sign_of(sense_) * (pass.middle - helix_rate(cutter) * contact_height_) +
               2.0 * kPi * pass.flute / cutter.ball.flutes;
    centre_ = middle.centre;
    middle_ = state(middle);
    slope_ = slope(piece_);
  }

  void fill(PassFrame& frame) const {
    const double radius = edge_radius(cutter_, pass_.flute);
    frame.radius = static_cast<float>(radius);
    frame.low = pass_.low;
    frame.high = pass_.high;
    copy(slope_.c, frame.velocity);
    copy(middle_.a, frame.a);
    copy(middle_.b, frame.b);
    copy(middle_.t, frame.t);
    copy(slope_.a, frame.a_rate);
    copy(slope_.b, frame.b_rate);
    copy(slope_.t, frame.t_rate);
    frame.turning = slope_.a.norm() + slope_.b.norm() + slope_.t.norm() > kSlight;
    frame.helix_rate = static_cast<float>(helix_rate(cutter_));
    frame.helix_height = static_cast<float>(contact_height_ - cutter_.ball.radius);
    // the point of the ball goes round the axis within distance / feed: fast where the tip is in reach
    const double aside = radius * normal_.cross(middle_.t).norm();
    frame.search_step = aside < pass_.reach ? 0.02f : 0.12f;
    fill_guess(frame, radius);
    fill_kinks(frame);
  }

  void fill(const SurfaceGrid& grid, PassWay& way) const {
    way.centre = centre_;
    if (!grid.curved()) way.centre = to_frame_ * (centre_ - grid.plane.origin);
    way.corners.clear();
    const double from = pass_.middle + pass_.low, to = pass_.middle + pass_.high;
    std::size_t piece = piece_at(run_, piece_, from);
    way.corners.push_back(offset(piece, from));
    for (; run_.nodes[piece + 1].turned < to && piece + 2 < run_.nodes.size(); ++piece)
      way.corners.push_back(to_frame_ * (run_.nodes[piece + 1].centre - centre_));
    way.corners.push_back(offset(piece, to));
    double fastest = 0.0;
    for (std::size_t k = piece_at(run_, piece_, from); k <= piece; ++k)
      fastest = std::max(fastest, slope(k).c.norm());
    way.tip = -edge_radius(cutter_, pass_.flute) * middle_.t;
    // the margin of near_axis in the kernel, and one for a tool axis that turns
    way.near_tip = 1.35 * fastest + 0.05 * way.tip.norm() * (pass_.high - pass_.low) *
                                        std::min(10.0 * slope_.t.norm(), 1.0);
  }

 private:
  Vec3 offset(std::size_t piece, double turned) const {
    return to_frame_ * (node_at(run_, piece, turned).centre - centre_);
  }

  State state(const MotionNode& node) const {
    const Vec3 y = node.axis.cross(node.housing_x);
    const Vec3 a = std::cos(azimuth_) * node.housing_x + std::sin(azimuth_) * y;
    const Vec3 b = std::cos(azimuth_) * y - std::sin(azimuth_) * node.housing_x;
    return {to_frame_ * (node.centre - centre_), to_frame_ * a, sign_of(sense_) * (to_frame_ * b),
            to_frame_ * node.axis};
  }

  State slope(std::size_t piece) const {
    const MotionNode &from = run_.nodes[piece], &to = run_.nodes[piece + 1];
    return 1.0 / (to.turned - from.turned) * (state(to) - state(from));
  }

  /// Linear solution of r = 0 about the contact point; see flute_kernel.h.
  void fill_guess(PassFrame& frame, double radius) const {
    const Vec3 d = -radius * normal_;
    const double across = d.dot(middle_.a), ahead = d.dot(middle_.b);
    const double square = across * across + ahead * ahead;
    frame.guess = 0.0f;
    copy(Vec3::Zero(), frame.guess_gradient);
    if (square < 1e-4 * radius * radius || across <= 0.0) return;
    const auto flat = [&](const Vec3& v) { return Vec3(v - v.dot(normal_) * normal_); };
    // how the point under a cell moves over the ball as the cell moves in the tangent plane
    const Vec3 turn = (across * flat(middle_.b) - ahead * flat(middle_.a)) / square +
                      helix_rate(cutter_) * flat(middle_.t);
    const double r0 =
        -std::atan2(ahead, across) - helix_rate(cutter_) * (d.dot(middle_.t) - frame.helix_height);
    const double rate = std::max(1.0 + turn.dot(slope_.c), 0.2);
    frame.guess = static_cast<float>(-r0 / rate);
    copy(turn / rate, frame.guess_gradient);
  }

  void fill_kinks(PassFrame& frame) const {
    frame.kinks.clear();
    State before = slope_;
    for (std::size_t j = piece_ + 1; j + 1 < run_.nodes.size(); ++j) {
      if (run_.nodes[j].turned >= pass_.middle + pass_.high) break;
      const State after = slope(j);
      add_kink(j, after - before, frame);
      before = after;
    }
    State after = slope_;
    for (std::size_t j = piece_; j > 0; --j) {
      if (run_.nodes[j].turned <= pass_.middle + pass_.low) break;
      before = slope(j - 1);
      add_kink(j, before - after, frame);
      after = before;
    }
  }

  void add_kink(std::size_t node, const State& change, PassFrame& frame) const {
    if (slight(change)) return;
    PassKink kink;
    kink.at = static_cast<float>(run_.nodes[node].turned - pass_.middle);
    // a node at the very middle bounds the piece from below
    if (node <= piece_) kink.at = std::min(kink.at, 0.0f);
    copy(change.c, kink.velocity);
    copy(change.a, kink.a);
    copy(change.b, kink.b);
    copy(change.t, kink.t);
    if (change.a.norm() + change.b.norm() + change.t.norm() > kSlight) frame.turning = true;
    frame.kinks.push_back(kink);
  }

  const ToothPass& pass_;
  const MotionRun& run_;
  const Cutter& cutter_;
  SpindleSense sense_;
  std::size_t piece_;
  Eigen::Matrix3d to_frame_;
  Vec3 normal_, centre_;
  double contact_height_ = 0.0, azimuth_ = 0.0;
  State middle_, slope_;
};

}  // namespace

void prepare(const ToothPass& pass, const ToolMotion& motion, const Cutter& cutter,
             const SurfaceGrid& grid, PassFrame& frame, PassWay& way) {
  const Preparer preparer(pass, motion, cutter, grid);
  preparer.fill(frame);
  preparer.fill(grid, way);
  frame.centre_height = static_cast<float>(way.centre.z());
}

}  // namespace patchmill::marks

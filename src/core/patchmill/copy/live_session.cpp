// Lines of a live session, one at a time; see live_session.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/copy/live_session.h"

#include "patchmill/copy/scanning.h"
#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cmath>

namespace patchmill::copy {
namespace {

constexpr double kSame = 1e-9;  // [mm]

void check(const LiveConditions& c) {
  require_positive("radial depth of cut", c.radial_depth, "mm");
  require_positive("axial depth of cut", c.axial_depth, "mm");
  require_positive("lowest feed", c.feed.low, "mm/s");
  require_in_range("highest feed", c.feed.high, c.feed.low, 1e6, "mm/s");
}

double bottom(const CopyOptions& o) {
  return o.stock.lo.z() + o.tool.radius;
}
double safe(const CopyOptions& o) {
  return o.stock.hi.z() + o.clearance + o.tool.radius;
}

// What of a profile, in the sense of cutting, lies beyond x; its first point is at x.
std::vector<Vec2> beyond(const std::vector<Vec2>& profile, double x, bool backwards) {
  const double sense = backwards ? -1.0 : 1.0;
  std::vector<Vec2> rest;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const Vec2& p = profile[i];
    if (sense * (p.x() - x) <= kSame) continue;
    if (rest.empty() && i > 0) {
      const Vec2& q = profile[i - 1];
      const double t = std::clamp((x - q.x()) / (p.x() - q.x()), 0.0, 1.0);
      rest.emplace_back(x, q.y() + t * (p.y() - q.y()));
    }
    rest.push_back(p);
  }
  return rest;
}

}  // namespace

LiveSession::LiveSession(const mesh::TriangleBvh& part, const voxel::VoxelGrid& grid,
                         const CopyOptions& options, const dcm::FeedLimits& feed,
                         const dcm::DcmOptions& dcm, dcm::FeedFactors factors)
    : part_(part), grid_(grid), options_(options), dcm_(dcm), factors_(std::move(factors)) {
  if (options.mode != CopyMode::Scanning)
    throw InputError("Mode", "not Scanning", "a live session cuts scanning lines.");
  require_ball(options.tool, "a live session works");
  conditions_ = {options.radial_depth, options.axial_depth, feed};
  check(conditions_);
  require_valid(options);
  feed_ = field_of(feed);
  for (const double factor : factors_.factor) slowest_ = std::min(slowest_, factor);
  at_ = Vec3(options.stock.lo.x(), options.stock.lo.y(), safe(options));
  height_[-std::numeric_limits<double>::infinity()] = options.stock.hi.z() + options.tool.radius;
}

dcm::FeedField LiveSession::field_of(const dcm::FeedLimits& limits) const {
  dcm::FeedField field = dcm::steady_feed(grid_, limits);
  if (!factors_.material.empty()) dcm::scale_feed(field, factors_.material, factors_.factor);
  return field;
}

double LiveSession::material(double y_from, double y_to) const {
  double most = std::prev(height_.upper_bound(y_from))->second;
  for (auto it = height_.upper_bound(y_from); it != height_.end() && it->first < y_to; ++it)
    most = std::max(most, it->second);
  return most;
}

void LiveSession::set_material(double y_from, double y_to, double height) {
  const double after = std::prev(height_.upper_bound(y_to))->second;
  height_.erase(height_.lower_bound(y_from), height_.upper_bound(y_to));
  height_[y_from] = height;
  height_[y_to] = after;
}

// The steps of the present line along a profile. `go_on`: the tool is at its first point already.
void LiveSession::plan_runs(const std::vector<Vec2>& profile, bool go_on) {
  for (const auto& run : layer_of(profile, above_, level_)) {
    const Vec3 first(run.front().x(), y_, run.front().y());
    const Vec3 last = steps_.empty() ? at_ : steps_.back().centre;
    const bool here = go_on && std::abs(first.x() - at_.x()) < kSame && steps_.empty();
    if (here) {
      if ((first - at_).norm() > kSame) steps_.push_back({first, MoveKind::Cut});
    } else if ((first - last).norm() > kSame) {
      const double up = safe(options_);
      if (last.z() < up) steps_.push_back({{last.x(), last.y(), up}, MoveKind::Rapid});
      steps_.push_back({{first.x(), first.y(), up}, MoveKind::Rapid});
      steps_.push_back({first, MoveKind::Link});
    }
    for (std::size_t i = 1; i < run.size(); ++i)
      steps_.push_back({{run[i].x(), y_, run[i].y()}, MoveKind::Cut});
  }
}

// Goes on to the next line that has something to cut; false when there is none.
bool LiveSession::plan_line() {
  const CopyOptions& o = options_;
  const double lo = o.stock.lo.y() - o.overlap, hi = o.stock.hi.y() + o.overlap;
  while (material(lo, hi) > bottom(o) + kSame || !first_in_layer_) {
    if (first_in_layer_) {
      y_before_ = y_ = lo;
    } else if (y_ >= hi - kSame) {
      first_in_layer_ = true;
      continue;
    } else {
      y_before_ = y_;
      y_ = std::min(hi, y_ + conditions_.radial_depth);
    }
    first_in_layer_ = false;
    backwards_ = !backwards_;
    above_ = material(y_before_, y_);
    if (above_ <= bottom(o) + kSame) continue;
    level_ = std::max(bottom(o), above_ - conditions_.axial_depth);
    const double x0 = o.stock.lo.x() - o.tool.radius, x1 = o.stock.hi.x() + o.tool.radius;
    profile_ = probe_profile(part_, y_, x0, x1, bottom(o), o);
    if (backwards_) std::reverse(profile_.begin(), profile_.end());
    set_material(y_before_, y_ >= hi ? hi + 1.0 : y_, level_);
    plan_runs(profile_, false);
    if (!steps_.empty()) return true;
  }
  return false;
}

// The rest of the present line with the axial depth of now; its material counts as cut to the higher level.
void LiveSession::replan_line() {
  const bool down = !steps_.empty() && steps_.front().kind == MoveKind::Cut;
  if (!down) {
    // not in a cut: the line begins at the next place where it would have
    const auto next = std::find_if(steps_.begin(), steps_.end(),
                                   [](const Step& s) { return s.kind == MoveKind::Link; });
    if (next == steps_.end()) return;
    const double x = next->centre.x();
    const double sense = backwards_ ? -1.0 : 1.0;
    profile_ = beyond(profile_, x - sense * 1e-6, backwards_);
  } else {
    profile_ = beyond(profile_, at_.x(), backwards_);
  }
  const double old = level_;
  level_ = std::max(bottom(options_), above_ - conditions_.axial_depth);
  steps_.clear();
  plan_runs(profile_, down);
  const double hi = options_.stock.hi.y() + options_.overlap;
  set_material(y_before_, y_ >= hi ? hi + 1.0 : y_, std::max(old, level_));
}

void LiveSession::change(const LiveConditions& conditions) {
  check(conditions);
  const bool feed =
      conditions.feed.low != conditions_.feed.low || conditions.feed.high != conditions_.feed.high;
  const bool depth = conditions.axial_depth != conditions_.axial_depth;
  if (feed) feed_ = field_of(conditions.feed);
  conditions_ = conditions;
  if (depth && !steps_.empty()) replan_line();
}

ToolPath LiveSession::next(double seconds) {
  require_positive("batch time", seconds, "s");
  const Vec3 down(0, 0, options_.tool.radius);
  ToolPath batch;
  batch.tool = options_.tool;
  batch.spindle = options_.spindle;
  batch.start.tip = at_ - down;
  // no move is slower than V_Lo times the least factor: so much length takes no more than the time
  double left = seconds * conditions_.feed.low * slowest_;
  while (left > kSame && !done_) {
    if (steps_.empty() && !plan_line()) {
      done_ = true;
      if (at_.z() >= safe(options_)) break;
      steps_.push_back({{at_.x(), at_.y(), safe(options_)}, MoveKind::Rapid});
    }
    Step step = steps_.front();
    const double length = (step.centre - at_).norm();
    if (step.kind != MoveKind::Rapid && length > left)
      step.centre = at_ + left / length * (step.centre - at_);
    else
      steps_.pop_front();
    Move move;
    move.kind = step.kind;
    move.end.tip = step.centre - down;
    if (step.kind != MoveKind::Rapid) {
      const double way = (step.centre - at_).norm();
      move.turns = options_.spindle.speed * way / conditions_.feed.low;
      left -= way;
    }
    batch.moves.push_back(move);
    at_ = step.centre;
  }
  return dcm::apply_dcm(batch, grid_, &feed_, nullptr, dcm_);
}

}  // namespace patchmill::copy

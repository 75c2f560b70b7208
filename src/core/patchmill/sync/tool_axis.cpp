// Tool-axis modes; see tool_axis.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/tool_axis.h"

#include "patchmill/geometry/require.h"
#include "patchmill/geometry/stop.h"
#include "patchmill/sync/contact_azimuth.h"

#include <cmath>

#include <fmt/format.h>

namespace patchmill::sync {
namespace {

constexpr int kSweeps = 200;
constexpr double kSettled = 1e-9;  // rad
constexpr double kKeeping = 0.5;  // share of the rows' tolerance spent on turning less between them
constexpr int kHalvings = 40;     // of a way on the sphere
constexpr double kCorner = 0.5;   // rad: rows are straighter than this
constexpr double kGap = 2.5;      // a step longer than this times the shortest is a gap

// `from` turned towards `to` by `angle`; towards `instead` if the two are parallel.
Vec3 leaned(const Vec3& from, const Vec3& to, const Vec3& instead, double angle) {
  Vec3 side = to - from * from.dot(to);
  if (side.norm() < 1e-9) side = instead - from * from.dot(instead);
  if (side.norm() < 1e-9) side = any_normal_to(from);
  return (std::cos(angle) * from + std::sin(angle) * side.normalized()).normalized();
}

Vec3 drawn_within(const Vec3& axis, const Vec3& middle, double most) {
  return Angle::between(axis, middle).radians() <= most ? axis
                                                        : leaned(middle, axis, Vec3::UnitX(), most);
}

// What runs through one patch: the numbers of its dimples to cut, in milling order.
std::vector<std::vector<std::size_t>> runs(const patch::Dimples& dimples) {
  std::vector<std::vector<std::size_t>> out;
  std::int32_t patch = -1;
  for (std::size_t k = 0; k < dimples.size(); ++k) {
    if (dimples[k].state != patch::DimpleState::Cut) continue;
    if (out.empty() || dimples[k].patch != patch) out.emplace_back();
    patch = dimples[k].patch;
    out.back().push_back(k);
  }
  return out;
}

class Axes {
 public:
  Axes(const patch::Dimples& dimples, const ToolAxisRule& rule)
      : dimples_(dimples),
        rule_(rule),
        axis_(unit_along("FixedAxis", rule.axis)),
        axes_(dimples.size(), Vec3::UnitZ()) {}

  std::vector<Vec3> make() {
    for (const auto& run : runs(dimples_)) {
      for (std::size_t i = 0; i < run.size(); ++i) axes_[run[i]] = kept(run[i], asked(run, i));
      if (rule_.smoothing.radians() > 0.0) smooth(run);
    }
    return std::move(axes_);
  }

 private:
  const Vec3& normal(std::size_t k) const { return dimples_[k].surface.normal; }
  Vec3 feed(const std::vector<std::size_t>& run, std::size_t i) const {
    if (rule_.towards.norm() > 0.0) return rule_.towards;
    const std::size_t a = i > 0 ? i - 1 : 0, b = std::min(i + 1, run.size() - 1);
    return dimples_[run[b]].surface.position - dimples_[run[a]].surface.position;
  }
  Vec3 asked(const std::vector<std::size_t>& run, std::size_t i) const {
    const Vec3& n = normal(run[i]);
    if (rule_.mode == ToolAxisMode::Field) return rule_.field[run[i]].normalized();
    if (rule_.mode != ToolAxisMode::Normal) return axis_;
    Vec3 f = feed(run, i);
    f -= n * n.dot(f);
    f = f.norm() > 1e-9 ? Vec3(f.normalized()) : any_normal_to(n);
    return (n + std::tan(rule_.lead.radians()) * f + std::tan(rule_.tilt.radians()) * n.cross(f))
        .normalized();
  }
  /// Within the widest angle from Z, and away from the normal; the latter counts more.
  Vec3 kept(std::size_t k, const Vec3& axis) const {
    const Vec3 t = drawn_within(axis, Vec3::UnitZ(), rule_.widest.radians());
    if (rule_.mode == ToolAxisMode::Fixed || rule_.mode == ToolAxisMode::Normal) return t;
    const double least = rule_.least_lead.radians();
    if (Angle::between(t, normal(k)).radians() >= least) return t;
    const Vec3 instead = rule_.towards.norm() > 0.0 ? rule_.towards : Vec3(Vec3::UnitX());
    return leaned(normal(k), t, instead, least);
  }
  /// Each axis goes to the middle of its neighbours' as far as the tolerance lets it, until none moves.
  void smooth(const std::vector<std::size_t>& run) {
    std::vector<Vec3> wanted, next(run.size());
    for (const std::size_t k : run) wanted.push_back(axes_[k]);
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      double change = 0.0;
      for (std::size_t i = 0; i < run.size(); ++i) {
        stop_point();
        const Vec3& a = axes_[run[i > 0 ? i - 1 : i]];
        const Vec3& b = axes_[run[i + 1 < run.size() ? i + 1 : i]];
        const Vec3 mean = (a + 2.0 * axes_[run[i]] + b).normalized();
        next[i] = kept(run[i], drawn_within(mean, wanted[i], rule_.smoothing.radians()));
        change = std::max(change, (next[i] - axes_[run[i]]).norm());
      }
      for (std::size_t i = 0; i < run.size(); ++i) axes_[run[i]] = next[i];
      if (change < kSettled) return;
    }
  }

  const patch::Dimples& dimples_;
  const ToolAxisRule& rule_;
  Vec3 axis_;
  std::vector<Vec3> axes_;
};

void require_valid(const patch::Dimples& dimples, const ToolAxisRule& rule) {
  require_in_range("Lead", rule.lead.degrees(), -80.0, 80.0, "degrees");
  require_in_range("Tilt", rule.tilt.degrees(), -80.0, 80.0, "degrees");
  require_in_range("MinimumLead", rule.least_lead.degrees(), 0.0, 80.0, "degrees");
  require_in_range("AxisSmoothing", rule.smoothing.degrees(), 0.0, 45.0, "degrees");
  require_in_range("WidestTilt", rule.widest.degrees(), 0.0, 180.0, "degrees");
  unit_along("FixedAxis", rule.axis);
  require_finite("LeanTowards", rule.towards, "");
  if (rule.mode != ToolAxisMode::Field) return;
  if (rule.field.size() != dimples.size())
    throw InputError("PostureField", fmt::format("{} axes", rule.field.size()),
                     fmt::format("give one for each of the {} dimples.", dimples.size()));
  for (std::size_t k = 0; k < dimples.size(); ++k)
    if (dimples[k].state == patch::DimpleState::Cut &&
        !(rule.field[k].norm() > 1e-9 && rule.field[k].norm() < 1e9))
      throw InputError(
          "PostureField", fmt::format("no direction at dimple {}", k),
          "give a finite vector other than zero; a voxel model has none inside the part.");
}

}  // namespace

std::vector<Vec3> tool_axes(const patch::Dimples& dimples, const ToolAxisRule& rule) {
  require_valid(dimples, rule);
  return Axes(dimples, rule).make();
}

void require_axes(const patch::Dimples& dimples, const std::vector<Vec3>& axes) {
  require_one_each("ToolAxis", axes.size(), dimples.size(), "dimples");
  for (std::size_t k = 0; k < dimples.size(); ++k)
    if (dimples[k].state == patch::DimpleState::Cut) unit_along("ToolAxis", axes[k]);
}

std::vector<Vec3> axes_by_row(const patch::Dimples& dimples, const std::vector<Vec3>& axes,
                              Angle tolerance) {
  require_axes(dimples, axes);
  require_in_range("RowTolerance", tolerance.degrees(), 0.0, 45.0, "degrees");
  std::vector<Vec3> out(axes.size(), Vec3::UnitZ());
  Vec3 before = Vec3::Zero();  // of the row before; none yet
  for (const auto& run : runs(dimples)) {
    const auto at = [&](std::size_t i) { return dimples[run[i]].surface.position; };
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < run.size(); ++i)
      shortest = std::min(shortest, (at(i) - at(i - 1)).norm());
    const auto turns_off = [&](std::size_t i) {  // a new row begins at i
      const Vec3 step = at(i) - at(i - 1);
      if (step.norm() > kGap * shortest) return true;
      return i > 1 && Angle::between(at(i - 1) - at(i - 2), step).radians() > kCorner;
    };
    const auto off = [&](std::size_t first, std::size_t last, const Vec3& axis) {
      double most = 0.0;
      for (std::size_t i = first; i <= last; ++i)
        most = std::max(most, Angle::between(axes[run[i]], axis).radians());
      return most;
    };
    // from the mean towards the axis of the row before, as far as kKeeping lets the dimples be off
    const auto kept = [&](std::size_t first, std::size_t last, const Vec3& mean) {
      const double way = before.norm() > 0.0 ? Angle::between(mean, before).radians() : 0.0;
      if (way == 0.0) return mean;
      const double most = std::max(off(first, last, mean), kKeeping * tolerance.radians());
      if (off(first, last, before) <= most) return before;
      double near = 0.0, far = way;
      for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (near + far);
        (off(first, last, leaned(mean, before, mean, middle)) <= most ? near : far) = middle;
      }
      return leaned(mean, before, mean, near);
    };
    for (std::size_t first = 0; first < run.size();) {
      Vec3 sum = axes[run[first]];
      std::size_t last = first;
      while (last + 1 < run.size() && !turns_off(last + 1)) {
        const Vec3 with = sum + axes[run[last + 1]];
        if (off(first, last + 1, with.normalized()) > tolerance.radians()) break;
        sum = with;
        ++last;
      }
      before = kept(first, last, sum.normalized());
      for (std::size_t i = first; i <= last; ++i) out[run[i]] = before;
      first = last + 1;
    }
  }
  return out;
}

void mark_tool_tip(patch::Dimples& dimples, const std::vector<Vec3>& axes, Angle least_tilt) {
  require_axes(dimples, axes);
  require_in_range("MinimumTilt", least_tilt.degrees(), 1e-6, 89.0, "degrees");
  for (std::size_t k = 0; k < dimples.size(); ++k) {
    if (dimples[k].state != patch::DimpleState::Cut) continue;
    dimples[k].state = state_of_tilt(tilt(dimples[k].surface.normal, axes[k]), least_tilt);
  }
}

}  // namespace patchmill::sync

// Constant feed along the helix, and where its teeth pass; see free_form_path.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/sync/free_form_path.h"

#include "patchmill/geometry/require.h"
#include "patchmill/sync/contact_azimuth.h"
#include "patchmill/sync/path_account.h"
#include "patchmill/sync/planned_dimples.h"

#include <algorithm>
#include <limits>

namespace patchmill::sync {
namespace {

void require_valid(const patch::FreeTexture& texture, const Tool& tool, const Spindle& spindle,
                   const ConstantFeed& rule) {
  require_positive("Feed", rule.feed * 60.0, "mm/min");
  require_turning_tool(tool, spindle);
  require_in_range("Flutes", tool.flutes, 1, 32, "flutes");
  require_in_range("ExtraTurns", rule.phase.extra_turns, 0.0, 0.0, "turns in the free form");
  if (rule.phase.flutes == FluteChoice::Same && tool.flutes > 1)
    throw InputError("SameFlute", "true", "in the free form every flute leaves a mark: allow any.");
  const double f_z = rule.feed / (tool.flutes * spindle.speed);
  if (!(std::abs(f_z / texture.patch.feed_per_tooth - 1.0) < 1e-6))
    throw InputError("FeedPerTooth", fmt::format("{} mm", texture.patch.feed_per_tooth),
                     fmt::format("the feed makes {:.6g} mm a tooth: give the same.", f_z));
  require_heights(rule.safe_height, rule.clearance_height);
}

// Marks of this texture, by number.
void require_of(const patch::FreeTexture& texture, const patch::Dimples& dimples) {
  require_one_each("Dimples", dimples.size(), texture.marks.size() * texture.frames.size(),
                   "marks of the texture");
}

// Tips of a vertical tool over the helix of one patch.
class PatchTips {
 public:
  PatchTips(const patch::FreeTexture& texture, const patch::Dimple& dimple, double radius,
            const Decimals& decimals)
      : path_(texture.path),
        frame_(texture.frames[static_cast<std::size_t>(dimple.patch)]),
        lift_((radius - dimple.depth) * frame_.normal - radius * Vec3::UnitZ()),
        decimals_(decimals) {}

  /// The tip at `s` along the helix, carried on straight beyond its ends.
  Vec3 at(double s) const {
    const patch::HelixSide& side = path_[side_at(s)];
    const Vec2 along = (side.end - side.start).normalized();
    return decimals_.round(frame_.at(side.start + (s - side.at) * along) + lift_);
  }
  /// Lengths of the corners between `from` and `to`.
  template <class Visit>
  void corners_between(double from, double to, double slack, Visit visit) const {
    for (std::size_t k = side_at(from + slack) + 1; k < path_.size(); ++k) {
      if (path_[k].at >= to - slack) return;
      visit(path_[k].at);
    }
  }

 private:
  std::size_t side_at(double s) const {
    const auto after = std::upper_bound(
        path_.begin() + 1, path_.end(), s,
        [](double length, const patch::HelixSide& side) { return length < side.at; });
    return static_cast<std::size_t>(after - path_.begin() - 1);
  }
  const std::vector<patch::HelixSide>& path_;
  const patch::FreeFrame& frame_;
  Vec3 lift_;
  const Decimals& decimals_;
};

}  // namespace

ToolPath free_form_path(const patch::FreeTexture& texture, const patch::Dimples& dimples,
                        const Tool& tool, const Spindle& spindle, const ConstantFeed& rule,
                        const Decimals& decimals) {
  require_valid(texture, tool, spindle, rule);
  require_of(texture, dimples);
  const double turns_per_mm = spindle.speed / rule.feed, tooth = 1.0 / tool.flutes;
  const double f_z = texture.patch.feed_per_tooth, slack = 1e-12 * f_z;
  ToolPath path{tool, spindle, {}, {}};
  PathAccount build(path, turns_per_mm, rule.safe_height);
  const patch::Dimple* before = nullptr;
  double slip = 0.0;  // of the last mark along the helix, from where it was planned
  for (const patch::Dimple& dimple : dimples) {
    if (dimple.state != patch::DimpleState::Cut) continue;
    const auto number = static_cast<std::int32_t>(&dimple - dimples.data());
    const PatchTips tips(texture, dimple, tool.radius, decimals);
    const double s = dimple.lattice[0] * f_z;
    const bool next = before && dimple.patch == before->patch && &dimple == before + 1;
    if (next) {
      const double wanted = build.length_for(tooth);
      build.require_turns(tooth);
      const double from = s - f_z + slip;
      slip += wanted - f_z;
      const Vec3 mark = tips.at(s + slip);
      tips.corners_between(from, s + slip, slack, [&](double at) {
        const Vec3 corner = tips.at(at);  // on the decimals it may be the mark before or after it
        if (corner != build.at() && corner != mark) build.timed(corner, MoveKind::Cut);
      });
      build.timed(mark, MoveKind::Cut, number);
    } else if (before) {
      slip = 0.0;
      const double turns =
          spindle_advance(contact_azimuth(before->surface.normal),
                          contact_azimuth(dimple.surface.normal), rule.phase, tool, spindle)
              .turns();
      build.link(tips.at(s), number, turns, tooth, decimals);
    } else {
      const Vec3 first = tips.at(s);
      if (first.z() > rule.safe_height)
        throw InputError("SafeHeight", fmt::format("{} mm", rule.safe_height),
                         fmt::format("the tool tip is at Z {:.3f} mm on mark {}: give a greater "
                                     "safe height.",
                                     first.z(), number));
      build.begin(first, number, rule.clearance_height, decimals);
    }
    before = &dimple;
  }
  if (!before)
    throw InputError("Dimples", "0",
                     "every mark was left out: see the counts by reason, and change the faces, the "
                     "limits or the tool axis.");
  build.end(rule.clearance_height, decimals);
  return path;
}

namespace {

// The helix' side nearest to a place of its plane, from `first` on.
int nearest_side(const std::vector<patch::HelixSide>& path, int first, const Vec2& p) {
  int best = first;
  double least = std::numeric_limits<double>::infinity();
  for (int k = first; k < static_cast<int>(path.size()); ++k) {
    const Vec2 way = path[k].end - path[k].start;
    const double t = std::clamp((p - path[k].start).dot(way) / way.squaredNorm(), 0.0, 1.0);
    const double distance = (p - path[k].start - t * way).norm();
    if (distance < least) {
      least = distance;
      best = k;
    }
  }
  return best;
}

}  // namespace

std::vector<patch::MeasuredPhase> measure_phase(const ToolPath& path,
                                                const patch::FreeTexture& texture,
                                                const patch::Dimples& dimples, int patch) {
  constexpr double kSlack = 1e-11;  // turns
  require_of(texture, dimples);
  require_in_range("Patch", patch, 0, double(texture.frames.size()) - 1.0, "");
  for (const Move& move : path.moves)
    if (move.dimple != kNoDimple)
      require_in_range("Dimple", move.dimple, 0, double(dimples.size()) - 1.0, "");
  const patch::FreeFrame& frame = texture.frames[static_cast<std::size_t>(patch)];
  const double tooth = 1.0 / path.tool.flutes;
  std::vector<patch::HelixMark> marks;
  double turns = 0.0;             // since the patch's first mark
  std::int64_t tooth_number = 0;  // that passes next
  bool inside = false;
  int side = 0;
  auto come_by = [&](const Vec3& tip, double depth) {
    const Vec3 contact =
        tip + path.tool.radius * Vec3::UnitZ() - (path.tool.radius - depth) * frame.normal;
    const Vec2 place = frame.local(contact);
    side = nearest_side(texture.path, side, place);
    marks.push_back({place, side});
  };
  Vec3 from = path.start.tip;
  double depth = 0.0;
  for (const Move& move : path.moves) {
    const Vec3 way = move.end.tip - from;
    const patch::Dimple* at =
        move.dimple == kNoDimple ? nullptr : &dimples[static_cast<std::size_t>(move.dimple)];
    if (at && at->patch == patch) depth = at->depth;
    if (at && at->patch != patch && inside) break;
    if (inside && std::isnan(move.turns)) break;
    if (inside && move.kind == MoveKind::Cut)
      for (; double(tooth_number) * tooth <= turns + move.turns + kSlack; ++tooth_number)
        come_by(from + (double(tooth_number) * tooth - turns) / move.turns * way, depth);
    if (inside) turns += move.turns;
    if (at && at->patch == patch && (!inside || move.kind == MoveKind::Link)) {
      if (!inside) turns = 0.0;
      inside = true;
      tooth_number = std::llround(turns / tooth) + 1;
      come_by(move.end.tip, depth);
    }
    from = move.end.tip;
  }
  return measure_phase(texture.path, marks, texture.patch.feed_per_tooth);
}

}  // namespace patchmill::sync

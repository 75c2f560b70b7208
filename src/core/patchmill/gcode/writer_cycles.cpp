// Arcs, drilling cycles and references of a program; see writer.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/writer.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace patchmill::gcode {
namespace {

constexpr double kChord = 1e-3;     // of lines in the place of an arc [mm]
constexpr double kSameAngle = 1.0;  // by which the words of an arc may turn otherwise [rad]

// Whether the arc that its words say, with so many decimals, is about the same one. A short one may become a whole
// circle, or have no radius left.
bool is_arc_in_words(const Arc& arc, int decimals) {
  const double unit = std::pow(10.0, -decimals);
  const auto rounded = [unit](const Vec3& v) -> Vec3 { return (v / unit).array().round() * unit; };
  Arc said = arc;
  said.from = rounded(arc.from);
  said.to = rounded(arc.to);
  said.centre = said.from + rounded(arc.centre - arc.from);
  if ((said.centre - said.from).norm() < 0.5 * unit) return false;
  return std::abs(arc_angle(said) - arc_angle(arc)) < kSameAngle;
}

}  // namespace

Vec3 Writer::place_of(const PathBlock& block) const {
  Vec3 to(at_[0], at_[1], at_[2]);
  for (int i = 0; i < 3; ++i)
    if (block.gives("XYZ"[i])) to[i] = block.get("XYZ"[i]) + (relative_ ? to[i] : 0.0);
  return to;
}

void Writer::stand_at(const Vec3& point) {
  for (std::size_t i = 0; i < 3; ++i) {
    at_[i] = point[static_cast<Eigen::Index>(i)];
    known_[i] = true;
  }
}

void Writer::arc(const PathBlock& block, bool clockwise) {
  if (!(known_[0] && known_[1] && known_[2]))
    refuse_block(block, "an arc begins nobody knows where.");
  if (relative_) refuse_block(block, "arcs in relative coordinates are not posted.");
  if (other_operation_) first_move(block);
  const Vec3 from(at_[0], at_[1], at_[2]);
  Arc arc{from, place_of(block), from, plane_, clockwise};
  if (block.gives('R')) {
    const auto centre = arc_centre(from, arc.to, block.get('R'), plane_, clockwise);
    if (!centre) refuse_block(block, "no arc of that radius goes from here to there.");
    arc.centre = *centre;
  } else {
    const int across = plane_ == ArcPlane::XY ? 2 : plane_ == ArcPlane::ZX ? 1 : 0;
    for (int i = 0; i < 3; ++i)
      if (i != across && block.gives("IJK"[i])) arc.centre[i] += block.get("IJK"[i]);
  }
  if (inverse_ && !block.gives('F'))
    refuse_block(block, "in inverse time (G93) every arc needs its F.");
  if (pending_tool_) call_tool("");
  fresh_ = in_cycle_ = retracted_ = false;
  length();
  double feed = feed_;
  if (inverse_ && !control_.can.inverse_time) feed *= arc_length(arc);
  const bool inverse = inverse_ && control_.can.inverse_time;
  const bool flat = plane_ == ArcPlane::XY && arc.to.z() == from.z();
  if ((control_.can.arcs_in_all_planes || flat) && is_arc_in_words(arc, style_.precision))
    out_.arc(arc, feed, inverse);
  else
    arc_as_lines(arc, feed, inverse);
  stand_at(arc.to);
}

void Writer::arc_as_lines(const Arc& arc, double feed, bool inverse) {
  const std::vector<Vec3> points = arc_points(arc, kChord);
  for (const Vec3& point : points) {
    MoveBlock m;
    m.motion = Motion::Feed;
    m.given = {true, true, true};
    m.value = {point.x(), point.y(), point.z()};
    m.feed = inverse ? feed * static_cast<double>(points.size()) : feed;
    m.inverse = inverse;
    out_.move(m);
  }
}

void Writer::cycle(const PathBlock& block, int code) {
  if (!known_[2] || !(known_[0] || block.gives('X')) || !(known_[1] || block.gives('Y')))
    refuse_block(block, "a cycle begins nobody knows where.");
  if (relative_ || inverse_ || plane_ != ArcPlane::XY)
    refuse_block(block,
                 "cycles are posted in absolute coordinates, in the plane XY, with F in mm/min.");
  if (!block.gives('Z') || !block.gives('R')) refuse_block(block, "a cycle needs its Z and R.");
  if ((code == 730 || code == 830) && !(block.gives('Q') && block.get('Q') > 0.0))
    refuse_block(block, "it needs its Q, how deep each peck goes, greater than zero.");
  if (block.gives('L') && block.get('L') != 1.0) refuse_block(block, "a cycle is done once: L1.");
  if (other_operation_) first_move(block);
  if (pending_tool_) call_tool("");
  length();
  fresh_ = retracted_ = false;
  if (!in_cycle_) initial_ = at_[2];
  in_cycle_ = true;
  DrillingCycle cycle;
  cycle.code = code;
  cycle.bottom = block.get('Z');
  cycle.retract = block.get('R');
  cycle.initial = initial_;
  cycle.peck = block.gives('Q') ? block.get('Q') : 0.0;
  cycle.seconds = block.gives('P') ? block.get('P') : 0.0;
  cycle.to_initial = to_initial_;
  const Vec3 to = place_of(block);
  const double height = cycle_steps(cycle).back().z;  // refuses what cannot be
  if (control_.can.cycles)
    out_.cycle(cycle, to.x(), to.y(), feed_);
  else
    cycle_as_moves(cycle, to.x(), to.y());
  stand_at({to.x(), to.y(), height});
}

void Writer::cycle_as_moves(const DrillingCycle& cycle, double x, double y) {
  const auto rapid_or_feed = [&](bool feed, std::array<bool, kAxisCount> given, double z) {
    MoveBlock m;
    m.motion = feed ? Motion::Feed : Motion::Rapid;
    m.given = given;
    m.value = {x, y, z};
    m.feed = feed_;
    out_.move(m);
  };
  if (at_[2] < cycle.retract) rapid_or_feed(false, {false, false, true}, cycle.retract);
  rapid_or_feed(false, {true, true}, 0.0);
  double z = std::max(at_[2], cycle.retract);
  for (const CycleStep& step : cycle_steps(cycle)) {
    if (step.kind == CycleStep::Kind::Dwell)
      dwell(step.seconds);
    else if (step.z != z)
      rapid_or_feed(step.kind == CycleStep::Kind::Feed, {false, false, true}, step.z);
    z = step.z;
  }
}

/// G28 and G30: to the machine's reference, over the point that the block names.
void Writer::reference(const PathBlock& block, int tenths) {
  std::string text = code_text('G', tenths);
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    if (!block.gives(kWrittenAxes[i])) continue;
    text += fmt::format(" {}", kWrittenAxes[i]);
    append_fixed(text, block.get(kWrittenAxes[i]), style_.precision, false);
  }
  if (block.gives('P')) text += " P" + short_number(block.get('P'));
  out_.line(text);
  known_.fill(false);
  retracted_ = false;
  out_.forget();
}

}  // namespace patchmill::gcode

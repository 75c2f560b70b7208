// Moves, arcs and cycles of a program; see writer.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/writer.h"
#include "patchmill/geometry/error.h"

#include <cmath>

#include <fmt/format.h>

namespace patchmill::gcode {
namespace {

constexpr double kSameFeed = 2e-6;

// The feed before if this one is off by no more than the digits of F in inverse time.
double near(double feed, double before) {
  return std::abs(feed - before) <= kSameFeed * feed ? before : feed;
}

}  // namespace

LeadWord Writer::lead(double pitch, const Vec3& way, bool turned) const {
  const Abilities& can = control_.can;
  if (can.lead == LeadRule::None)
    throw InputError("Strategy", "Spindle-locked",
                     fmt::format("{} has no block that follows the spindle: use feed per move or "
                                 "constant feed.",
                                 control_.title));
  if (can.lead == LeadRule::AlongPath) return {can.lead_letters[0], pitch};
  if (turned && !can.lock_while_turning)
    throw InputError(
        "Strategy", "Spindle-locked",
        fmt::format("a rotary axis turns in a G33 block, which {} cannot: keep one tool axis for "
                    "the whole texture, or use feed per move.",
                    control_.title));
  Eigen::Index most = 0;
  const double longest = way.cwiseAbs().maxCoeff(&most), length = way.norm();
  const double along = length > 0.0 ? pitch * longest / length : pitch;
  const std::size_t letter = can.lead_letters.size() > 1 ? static_cast<std::size_t>(most) : 0;
  return {can.lead_letters[letter], along};
}

/// Where the block goes: its words into `m`, the way of X Y Z [mm], whether a rotary axis turns.
void Writer::place(const PathBlock& block, MoveBlock& m, Vec3& way, bool& turned) {
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const char letter = kWrittenAxes[i];
    m.given[i] = block.gives(letter);
    if (!m.given[i]) continue;
    m.value[i] = block.get(letter);
    const double to = m.value[i] + (m.relative ? at_[i] : 0.0);
    if (i >= 3 && i < 6) turned = turned || !known_[i] || to != at_[i];
    if (i < 3 && known_[i] && !m.machine) way[static_cast<Eigen::Index>(i)] = to - at_[i];
    if (m.machine && i < 3)
      known_[i] = false;
    else
      at_[i] = to;
    known_[i] = known_[i] || (!m.machine && !m.relative) || i >= 3;
  }
}

void Writer::move(const PathBlock& block, int tenths) {
  MoveBlock m;
  m.motion = tenths == 0 ? Motion::Rapid : tenths == 10 ? Motion::Feed : Motion::Locked;
  m.machine = block.code('G', 530);
  m.relative = relative_;
  in_cycle_ = false;
  Vec3 way = Vec3::Zero();
  bool turned = false;
  if (!called_ && m.motion == Motion::Rapid) return;  // there is no tool yet
  if (other_operation_) first_move(block);
  place(block, m, way, turned);
  m.feed = feed_;
  m.inverse = inverse_;
  if (m.motion == Motion::Feed && inverse_ && !block.gives('F'))
    refuse_block(block, "in inverse time (G93) every G1 needs its F.");
  if (m.motion == Motion::Locked && !block.gives('K')) refuse_block(block, "G33 needs its K word.");
  if (m.motion == Motion::Locked && !was_own_ && control_.can.lead == LeadRule::None)
    refuse_block(block, fmt::format("{} has no block that follows the spindle: take it out.",
                                    control_.title));
  if (m.motion == Motion::Locked) m.lead = lead(block.get('K'), way, turned);
  put(m, way);
  retracted_ = false;
}

void Writer::put(MoveBlock m, const Vec3& way) {
  if (pending_tool_) call_tool("");
  const bool plain = !m.machine && !m.relative;
  if (fresh_ && plain && m.motion == Motion::Rapid && !pending_tcp_) return first_rapid(m);
  if (!pending_tcp_ && !m.machine) length();
  if (m.motion == Motion::Feed && inverse_ && !control_.can.inverse_time) {
    // the feed that takes as long, or the time itself
    if (way.norm() > 0.0)
      m.feed = steady_ = near(way.norm() * feed_, steady_);
    else
      m.seconds = 60.0 / feed_;
    m.inverse = false;
  }
  if (pending_tcp_ && plain) return approach(m);
  out_.move(m);
}

/// The first rapids of a new tool as a machinist drives them: across, then down with the tool's length.
/// A rapid to a height alone waits for the one across.
void Writer::first_rapid(const MoveBlock& m) {
  MoveBlock part = m;
  part.given[2] = false;
  const bool height_alone = part.given == std::array<bool, kAxisCount>{};
  if (height_alone && !across_) {
    held_ = m;
    return;
  }
  if (!height_alone) out_.move(part);
  across_ = true;
  fresh_ = !held_ && !m.given[2];
  if (!fresh_) down(m.given[2] ? m : *held_);
}

void Writer::down(MoveBlock m) {
  m.given = {false, false, true};
  if (pending_length_) m.length = tool_;
  pending_length_ = false;
  held_.reset();
  out_.move(m);
}

/// The first rapid of a path with rotary axes as a machinist drives it: the rotary axes alone, TCP on, then across,
/// then down.
void Writer::approach(MoveBlock m) {
  MoveBlock part = m;
  part.given = {false, false, false, m.given[3], m.given[4], m.given[5]};
  if (m.given[3] || m.given[4] || m.given[5]) {
    retract();
    for (std::size_t i = 0; i < 3; ++i)
      known_[i] = known_[i] || m.given[i];  // it comes back at once
    out_.move(part);
  }
  pending_tcp_ = fresh_ = false;
  switch_tcp(true);
  part.given = {m.given[0], m.given[1]};
  if (m.motion != Motion::Rapid || !(m.given[0] || m.given[1])) return out_.move(m);
  out_.move(part);
  part.given = {false, false, m.given[2]};
  if (m.given[2]) out_.move(part);
}

/// To the machine's reference, where its file names one; then the tool comes in across and down again.
void Writer::retract() {
  if (style_.retract.empty() || retracted_) return;
  for (const auto& [axis, value] : style_.retract) {
    std::string number;
    append_fixed(number, value, style_.precision, control_.can.form == BlockForm::PlainText);
    if (style_.precision == 0 && control_.can.numbers_need_point) number += '.';
    out_.lines(
        filled(filled(control_.texts.machine_move, "axis", std::string(1, axis)), "value", number));
    const std::size_t i = kWrittenAxes.find(axis);
    if (i < 3) known_[i] = false;
  }
  out_.forget();
  fresh_ = called_;
  across_ = false;
  retracted_ = true;
}

/// Before the first move of another operation: the path mode as it was, unless it has said its own.
void Writer::first_move(const PathBlock& block) {
  other_operation_ = false;
  if (!mode_said_ && path_mode_ != wanted_mode_) {
    const std::string& mode = wanted_mode_.empty() ? first_mode_ : wanted_mode_;
    if (mode != path_mode_ && !mode.empty()) out_.line(mode);
    path_mode_ = wanted_mode_;
    out_.forget_word();
  }
  upright(block);
}

/// Rotary axes that the operation before has left turned go back to zero, but for those that `block` moves.
void Writer::upright(const PathBlock& block) {
  std::string back;
  for (std::size_t i = 3; i < 6; ++i) {
    if (!known_[i] || at_[i] == 0.0 || block.gives(kWrittenAxes[i])) continue;
    back += kWrittenAxes[i];
    at_[i] = 0.0;
  }
  if (back.empty() || pending_tcp_) return;
  if (style_.retract.empty())
    throw InputError(
        "Machine", "axes " + back,
        "an upright operation follows, and the machine's file does not say where the tool "
        "is clear of a turning table: give retract_mm there, or bring them back to zero in "
        "the operation that turns them.");
  retract();
  MoveBlock upright;
  for (const char letter : back) {
    const std::size_t i = kWrittenAxes.find(letter);
    upright.given[i] = true;
  }
  out_.move(upright);
}

}  // namespace patchmill::gcode

// The writer of all dialects; see program_writer.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/machine/program_writer.h"

#include "core/geometry/error.h"
#include "core/machine/path_block.h"
#include "core/machine/program_text.h"

#include <optional>

#include <fmt/format.h>

namespace patchmill {
namespace {

class Writer {
 public:
  explicit Writer(const ProgramStyle& style)
      : style_(style), out_(style), words_(words_of(style.dialect)) {}

  std::string write(const std::vector<std::string>& texts) {
    out_.begin();
    for (const std::string& line : style_.header) out_.comment(line);
    out_.lines(style_.preamble.empty() ? words_.preamble : style_.preamble);
    long number = 0;
    for (const std::string& text : texts) {
      std::string_view rest = text;
      while (!rest.empty()) {
        const std::size_t end = rest.find('\n');
        one_line(rest.substr(0, end), ++number);
        rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
      }
    }
    tcp(false);
    if (inverse_) out_.line(words_.per_minute);
    const bool cancelled = tcp_used_ && style_.dialect == Dialect::Fanuc;  // by TCP's G49
    const bool rounding = path_mode_.empty() && style_.dialect == Dialect::Siemens;
    if (cancelled || rounding) words_.postamble = "M5\nM30";
    out_.lines(style_.postamble.empty() ? words_.postamble : style_.postamble);
    return out_.end();
  }

 private:
  void one_line(std::string_view text, long number) {
    if (text.empty()) return;
    if (text[0] == '(') {
      if (style_.comments) out_.comment(text.substr(1, text.size() - (text.back() == ')' ? 2 : 1)));
      return;
    }
    const PathBlock block = path_block(text, number);
    if (held_ && block.g != 0) {
      fresh_ = false;
      down(*held_);
    }
    if (block.m >= 0) return machine_word(block);
    if (block.g == 0 || block.g == 10 || block.g == 330) return move(block);
    if (block.g >= 0) return preparatory(block);
    if (block.gives('S') || block.gives('T') || block.gives('F')) return;  // given where it counts
    refuse_block(block, "no G or M word: this block is not written.");
  }

  void machine_word(const PathBlock& block) {
    if (block.m == 3 || block.m == 4) {
      if (block.gives('S')) speed_ = block.get('S');
      return start_spindle(block.m);
    }
    if (block.m == 2 || block.m == 30) return;  // the postamble's
    if (block.m == 6) return tool_change(block);
    if (block.m == 428 || block.m == 128) return tcp(true);
    if (block.m == 429 || block.m == 129) return tcp(false);
    out_.line(fmt::format("M{}", block.m));
  }
  void start_spindle(int sense) {
    if (style_.dialect == Dialect::LinuxCnc)
      return out_.line(fmt::format("M{} S{:.0f}", sense, speed_));
    if (style_.dialect != Dialect::Heidenhain)
      return out_.line(fmt::format("S{:.0f} M{}", speed_, sense));
    call_tool(fmt::format(" S{:.0f}", speed_));
    out_.line(fmt::format("M{}", sense));
  }
  /// Heidenhain's TOOL CALL, which wants the speed that FreeCAD gives later; without a change it sets
  /// the speed alone.
  void call_tool(const std::string& speed) {
    out_.line(pending_tool_ ? fmt::format("TOOL CALL {} Z{}", tool_, speed) : "TOOL CALL" + speed);
    pending_tool_ = false;
    out_.forget();
  }
  /// TCP off, stop, change; the spindle starts after it.
  void tool_change(const PathBlock& block) {
    tcp(false);
    const int tool = block.gives('T') ? static_cast<int>(block.get('T')) : 0;
    tool_ = tool;
    called_ = true;
    fresh_ = style_.dialect != Dialect::LinuxCnc;
    across_ = false;
    if (style_.dialect == Dialect::Heidenhain) {
      pending_tool_ = true;
      return;
    }
    out_.line("M5");
    if (style_.dialect == Dialect::Siemens) {
      out_.line(fmt::format("T{} D1", tool));
      return out_.line("M6");
    }
    out_.line(fmt::format("T{} M6", tool));
    pending_length_ = style_.tool_length;
    out_.forget();
  }
  void tcp(bool on) {
    pending_tcp_ = on && !tcp_;
    if (!on) switch_tcp(false);
  }
  /// TCP comes on when the rotary axes have been put where the first move wants them, and takes the tool
  /// length with it.
  void switch_tcp(bool on) {
    if (on == tcp_) return;
    tcp_ = on;
    if (on) pending_length_ = style_.dialect == Dialect::LinuxCnc && pending_length_;
    if (on && pending_length_) length();
    if (on) tcp_used_ = true;
    if (!on && !style_.smoothing_off.empty()) out_.lines(style_.smoothing_off);
    out_.lines(on ? with_number(words_.tcp_on, tool_) : words_.tcp_off);
    if (on && !style_.smoothing_on.empty()) out_.lines(style_.smoothing_on);
    out_.forget();
  }

  void length() {
    if (pending_length_) out_.line(fmt::format("G43 H{}", tool_));
    pending_length_ = false;
  }
  /// The first rapids of a new tool as a machinist drives them: across, then down with the tool's length.
  /// A rapid to a height alone waits for the one across.
  void first_rapid(const MoveBlock& m) {
    MoveBlock part = m;
    part.given[2] = false;
    const bool height_alone = part.given == std::array<bool, 6>{};
    if (height_alone && !across_) {
      held_ = m;
      return;
    }
    if (!height_alone) out_.move(part);
    across_ = true;
    fresh_ = !held_ && !m.given[2];
    if (!fresh_) down(m.given[2] ? m : *held_);
  }
  void down(MoveBlock m) {
    m.given = {false, false, true, false, false, false};
    if (pending_length_) m.length = tool_;
    pending_length_ = false;
    held_.reset();
    out_.move(m);
  }
  /// The first rapid of a path with rotary axes as a machinist drives it: the rotary axes alone, TCP on,
  /// then across, then down.
  void approach(MoveBlock m) {
    MoveBlock part = m;
    part.given = {false, false, false, m.given[3], m.given[4], m.given[5]};
    if (m.given[3] || m.given[4] || m.given[5]) out_.move(part);
    pending_tcp_ = fresh_ = false;
    switch_tcp(true);
    part.given = {m.given[0], m.given[1], false, false, false, false};
    if (m.motion != Motion::Rapid || !(m.given[0] || m.given[1])) return out_.move(m);
    out_.move(part);
    part.given = {false, false, m.given[2], false, false, false};
    if (m.given[2]) out_.move(part);
  }

  void preparatory(const PathBlock& block) {
    if (block.g == 930 || block.g == 940) {
      const bool inverse = block.g == 930;
      if (inverse != inverse_ && style_.dialect != Dialect::Heidenhain)
        out_.line(inverse ? words_.inverse : words_.per_minute);
      inverse_ = inverse;
      return;
    }
    if (block.g == 434) return tcp(true);
    if (block.g == 490 && (tcp_ || pending_tcp_)) return tcp(false);
    if (block.g == 610) return path_mode(words_.exact_stop);
    if (block.g == 640)
      return path_mode(rounding_text(style_.dialect, block.gives('P') ? block.get('P') : 0.0));
    if (block.g == 40) return out_.lines(dwell_text(style_.dialect, block.get('P')));
    if (style_.dialect == Dialect::Heidenhain || style_.dialect == Dialect::Siemens) {
      // states that the preamble sets; work offsets are chosen at the control
      if (block.g == 170 || block.g == 210 || block.g == 400 || block.g == 430 || block.g == 490 ||
          block.g == 800 || block.g == 900 || (block.g >= 540 && block.g <= 590))
        return;
      refuse_block(block,
                   fmt::format("{} has no such block here: post cycles and arcs with another "
                               "post-processor.",
                               name(style_.dialect)));
    }
    out_.plain(block.g, [&](char letter, double& value) {
      value = letter == 'F' ? 60.0 * block.get(letter) : block.get(letter);
      return block.gives(letter);
    });
  }
  void path_mode(const std::string& word) {
    if (word.empty() || word == path_mode_) return;
    path_mode_ = word;
    out_.line(word);
    out_.forget_word();
  }

  void move(const PathBlock& block) {
    MoveBlock m;
    m.motion = block.g == 0 ? Motion::Rapid : block.g == 10 ? Motion::Feed : Motion::Locked;
    Vec3 way = Vec3::Zero();
    bool turned = false;
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
      const char letter = kAxes[i];
      m.given[i] = block.gives(letter);
      if (!m.given[i]) continue;
      m.value[i] = block.get(letter);
      if (i >= 3) turned = turned || !known_[i] || m.value[i] != at_[i];
      if (i < 3 && known_[i]) way[static_cast<Eigen::Index>(i)] = m.value[i] - at_[i];
      at_[i] = m.value[i];
      known_[i] = true;
    }
    if (block.gives('F')) feed_ = 60.0 * block.get('F');
    m.feed = feed_;
    m.inverse = inverse_;
    if (m.motion == Motion::Feed && inverse_ && !block.gives('F'))
      refuse_block(block, "in inverse time (G93) every G1 needs its F.");
    if (m.motion == Motion::Locked && !block.gives('K'))
      refuse_block(block, "G33 needs its K word.");
    if (m.motion == Motion::Locked) m.lead = lead_word(style_.dialect, block.get('K'), way, turned);
    // before the first tool a program has no length to go by: FreeCAD's rapid to the clearance is left to
    // the operator, who retracts
    if (!called_ && m.motion == Motion::Rapid && style_.dialect != Dialect::LinuxCnc) return;
    if (pending_tool_) call_tool("");
    if (fresh_ && m.motion == Motion::Rapid && !pending_tcp_) return first_rapid(m);
    if (!pending_tcp_) length();
    if (m.motion == Motion::Feed && style_.dialect == Dialect::Heidenhain && inverse_) {
      // no inverse time in plain text: the feed that takes as long, or the time itself
      if (way.norm() > 0.0)
        m.feed = steady_ = near(way.norm() * feed_, steady_);
      else
        m.seconds = 60.0 / feed_;
      m.inverse = false;
    }
    if (pending_tcp_) return approach(m);
    out_.move(m);
  }
  /// The feed before if this one is off by no more than the digits of F in inverse time.
  static double near(double feed, double before) {
    return std::abs(feed - before) <= kSameFeed * feed ? before : feed;
  }

  static constexpr std::string_view kAxes = "XYZABC";
  static constexpr double kSameFeed = 2e-6;
  const ProgramStyle& style_;
  ProgramText out_;
  DialectWords words_;
  std::array<double, 6> at_{};
  std::array<bool, 6> known_{};
  double feed_ = 0.0, speed_ = 0.0, steady_ = 0.0;
  int tool_ = 1;
  bool tcp_ = false, tcp_used_ = false, pending_tcp_ = false, inverse_ = false;
  bool called_ = false, fresh_ = false, across_ = false, pending_tool_ = false,
       pending_length_ = false;
  std::string path_mode_;
  std::optional<MoveBlock> held_;  ///< rapid of a new tool to a height, from nobody knows where
};

}  // namespace

std::string write_program(const std::vector<std::string>& texts, const ProgramStyle& style) {
  if (style.precision < 0 || style.precision > 6)
    throw InputError("PostProcessorArgs", fmt::format("--precision={}", style.precision),
                     "give 0 to 6 decimals.");
  return Writer(style).write(texts);
}

}  // namespace patchmill

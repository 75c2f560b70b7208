// LinuxCNC's words for a ToolPath; see rs274_text.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/rs274_text.h"

#include "patchmill/geometry/error.h"

#include <cmath>

#include <fmt/format.h>

namespace patchmill::gcode {
namespace {

constexpr double kPitchUnit = 1e-6;  // of the K word, mm per turn; FreeCAD saves six decimals

class Writer {
 public:
  Writer(const ToolPath& path, const machine::MotionModel& model, const Decimals& decimals,
         FeedWord feed, double feed_unit, const RotaryWords& rotary)
      : path_(path),
        rotary_(rotary),
        decimals_(decimals),
        feed_(feed),
        feed_unit_(feed_unit),
        tolerances_(machine::posted_tolerances(path, model)),
        pitches_(machine::locked_pitches(path, machine::corners(path, model))) {}

  Rs274Text write() {
    line("G21 G90 G17 G40 G94");
    line(fmt::format("S{:.3f} {}", path_.spindle.speed * 60.0,
                     path_.spindle.sense == SpindleSense::M3 ? "M3" : "M4"));
    line("G0 " + words(path_.start.tip) + rotary_words(0));
    moves();
    if (inverse_) line("G94");
    line("M5");
    line("M2");
    return std::move(result_);
  }

  Rs274Text write_moves() {
    line("G0 " + words(path_.start.tip) + rotary_words(0));
    moves();
    if (inverse_) line("G94");
    return std::move(result_);
  }

 private:
  void moves() {
    Vec3 from = path_.start.tip;
    for (std::size_t i = 0; i < path_.moves.size(); ++i) {
      const Move& move = path_.moves[i];
      const double length = (move.end.tip - from).norm();
      from = move.end.tip;
      turning_ = !rotary_.letters.empty() && rotary_.joints[i + 1] != rotary_.joints[i];
      if (length > 0.0 || turning_) one_move(i, length);
      result_.lines.push_back(count_);
    }
  }
  void line(const std::string& text) {
    result_.text += text + "\n";
    ++count_;
  }
  std::string words(const Vec3& p) const {
    const int n = decimals_.count();
    return fmt::format("X{:.{}f} Y{:.{}f} Z{:.{}f}", p.x(), n, p.y(), n, p.z(), n);
  }
  /// The rotary words of pose i, in the order of their letters; the start is pose 0.
  std::string rotary_words(std::size_t i) const {
    std::string text;
    for (const char letter : {'A', 'B', 'C'}) {
      const std::size_t k = rotary_.letters.find(letter);
      if (k == std::string::npos) continue;
      text += fmt::format(" {}{:.{}f}", letter, Angle::radians(rotary_.joints[i][k]).degrees(),
                          decimals_.count());
    }
    return text;
  }
  void tolerance(double value) {
    const std::string word = value > 0.0 ? fmt::format("G64 P{:.6f} Q0", value) : "G61";
    if (word != tolerance_) line(word);
    tolerance_ = word;
  }
  void inverse(bool on) {
    if (on != inverse_) line(on ? "G93" : "G94");
    inverse_ = on;
  }
  void one_move(std::size_t i, double length) {
    const Move& move = path_.moves[i];
    if (move.kind == MoveKind::Rapid) {
      line("G0 " + words(move.end.tip) + rotary_words(i + 1));
      return;
    }
    if (!(move.turns > 0.0))
      throw InputError("Turns", fmt::format("{} in move {}", move.turns, i),
                       "a timed move needs more than no turns.");
    if (!rotary_.as_set || !std::isnan(move.tolerance)) tolerance(tolerances_[i]);
    const std::string place = words(move.end.tip) + rotary_words(i + 1);
    if (move.pace == Pace::SpindleLocked) {
      if (!(length > 0.0))
        throw InputError(
            "ToolAxis", fmt::format("move {}", i),
            "a spindle-locked move needs a way of the programmed point: rotary axes alone "
            "cannot be locked.");
      inverse(false);
      line(fmt::format("G33 {} K{:.6f}", place, posted_pitch(i, length)));
      return;
    }
    const double minutes = duration(move, path_.spindle) / 60.0;
    // F of a rotary move means little: its time is given instead
    const bool timed = feed_ == FeedWord::InverseTime || turning_;
    inverse(timed);
    const int feed_decimals = feed_unit_ == 1.0 ? 6 : 9;  // FreeCAD's are smaller by as much
    line(fmt::format("G1 {} F{:.{}f}", place, (timed ? 1.0 : length) / minutes / feed_unit_,
                     feed_decimals));
  }
  /// K on its decimals; the turns that rounding adds or takes are made up for in the next move.
  double posted_pitch(std::size_t i, double length) {
    const double turns = length / pitches_[i] + left_over_;
    const double pitch = std::round(length / turns / kPitchUnit) * kPitchUnit;
    left_over_ = turns - length / pitch;
    return pitch;
  }

  const ToolPath& path_;
  const RotaryWords& rotary_;
  const Decimals& decimals_;
  FeedWord feed_;
  double feed_unit_;  // of the F word, mm/min
  std::vector<double> tolerances_, pitches_;
  std::string tolerance_;
  bool inverse_ = false, turning_ = false;
  double left_over_ = 0.0;
  long count_ = 0;
  Rs274Text result_;
};

}  // namespace

Rs274Text rs274_text(const ToolPath& path, const machine::MotionModel& model,
                     const Decimals& decimals, FeedWord feed, const RotaryWords& rotary) {
  return Writer(path, model, decimals, feed, 1.0, rotary).write();
}

std::string freecad_paced_text(const ToolPath& path, const machine::MotionModel& model,
                               const Decimals& decimals, FeedWord feed, const RotaryWords& rotary) {
  return Writer(path, model, decimals, feed, 60.0, rotary).write_moves().text;
}

}  // namespace patchmill::gcode

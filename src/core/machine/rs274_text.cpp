// LinuxCNC's words for a ToolPath; see rs274_text.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/machine/rs274_text.h"

#include "core/geometry/error.h"

#include <cmath>

#include <fmt/format.h>

namespace patchmill {
namespace {

constexpr double kPitchUnit = 1e-6;  // of the K word, mm per turn; FreeCAD saves six decimals

class Writer {
 public:
  Writer(const ToolPath& path, const MotionModel& model, const Decimals& decimals, FeedWord feed,
         double feed_unit)
      : path_(path),
        decimals_(decimals),
        feed_(feed),
        feed_unit_(feed_unit),
        tolerances_(posted_tolerances(path, model)),
        pitches_(locked_pitches(path, corners(path, model))) {}

  Rs274Text write() {
    line("G21 G90 G17 G40 G94");
    line(fmt::format("S{:.3f} {}", path_.spindle.speed * 60.0,
                     path_.spindle.sense == SpindleSense::M3 ? "M3" : "M4"));
    line("G0 " + words(path_.start.tip));
    moves();
    if (inverse_) line("G94");
    line("M5");
    line("M2");
    return std::move(result_);
  }

  Rs274Text write_moves() {
    line("G0 " + words(path_.start.tip));
    moves();
    return std::move(result_);
  }

 private:
  void moves() {
    Vec3 from = path_.start.tip;
    for (std::size_t i = 0; i < path_.moves.size(); ++i) {
      const Move& move = path_.moves[i];
      const double length = (move.end.tip - from).norm();
      from = move.end.tip;
      if (length > 0.0) one_move(i, length);
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
      line("G0 " + words(move.end.tip));
      return;
    }
    if (!(move.turns > 0.0))
      throw InputError("Turns", fmt::format("{} in move {}", move.turns, i),
                       "a timed move needs more than no turns.");
    tolerance(tolerances_[i]);
    if (move.pace == Pace::SpindleLocked) {
      inverse(false);
      line(fmt::format("G33 {} K{:.6f}", words(move.end.tip), posted_pitch(i, length)));
      return;
    }
    const double minutes = duration(move, path_.spindle) / 60.0;
    inverse(feed_ == FeedWord::InverseTime);
    line(fmt::format(
        "G1 {} F{:.6f}", words(move.end.tip),
        feed_ == FeedWord::InverseTime ? 1.0 / minutes : length / minutes / feed_unit_));
  }
  /// K on its decimals; the turns that rounding adds or takes are owed to the next move.
  double posted_pitch(std::size_t i, double length) {
    const double turns = length / pitches_[i] + owed_;
    const double pitch = std::round(length / turns / kPitchUnit) * kPitchUnit;
    owed_ = turns - length / pitch;
    return pitch;
  }

  const ToolPath& path_;
  const Decimals& decimals_;
  FeedWord feed_;
  double feed_unit_;  // of the F word, mm/min
  std::vector<double> tolerances_, pitches_;
  std::string tolerance_;
  bool inverse_ = false;
  double owed_ = 0.0;
  long count_ = 0;
  Rs274Text result_;
};

}  // namespace

Rs274Text rs274_text(const ToolPath& path, const MotionModel& model, const Decimals& decimals,
                     FeedWord feed) {
  return Writer(path, model, decimals, feed, 1.0).write();
}

std::string freecad_paced_text(const ToolPath& path, const MotionModel& model,
                               const Decimals& decimals) {
  return Writer(path, model, decimals, FeedWord::PerMinute, 60.0).write_moves().text;
}

}  // namespace patchmill

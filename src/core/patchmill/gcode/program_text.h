// Putting down blocks of a program: numbers, block numbers, comments and modal words of a control. What
// the blocks are is writer.h's affair.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/gcode/gcode_motion.h"
#include "patchmill/gcode/program_writer.h"

#include <array>

namespace patchmill::gcode {

constexpr std::string_view kWrittenAxes = "XYZABCUVW";
constexpr std::size_t kAxisCount = 9;

enum class Motion : std::uint8_t { Rapid, Feed, Locked };

/// G33's lead: the letter that carries it, and mm per turn along what the letter means.
struct LeadWord {
  char letter = 'K';
  double value = 0.0;
};

/// A block that moves.
struct MoveBlock {
  Motion motion = Motion::Rapid;
  std::array<bool, kAxisCount> given{};  ///< X Y Z A B C U V W
  std::array<double, kAxisCount> value{};
  double feed = 0.0;     ///< mm/min, or 1/min if inverse
  bool inverse = false;  ///< F belongs to this block alone
  double seconds = 0.0;  ///< > 0: the block's time instead of a feed (Heidenhain's FT)
  LeadWord lead;
  int length = 0;         ///< > 0: this tool's length comes into force on the block (G43 Z H)
  bool machine = false;   ///< in machine coordinates (G53)
  bool relative = false;  ///< the values are ways (G91 is in force)
};

/// Appends `value` with exactly `decimals` of them, never as minus zero; `plus`: always with its sign.
void append_fixed(std::string& text, double value, int decimals, bool plus);

/// `value` with no more decimals than it needs, six at most.
std::string short_number(double value);

/// The text of a program as it grows, block by block, in the words of its control.
class ProgramText {
 public:
  /// The style must outlive it.
  explicit ProgramText(const ProgramStyle& style);
  /// The head of the program.
  void begin();
  /// The foot of the program; gives all of its text.
  std::string end();
  /// A comment, if the style has them, made of what its control can read.
  void comment(std::string_view text);
  /// A block of these words, numbered as the style asks.
  void line(const std::string& text);
  void lines(const std::string& text);  ///< one for each line of `text`
  /// A straight move; words that are in force already are left out.
  void move(const MoveBlock& block);
  /// An arc in absolute coordinates with its centre from its start, or about CC. `feed` as MoveBlock's.
  void arc(const Arc& arc, double feed, bool inverse);
  /// A drilling cycle over X Y [mm] with `feed` in mm/min.
  void cycle(const DrillingCycle& cycle, double x, double y, double feed);
  void forget();       ///< all modal words are to be given again
  void forget_word();  ///< the G word is
  /// The word of an axis, 0 to 8, is to be given again.
  void forget_axis(std::size_t axis) { known_[axis] = false; }

 private:
  void number();
  void straight_line(const MoveBlock& block);
  void feed_word(double feed, bool inverse);
  void word(char letter, double value, int decimals);
  double feed_units(double feed) const;
  void axes(const MoveBlock& block, bool plus);
  void remember(const Arc& arc);

  const ProgramStyle& style_;
  const Control& control_;
  int feed_decimals_;  // of F: FreeCAD's feeds are rounded to three at least
  std::string text_;
  long count_ = 0;
  int motion_ = -1;  // in force
  std::array<bool, kAxisCount> known_{};
  std::array<double, kAxisCount> at_{};
  double feed_ = -1.0;  // in force, in units of its last decimal
};

}  // namespace patchmill::gcode

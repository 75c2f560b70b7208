// Putting down blocks of a program: numbers, block numbers, comments and modal words of a dialect. What
// the blocks are is program_writer.cpp's affair.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "core/machine/dialect_text.h"
#include "core/machine/program_writer.h"

#include <array>
#include <functional>

namespace patchmill {

enum class Motion : std::uint8_t { Rapid, Feed, Locked };

struct MoveBlock {
  Motion motion = Motion::Rapid;
  std::array<bool, 6> given{};  ///< X Y Z A B C
  std::array<double, 6> value{};
  double feed = 0.0;     ///< mm/min, or 1/min if inverse
  bool inverse = false;  ///< F belongs to this block alone
  double seconds = 0.0;  ///< > 0: the block's time instead of a feed (Heidenhain's FT)
  LeadWord lead;
  int length = 0;  ///< > 0: this tool's length comes into force on the block (G43 Z H)
};

/// Appends `value` with exactly `decimals` of them, never as minus zero; `plus`: always with its sign.
void append_fixed(std::string& text, double value, int decimals, bool plus);

class ProgramText {
 public:
  explicit ProgramText(const ProgramStyle& style);
  void begin();
  std::string end();
  void comment(std::string_view text);
  void line(const std::string& text);
  void lines(const std::string& text);  ///< one for each line of `text`
  void move(const MoveBlock& block);
  /// A G word (in tenths) with its other words as given: `get` says whether a letter is there.
  void plain(int tenths, const std::function<bool(char, double&)>& get);
  void forget();       ///< all modal words are to be given again
  void forget_word();  ///< the G word is

 private:
  void number();
  void straight_line(const MoveBlock& block);
  double feed_units(double feed) const;
  void axes(const MoveBlock& block, bool plus);

  const ProgramStyle& style_;
  int feed_decimals_;  // of F: FreeCAD's feeds are rounded to three at least
  std::string text_;
  long count_ = 0;
  int motion_ = -1;  // in force
  std::array<bool, 6> known_{};
  std::array<double, 6> at_{};
  double feed_ = -1.0;  // in force, in units of its last decimal
};

}  // namespace patchmill

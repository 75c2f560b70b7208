// A control as a value: what it can do, its words with what they mean, how its blocks are put down and how they
// are read. Each control is one file of the folder known, NAME.cpp with the function NAME(), and cmake/Controls.cmake
// lists them. Writer, reader and posts ask the value and never which control it is.
//
// What a word means is said in one common tongue, that of RS-274 as LinuxCNC has it: G4 P in seconds, G33 K in mm
// per turn along the path, G43.4 and G49 for tool-centre-point control, F in mm/min.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/gcode/controls/letter_set.h"
#include "patchmill/gcode/gcode_words.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace patchmill::gcode {

/// Modal groups: a block may have one word of each.
enum class WordGroup : std::uint8_t {
  Motion,
  Plane,
  Distance,
  ArcDistance,
  FeedMode,
  Units,
  Radius,
  Length,
  Offset,
  PathMode,
  Return,
  Once,  ///< in its own block only: G4, G28, G53
  Stop,
  Spindle,
  ToolChange,
  Coolant,
  Override,
  User,  ///< M words of the machine's builder or user: no effect on the programmed path
  None   ///< beside any other word
};

/// A G or M word of a control. `means` and numbers in `text` are in tenths in `own`: G43.4 is 434.
struct CodeWord {
  char letter = 'G';
  int own = 0;    ///< the control's number, in tenths
  int means = 0;  ///< the number in the common tongue, in tenths
  WordGroup group = WordGroup::None;
  std::string_view takes = "";  ///< letters that the word may have beside it in its block
  bool implied = false;  ///< always in force here: nothing is written for it, and it is never read
  bool forbidden = false;  ///< the control has it, and programs here do not: subprograms
};

/// How a comment is made harmless: it must never be able to end itself, the block, or the file.
struct CommentRules {
  bool round = true;      ///< in parentheses; else from ';' to the end of the line
  bool capitals = false;  ///< letters are made capitals
  std::size_t max_length = 200;
  std::string_view plain =
      "";  ///< signs allowed beside letters, digits and blanks; empty: all printing
  std::vector<std::string_view> active =
      {};  ///< beginnings that the control acts on, in small letters
};

/// Which letter carries G33's lead.
enum class LeadRule : std::uint8_t { None, AlongPath, LongestAxis };
enum class BlockForm : std::uint8_t { Words, PlainText };

/// What a control can do.
struct Abilities {
  LeadRule lead = LeadRule::None;
  std::string_view lead_letters = "";  ///< one, or those of X, Y and Z
  bool lock_while_turning = false;     ///< a rotary axis may turn in a G33 block
  bool inverse_time = true;
  bool tcp = true;
  bool tcp_brings_length = true;     ///< the word that switches TCP on calls the tool's length
  bool tcp_off_ends_length = false;  ///< the word that switches it off cancels it
  bool length_word = true;           ///< G43 H is needed after a tool change
  bool cycles = true;                ///< drilling cycles; else they are written as moves
  bool arcs_in_all_planes = true;    ///< and with a third axis; else such arcs are written as lines
  bool across_then_down = true;      ///< a new tool goes across first, then down
  bool numbers_need_point = false;   ///< X10 would be ten units of the last decimal
  bool builder_words = false;  ///< M words that are not in the table are the machine builder's
  int max_decimals = 6;
  std::size_t max_line = 255;
  std::string_view axes = "XYZABC";  ///< letters that may be axes
  BlockForm form = BlockForm::Words;
};

/// Texts with {tool}, {speed}, {sense}, {name}, {number}, {value}.
struct FixedTexts {
  std::string begin, end;           ///< of the file, without block numbers
  std::string preamble, postamble;  ///< lines
  std::string plain_postamble;      ///< the postamble where no path mode and no length is in force
  std::string tcp_on, tcp_off;
  std::string rounding;           ///< path mode that rounds corners by {value} mm; {merging}: Q
  std::string spindle;            ///< start
  std::string tool_change;        ///< lines
  std::string speed;              ///< a new speed of a turning spindle
  std::string preselect;          ///< the next tool
  std::string machine_move;       ///< a rapid of axis {axis} to {value} in machine coordinates
  std::string path_mode = "G64";  ///< in force when a program begins
  char dwell_letter = 'P';
  double dwell_units = 1.0;  ///< units per second
  int dwell_decimals = 3;
  std::string dwell;  ///< lines, where no G4 P does
};

struct Control;
using WordReader = std::vector<GcodeWord> (*)(const Control& control, std::string_view line,
                                              long number);

/// A control: its words, its texts and how it is read.
struct Control {
  std::string_view name;                ///< in machine files, posts and macros
  std::string_view title;               ///< as its users call it
  std::string_view file_ending = "nc";  ///< of program files, without the dot
  Abilities can;
  CommentRules comments;
  FixedTexts texts;
  std::vector<CodeWord> codes;
  LetterSet modal_letters = 0;  ///< that a block of numbers alone may have: give_words()
  WordReader read = nullptr;    ///< a line's words in the common tongue

  /// The word that means a number of the common tongue; null if the control has none.
  const CodeWord* meaning(char letter, int means) const;
  /// The control's own word of that number; null if it has none.
  const CodeWord* word(char letter, int own) const;
};

/// All controls, in the order of their names.
const std::vector<const Control*>& controls();
/// By name. Errors: InputError naming Dialect.
const Control& control_of(std::string_view name);

/// The one that programs are for where nobody says so.
const Control& linuxcnc();

/// "G54" -> "G43.4" ...: a number in tenths as it is written.
std::string code_text(char letter, int tenths);

/// `text` as this control's comment, with what encloses it. Whatever the text holds, the comment is one line of
/// ASCII that no control acts on.
std::string safe_comment(const CommentRules& rules, std::string_view text);

/// `text` with `value` in the place of "{mark}".
std::string filled(std::string text, std::string_view mark, std::string_view value);

}  // namespace patchmill::gcode

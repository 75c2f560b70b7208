// States, tools and spindles of a program; see writer.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/controls/common_words.h"
#include "patchmill/gcode/writer.h"
#include "patchmill/geometry/error.h"

#include <cmath>

#include <fmt/format.h>

namespace patchmill::gcode {
namespace {

constexpr LetterSet kAlways = letter_set("FST");

bool is_cycle(int tenths) {
  return tenths == 730 || tenths == 810 || tenths == 820 || tenths == 830 || tenths == 850 ||
         tenths == 890;
}
bool is_tcp(int m) {
  return m == 4280 || m == 4290;
}
int number_of_m(const std::string& word) {
  return word.size() > 1 && word.size() < 6 && word[0] == 'M' &&
                 word.find_first_not_of("0123456789", 1) == std::string::npos
             ? 10 * std::stoi(word.substr(1))
             : -1;
}

// Beside G64. Where a control has no word for how much corners are rounded, one of ours goes without; others said
// what they want.
LetterSet rounding_letters(const Control& control, bool own) {
  const bool within = control.texts.rounding.find("{value}") != std::string::npos;
  const bool merging = control.texts.rounding.find("{merging}") != std::string::npos;
  return (own || within ? letter_set("P") : 0) | (own || merging ? letter_set("Q") : 0);
}

// `own`: the operation is one of ours.
void require_tcp(const Control& control, bool own, const PathBlock& block) {
  if (control.can.tcp) return;
  const std::string why = fmt::format("{} has no tool-centre-point control: ", control.title);
  if (!own) refuse_block(block, why + "take it out.");
  throw InputError("ProgramForm", "With TCP", why + "choose Without TCP.");
}

}  // namespace

/// Whether the control can say the word, in its own or in other ones.
bool Writer::known(const PathBlock& block, const BlockCode& code) const {
  const int t = code.tenths;
  if (code.letter == 'M') {
    if (t == 20 || t == 300)
      refuse_block(block, "it would end the program, which the post does: take it out.");
    if (t == 4280) require_tcp(control_, was_own_, block);
    if (is_tcp(t) || t == number_of_m(style_.tcp_on) || t == number_of_m(style_.tcp_off))
      return true;
    const CodeWord* word = control_.meaning('M', t);
    if (word) return !word->forbidden;
    return control_.can.builder_words && t % 10 == 0 && t < 10000;
  }
  if (t == 200) refuse_block(block, "FreeCAD's paths are in millimetres: take it out.");
  if (t == 330) return true;  // lead() says why it cannot be
  if (t == 434) require_tcp(control_, was_own_, block);
  if (t == 434) return true;  // the control's own words say it
  if (t == 640 && was_own_ && control_.meaning('G', t) == nullptr)
    throw InputError("Strategy", "rounded corners (G64)",
                     fmt::format("{} has no word for them: use constant feed.", control_.title));
  if (t == 490 && (tcp_ || pending_tcp_)) return true;
  if (t >= 540 && t <= 593 && control_.meaning('G', t) == nullptr) refuse_offset(t);
  return (is_cycle(t) && !control_.can.cycles) || control_.meaning('G', t) != nullptr;
}

void Writer::refuse_offset(int tenths) const {
  std::string offsets;
  for (const CodeWord& word : control_.codes)
    if (word.letter == 'G' && word.means >= 540 && word.means <= 593 && word.means != 541)
      offsets += (offsets.empty() ? "" : ", ") + code_text('G', word.means);
  throw InputError("Fixtures", code_text('G', tenths),
                   fmt::format("{} has no such work offset: choose {} in the job's setup.",
                               control_.title, offsets));
}

/// The letters that a word may have beside it.
LetterSet Writer::letters_of(const PathBlock& block, const BlockCode& code) const {
  if (!known(block, code))
    refuse_block(block,
                 fmt::format("{} cannot be posted for {}: {}", code_text(code.letter, code.tenths),
                             control_.title, why_not_posted(code.letter, code.tenths)));
  const CodeWord* word = control_.meaning(code.letter, code.tenths);
  LetterSet takes = word ? letter_set(word->takes) : 0;
  if (code.letter != 'G') return takes;
  if (code.tenths == 330) takes |= letter_set("XYZABCK");
  if (code.tenths == 640) takes |= rounding_letters(control_, was_own_);
  if (code.tenths == 434) takes |= letter_set("H");
  if (code.tenths == 20 || code.tenths == 30) takes |= letter_set(kArcLetters);
  if (is_cycle(code.tenths)) takes |= letter_set(cycle_letters(code.tenths));
  return takes;
}

void Writer::require_words(const PathBlock& block) {
  LetterSet takes = kAlways;
  for (std::size_t i = 0; i < block.count; ++i) {
    const BlockCode& code = block.codes[i];
    const bool move = code.letter == 'G' && (code.tenths == 0 || code.tenths == 10);
    LetterSet& kept = move_letters_[move && code.tenths == 10];
    if (!move)
      takes |= letters_of(block, code);
    else
      takes |= kept = kept ? kept : letters_of(block, code);
  }
  if (const LetterSet lost = block.letters & ~takes) {
    if (block.count == 0) refuse_block(block, "begin the line by its G word, such as G1.");
    refuse_block(block,
                 fmt::format("{} has no word {} there: it cannot be posted for it, take it out.",
                             control_.title, first_letter(lost)));
  }
}

/// S, T or F without a G or M word.
void Writer::lone_words(const PathBlock& block) {
  if (block.gives('F') && block.get('F') > 0.0) feed_ = 60.0 * block.get('F');
  if (block.gives('T')) {
    selected_ = static_cast<int>(block.get('T'));
    out_.line(filled(control_.texts.preselect, "tool", std::to_string(selected_)));
  }
  if (block.gives('S')) {
    speed_ = block.get('S');
    out_.line(filled(control_.texts.speed, "speed", short_number(speed_)));
  }
}

void Writer::machine_word(const PathBlock& block, int tenths) {
  if (tenths == 30 || tenths == 40) {
    if (block.gives('S')) speed_ = block.get('S');
    return start_spindle(tenths / 10);
  }
  if (tenths == 60) return tool_change(block);
  if (tenths == 4280 || tenths == number_of_m(style_.tcp_on)) return tcp(true);
  if (tenths == 4290 || tenths == number_of_m(style_.tcp_off)) return tcp(false);
  if (tenths == number_of_m(control_.texts.tcp_on)) return tcp(true);
  if (tenths == number_of_m(control_.texts.tcp_off)) return tcp(false);
  const CodeWord* word = control_.meaning('M', tenths);
  std::string text = code_text('M', word ? word->own : tenths);
  for (char letter = 'A'; letter <= 'Z'; ++letter)
    if (word && block.gives(letter) && word->takes.find(letter) != std::string_view::npos)
      text += fmt::format(" {}{}", letter, short_number(block.get(letter)));
  out_.line(text);
}

void Writer::start_spindle(int sense) {
  const std::string speed = short_number(speed_);
  if (pending_tool_)
    call_tool(" S" + speed);
  else if (control_.texts.spindle.find("{speed}") == std::string::npos)  // it has a word of its own
    call_tool(speed);
  out_.line(filled(filled(control_.texts.spindle, "speed", speed), "sense", std::to_string(sense)));
}

/// A tool call that has waited for its speed, which FreeCAD gives later; without a change it sets the speed alone.
void Writer::call_tool(const std::string& speed) {
  if (pending_tool_)
    out_.lines(
        filled(filled(control_.texts.tool_change, "tool", std::to_string(tool_)), "speed", speed));
  else
    out_.line(filled(control_.texts.speed, "speed", speed));
  pending_tool_ = false;
  out_.forget();
}

/// TCP off, retract, stop, change; the spindle starts after it.
void Writer::tool_change(const PathBlock& block) {
  tcp(false);
  retract();
  tool_ = block.gives('T') ? static_cast<int>(block.get('T')) : selected_;
  called_ = true;
  fresh_ = control_.can.across_then_down;
  across_ = other_length_ = false;
  pending_length_ = control_.can.length_word && style_.tool_length;
  pending_tool_ = control_.texts.tool_change.find("{speed}") != std::string::npos;
  if (pending_tool_) return;
  out_.lines(filled(control_.texts.tool_change, "tool", std::to_string(tool_)));
  out_.forget();
}

void Writer::tcp(bool on) {
  pending_tcp_ = on && !tcp_;
  if (!on) switch_tcp(false);
}

/// TCP comes on when the rotary axes have been put where the first move wants them; on some controls it takes the
/// tool length with it, and ends it.
void Writer::switch_tcp(bool on) {
  if (on == tcp_) return;
  tcp_ = on;
  if (on && control_.can.tcp_brings_length) pending_length_ = false;
  if (on) length();
  if (on) tcp_used_ = true;
  if (!on && !style_.smoothing_off.empty()) out_.lines(style_.smoothing_off);
  const std::string& machine = on ? style_.tcp_on : style_.tcp_off;
  const std::string& own = on ? control_.texts.tcp_on : control_.texts.tcp_off;
  out_.lines(filled(machine.empty() ? own : machine, "tool", std::to_string(tool_)));
  if (on && !style_.smoothing_on.empty()) out_.lines(style_.smoothing_on);
  if (!on && control_.can.tcp_off_ends_length) pending_length_ = style_.tool_length;
  out_.forget();
}

void Writer::length() {
  if (pending_length_) out_.line(fmt::format("G43 H{}", tool_));
  pending_length_ = false;
}

void Writer::feed_mode(bool inverse) {
  if (inverse != inverse_ && control_.can.inverse_time)
    out_.line(code_text('G', inverse ? 930 : 940));
  inverse_ = inverse;
}

void Writer::distance(bool relative) {
  if (relative && control_.can.form == BlockForm::PlainText) return;
  out_.line(code_text('G', relative ? 910 : 900));
  relative_ = relative;
  out_.forget();
}

void Writer::preparatory(const PathBlock& block, int tenths) {
  if (tenths == 930 || tenths == 940) return feed_mode(tenths == 930);
  if (tenths == 434) return tcp(true);
  if (tenths == 490 && (tcp_ || pending_tcp_)) return tcp(false);
  if (tenths == 610) {
    const CodeWord* word = control_.meaning('G', 610);
    return path_mode(control_.texts.path_mode.empty() ? "" : code_text('G', word->own));
  }
  if (tenths == 640) {
    const bool within =
        block.gives('P') && control_.texts.rounding.find("{value}") != std::string::npos;
    const std::string merging = block.gives('Q') ? " Q" + short_number(block.get('Q')) : "";
    if (within)
      return path_mode(filled(filled(control_.texts.rounding, "merging", merging), "value",
                              fmt::format("{:.6f}", block.get('P'))));
    return path_mode(control_.texts.path_mode.empty() ? "" : "G64");
  }
  if (tenths == 40) {
    if (!block.gives('P') || block.get('P') < 0.0)
      refuse_block(block, "G4 needs its P in seconds, not less than 0.");
    return dwell(block.get('P'));
  }
  if (tenths == 980 || tenths == 990) {
    to_initial_ = tenths == 980;
    if (!control_.can.cycles) return;
  }
  if (tenths == 170 || tenths == 180 || tenths == 190)
    plane_ = tenths == 170 ? ArcPlane::XY : tenths == 180 ? ArcPlane::ZX : ArcPlane::YZ;
  if (tenths == 800) in_cycle_ = false;
  state_word(block, tenths);
}

/// A word that holds from here on, in the control's own number, with its other words.
void Writer::state_word(const PathBlock& block, int tenths) {
  const CodeWord* word = control_.meaning('G', tenths);
  if (word->implied) return;
  if (tenths == 910) return distance(true);
  if (tenths == 900 && relative_) return distance(false);
  if (tenths == 490 || tenths == 430) pending_length_ = false;
  if (tenths == 490 || tenths == 430)
    other_length_ = tenths == 490 || (block.gives('H') && block.get('H') != tool_);
  std::string text = code_text('G', word->own);
  for (char letter = 'A'; letter <= 'Z'; ++letter)
    if (block.gives(letter) && word->takes.find(letter) != std::string_view::npos)
      text += fmt::format(" {}{}", letter, short_number(block.get(letter)));
  out_.line(text);
  if (word->group == WordGroup::Offset) {
    out_.forget();
    known_[0] = known_[1] = known_[2] = false;  // in the new coordinates
  }
  out_.forget_word();
}

void Writer::path_mode(const std::string& word) {
  mode_said_ = mode_said_ || !word.empty();
  if (word.empty() || word == path_mode_) return;
  path_mode_ = word;
  out_.line(word);
  out_.forget_word();
}

void Writer::dwell(double seconds) {
  const FixedTexts& texts = control_.texts;
  const std::string value =
      fmt::format("{:.{}f}", seconds * texts.dwell_units, texts.dwell_decimals);
  if (texts.dwell.empty())
    out_.line(fmt::format("G4 {}{}", texts.dwell_letter, value));
  else
    out_.lines(filled(texts.dwell, "value", value));
  out_.forget_word();
}

}  // namespace patchmill::gcode

// Every control's table: what the writer puts down is what the reader finds, word by word; what one of them does
// not know, neither does the other. Words and numbers as the controls' public documentation has them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/controls/control.h"
#include "patchmill/gcode/gcode_reader.h"
#include "patchmill/gcode/program_writer.h"
#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::gcode {
namespace {

const Tool kTool{1.0, 2};
const std::string kBegin = "M6 T1\nM3 S600\nG0 X0 Y0 Z20\nG0 X1 Y0 Z20\nG1 X0 F10\n";

ProgramStyle style_of(const Control& control, int precision = 4) {
  ProgramStyle style;
  style.control = &control;
  style.precision = precision;
  return style;
}

std::string written(const Control& control, const std::string& path) {
  return write_program({kBegin + path + "\n"}, style_of(control));
}
bool writes(const Control& control, const std::string& path) {
  try {
    written(control, path);
    return true;
  } catch (const InputError&) {
    return false;
  }
}
bool reads(const Control& control, const std::string& block) {
  try {
    program_lines(block, control);
    return true;
  } catch (const InputError& error) {
    EXPECT_EQ(error.property().rfind("G-code line ", 0), 0u) << error.what();
    return false;
  }
}

// A value for each letter that a control would take there.
double value_of(char letter) {
  switch (letter) {
    case 'Z':
      return 2.5;
    case 'R':
      return 7.25;
    case 'F':
      return 4.5;
    case 'H':
    case 'P':
    case 'E':
    case 'L':
      return 1.0;
    default:
      return 3.0 + 0.25 * (letter - 'A');
  }
}
// What the words say of an arc must be an arc.
std::string letters_of(const CodeWord& word) {
  if (word.letter == 'G' && (word.means == 20 || word.means == 30)) return "XYIJF";
  std::string letters(word.takes);  // F of a rapid is FreeCAD's own
  if (word.means == 330 || (word.letter == 'G' && word.means == 0))
    letters.erase(std::remove(letters.begin(), letters.end(), 'F'), letters.end());
  letters.erase(std::remove(letters.begin(), letters.end(), word.letter == 'G' ? 'L' : '-'),
                letters.end());
  return letters;
}
double path_value(const CodeWord& word, char letter) {
  if (word.letter == 'G' &&
      (word.means == 20 || word.means == 30))  // a quarter about X3 Y0, or three of them
    return letter == 'X' || letter == 'I' ? 3.0 : letter == 'Y' ? 3.0 : letter == 'J' ? 0.0 : 4.5;
  return value_of(letter);
}

bool said(const std::vector<ProgramLine>& lines, const CodeWord& word, const std::string& letters) {
  for (const ProgramLine& line : lines) {
    bool here = false;
    std::size_t found = 0;
    for (const GcodeWord& w : line.words) {
      here = here || (w.letter == word.letter && std::lround(w.value * 10.0) == word.means);
      if (letters.find(w.letter) == std::string::npos) continue;
      const double unit = w.letter == 'F' && word.letter == 'G' && word.means != 330 ? 60.0 : 1.0;
      found += std::abs(w.value - unit * path_value(word, w.letter)) < 1e-4;
    }
    if (here && found == letters.size()) return true;
  }
  return false;
}

TEST(Controls, EveryWordOfATableIsReadAsItIsWritten) {
  for (const Control* control : controls()) {
    int tried = 0;
    for (const CodeWord& word : control->codes) {
      const bool ends = word.letter == 'M' && (word.means == 20 || word.means == 300);
      const bool inches = word.letter == 'G' && word.means == 200;
      const bool tcp = word.means == 434 || word.means == 4280 || word.means == 4290 ||
                       word.means == 1280 || word.means == 1290;
      if (word.own < 0 || word.forbidden || ends || inches || tcp || word.own == 710) continue;
      if (control->can.form == BlockForm::PlainText && word.letter == 'G') continue;  // below
      std::string letters = letters_of(word);
      if (word.means == 610 && word.letter == 'G') letters.clear();
      std::string path = code_text(word.letter, word.means);
      if (word.means == 530 && word.letter == 'G') path += " G0 Z1";
      for (const char letter : letters)
        path += fmt::format(" {}{}", letter, path_value(word, letter));
      if (word.means == 330) path += letters.find('K') == std::string::npos ? " K0.5" : "";
      if (word.means == 330 && control->can.lead == LeadRule::LongestAxis) letters = "XYZ";
      if (word.means == 60) letters.clear();
      const std::string program = written(*control, path);
      EXPECT_TRUE(said(program_lines(program, *control), word, letters))
          << control->name << ": " << path << "\n"
          << program;
      ++tried;
    }
    EXPECT_GE(tried, 9) << control->name;
  }
}

TEST(Controls, WhatIsWrittenIsReadAndWhatIsNotKnownIsRefusedByBoth) {
  for (const Control* control : controls())
    for (const char letter : {'G', 'M'})
      for (int tenths = 0; tenths < 2500; ++tenths) {
        const std::string text = code_text(letter, tenths);
        const std::string path = text + (tenths == 40 && letter == 'G' ? " P1" : "");
        if (!writes(*control, path)) continue;
        EXPECT_TRUE(reads(*control, written(*control, path))) << control->name << " " << text;
        const bool known = control->meaning(letter, tenths) != nullptr;
        const bool builder = letter == 'M' && tenths % 10 == 0 && control->can.builder_words;
        const bool tcp = tenths == 434 || tenths == 4280 || tenths == 4290;
        EXPECT_TRUE(known || builder || tcp) << control->name << " " << text;
      }
}

TEST(Controls, NumbersThatOnlyLookLikeAWordAreNone) {
  for (const Control* control : controls()) {
    const bool plain = control->can.form == BlockForm::PlainText;
    for (const char* bad : {"M4294967299", "M3.5", "M-3", "M1e1"})
      EXPECT_FALSE(reads(*control, bad)) << control->name << " " << bad;
    if (plain) continue;
    for (const char* bad :
         {"G0.04",      "G0.99",    "G4294967297", "G-1",          "G1 X1.0 X2.0", "G0 G1 X1.0",
          "G90 G91",    "G17 G18",  "M3 M4",       "G54 G55",      "S1000 S2000",  "S inf",
          "Sinf",       "Snan",     "G1 Xnan",     "G1 X1.0 E5.0", "G40 H1",       "G1 X1.0 D2",
          "G4 X1.0 P1", "G1 X1..0", "G1 X--1.0",   "G38.2 Z1.0",   "G999",         "G1 X1.0 %",
          "G10 L2 P1",  "G92 X0.0", "G76",         "O100 call",    "#1=3",         "G1 X[1+2]"}) {
      EXPECT_FALSE(reads(*control, bad)) << control->name << " " << bad;
    }
  }
  for (const char* bad : {"G1 X1", "G4 P0.5", "G4 X0.5", "M98 P1", "G82 X1. Y1. Z1. R2. P0.5"})
    EXPECT_FALSE(reads(control_of("fanuc"), bad))
        << bad;  // a length without a point would be 0.001 mm
  for (const char* bad :
       {"G4 P500", "G59.1", "G507", "TRAORI(2)", "M17", "G43 H1", "R1=5", "MCALL"})
    EXPECT_FALSE(reads(control_of("siemens"), bad)) << bad;
  // R parameters, subprograms, repeats and auxiliary functions there, not radii and cycles
  for (const char* bad : {"R3970", "R3970 X1", "G2 X1 Y1 R5", "L12", "P5", "Q1", "U1", "G1 X1 R5"})
    EXPECT_FALSE(reads(control_of("siemens"), bad)) << bad;
  for (const Control* control : controls())
    if (control->meaning('G', 810) == nullptr) {
      EXPECT_FALSE(reads(*control, "Q2.5")) << control->name;
    }
}

// Spindle turns of all timed moves of a program, at 600 rpm.
double turns_of(const Control& control, const std::string& program) {
  double turns = 0.0;
  for (const ProgramSection& s : read_gcode(program, kTool, {&control, true}).sections)
    for (const Move& m : s.path.moves) turns += std::isnan(m.turns) ? 0.0 : m.turns;
  return turns;
}

TEST(Controls, ADwellLastsAsLongAsItSays) {
  const auto lasts = [](const Control& control, const std::string& dwell) {
    const std::string spindle =
        control.can.form == BlockForm::PlainText ? "TOOL CALL 1 Z S600\nM3\n" : "S600 M3\n";
    return turns_of(control, spindle + dwell) / 10.0;
  };
  EXPECT_DOUBLE_EQ(lasts(linuxcnc(), "G4 P0.5\n"), 0.5);
  EXPECT_DOUBLE_EQ(lasts(control_of("grblhal"), "G4 P0.5\n"), 0.5);
  EXPECT_DOUBLE_EQ(lasts(control_of("fanuc"), "G4 P500\n"), 0.5);
  EXPECT_DOUBLE_EQ(lasts(control_of("siemens"), "N10 G4 F0.5\n"), 0.5);
  EXPECT_DOUBLE_EQ(
      lasts(control_of("heidenhain"), "7 CYCL DEF 9.0 DWELL TIME\n8 CYCL DEF 9.1 DWELL 0.5\n"),
      0.5);
  EXPECT_DOUBLE_EQ(
      lasts(control_of("heidenhain"), "CYCL DEF 9.0 VERWEILZEIT\nCYCL DEF 9.1 V.ZEIT 0.5\n"), 0.5);
  EXPECT_DOUBLE_EQ(lasts(control_of("heidenhain"), "CYCL DEF 9.1 V.ZEIT0.5\n"), 0.5);
  for (const Control* control : controls()) {
    const double without = turns_of(*control, written(*control, ""));
    EXPECT_NEAR(turns_of(*control, written(*control, "G4 P0.5")) - without, 5.0, 1e-9)
        << control->name;
  }
  for (const auto& [control, block] : {std::pair{&linuxcnc(), "\nG4 P0.500\n"},
                                       {&control_of("fanuc"), "\nG4 P500\n"},
                                       {&control_of("siemens"), "\nG4 F0.500\n"},
                                       {&control_of("heidenhain"), " DWELL 0.500\n"}})
    EXPECT_NE(written(*control, "G4 P0.5").find(block), std::string::npos) << control->name;
}

TEST(Controls, WorkOffsetsAreKeptOrRefused) {
  for (const Control* control : controls())
    for (const int tenths : {540, 550, 560, 570, 580, 590, 591, 592, 593}) {
      const std::string offset = code_text('G', tenths);
      if (!writes(*control, offset + "\nG0 X1 Y1 Z1\nG1 X2")) {
        EXPECT_TRUE(control->meaning('G', tenths) == nullptr) << control->name << offset;
        continue;
      }
      const Program p =
          read_gcode(written(*control, offset + "\nG0 X1 Y1 Z1\nG1 X2"), kTool, {control, true});
      if (control->can.form == BlockForm::PlainText) {
        EXPECT_EQ(offset, "G54");  // the preset is the operator's
        continue;
      }
      EXPECT_EQ(p.sections.back().offset, offset) << control->name;
    }
  EXPECT_TRUE(writes(control_of("fanuc"), "G54.1 P3"));
  EXPECT_EQ(read_gcode("G54.1 P3\nG0 X1. Y1. Z1.\n", kTool, {&control_of("fanuc"), true})
                .sections[0]
                .offset,
            "G54.1 P3");
  EXPECT_EQ(
      read_gcode("G505\nG0 X1 Y1 Z1\n", kTool, {&control_of("siemens"), true}).sections[0].offset,
      "G58");
}

TEST(Controls, WordsOfOtherOperationsAreKeptOrRefused) {
  struct Case {
    const char *path, *in_program;
  };
  for (const Case& c : std::initializer_list<Case>{{"G53 G0 Z0", "G53 G0 Z0.0000"},
                                                   {"G0 G53 Z0", "G53 G0 Z0.0000"},
                                                   {"G53\nG0 Z0", "G53 G0 Z0.0000"},
                                                   {"G91 G0 Z5", "G91\nG0 Z5.0000"},
                                                   {"M19 R45", "M19 R45"},
                                                   {"M62 P3", "M62 P3"},
                                                   {"M66 L3 P0 Q5", "M66 L3 P0 Q5"},
                                                   {"M68 E0 Q2.5", "M68 E0 Q2.5"},
                                                   {"M101 P1 Q2", "M101 P1 Q2"},
                                                   {"G43 H5", "G43 H5"},
                                                   {"G0 U5", "G0 U5.0000"},
                                                   {"S750.5", "S750.5"},
                                                   {"T4", "T4"},
                                                   {"M3 M8 S100", "M3 S100\nM8"}})
    for (const Control* control : controls()) {
      if (!writes(*control, c.path)) {
        EXPECT_NE(control, &linuxcnc()) << c.path;
        continue;
      }
      const std::string program = written(*control, c.path);
      if (control == &linuxcnc()) {
        EXPECT_NE(program.find(c.in_program), std::string::npos) << c.path << "\n" << program;
      }
      EXPECT_TRUE(reads(*control, program)) << control->name << "\n" << program;
    }
  for (const char* lost : {"G20", "M2", "M30", "G92 X0", "G10 L2 P1 X0", "G95", "G38.2 Z1",
                           "G1 X1 E5", "G53 G2 X1 Y1 I1", "G53\nM8", "G54.1", "M98 P1", "G0 X1 D4"})
    EXPECT_FALSE(writes(linuxcnc(), lost)) << lost;
  EXPECT_FALSE(writes(control_of("grblhal"), "G43.4 H1"));
}

TEST(Controls, AreFoundByName) {
  std::set<std::string_view> names;
  for (const Control* control : controls()) {
    EXPECT_EQ(&control_of(control->name), control);
    names.insert(control->name);
  }
  EXPECT_EQ(names.size(), controls().size());
  EXPECT_THROW(control_of("sinumerik"), InputError);
}

}  // namespace
}  // namespace patchmill::gcode

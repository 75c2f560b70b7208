// Units of what a program says beside its moves: dwells, and the feed of arcs that are passed through.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/gcode_reader.h"
#include "patchmill/gcode/program_writer.h"

#include <cmath>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

namespace patchmill::gcode {
namespace {

std::string written(const Control& control, const std::string& moves) {
  ProgramStyle style;
  style.control = &control;
  return write_program({"M6 T3\nM3 S1000\nG0 X0 Y0 Z5\nG1 X1 F10\n" + moves}, style);
}

// The number after the last `word` of the text; NaN if there is none.
double number_after(const std::string& text, const std::string& word) {
  const std::size_t at = text.rfind(word);
  return at == std::string::npos ? std::nan("") : std::strtod(&text[at + word.size()], nullptr);
}

TEST(ProgramUnits, ADwellIsWrittenInTheUnitOfTheControl) {
  const std::string dwell = "G4 P1.5\n";  // seconds
  EXPECT_EQ(number_after(written(control_of("linuxcnc"), dwell), "G4 P"), 1.5);
  EXPECT_EQ(number_after(written(control_of("fanuc"), dwell), "G4 P"), 1500.0);
  EXPECT_EQ(number_after(written(control_of("siemens"), dwell), "G4 F"), 1.5);
  EXPECT_EQ(number_after(written(control_of("heidenhain"), dwell), "9.1 DWELL "), 1.5);
}

TEST(ProgramUnits, ADwellIsReadBackAsItsTurns) {
  for (const Control* control : controls()) {
    ReadOptions options;
    options.control = control;
    const Program program = read_gcode(written(*control, "G4 P1.5\n"), {1.0, 2}, options);
    ASSERT_EQ(program.sections.size(), 1u);
    double turns = 0.0;
    for (const Move& move : program.sections[0].path.moves)
      if (move.kind == MoveKind::Link) turns += move.turns;
    EXPECT_NEAR(turns, 1.5 * 1000.0 / 60.0, 1e-9) << control->title;
  }
}

TEST(ProgramUnits, AnArcThatIsPassedThroughKeepsItsFeed) {
  for (const char* control : {"linuxcnc", "fanuc"}) {
    const std::string text = written(control_of(control), "G2 X2 Y1 I1 J0 F7.25\n");  // mm/s
    const std::size_t arc = text.find("G2 ");
    ASSERT_NE(arc, std::string::npos);
    EXPECT_NEAR(number_after(text.substr(arc, text.find('\n', arc) - arc), "F"), 435.0, 1e-6);
  }
}

TEST(ProgramUnits, AFeedAloneInItsBlockIsThatOfTheMovesAfterIt) {
  for (const Control* control : controls()) {
    const std::string text = written(*control, "F7.25\nG1 X3\nG1 X5\n");  // mm/s
    EXPECT_NEAR(number_after(text, "F"), 435.0, 1e-6) << control->title << "\n" << text;
  }
}

TEST(ProgramUnits, AMoveOfRotaryAxesAloneTakesItsTimeInPlainText) {
  const std::string moves =
      "G43.4 H3\nG0 X1 Y0 Z5 A0 C0\nG93\nG1 X1 Y0 Z5 A5 C0 F2\nG94\n";  // half a second
  EXPECT_NEAR(number_after(written(control_of("heidenhain"), moves), "FT"), 0.5, 1e-9);
}

}  // namespace
}  // namespace patchmill::gcode

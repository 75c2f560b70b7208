// What Haas mills have otherwise than the controls that they resemble, as public summaries of their G-codes say.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/controls/control.h"
#include "patchmill/gcode/gcode_reader.h"
#include "patchmill/gcode/program_writer.h"
#include "patchmill/geometry/error.h"

#include <cmath>

#include <gtest/gtest.h>

namespace patchmill::gcode {
namespace {

const Tool kTool{1.0, 2};
const std::string kBegin = "M6 T1\nM3 S600\nG0 X0 Y0 Z20\nG0 X1 Y0 Z20\nG1 X0 F10\n";

std::string written(const std::string& path) {
  ProgramStyle style;
  style.control = &control_of("haas");
  return write_program({kBegin + path + "\n"}, style);
}

// Seconds of a dwell, by the turns of a spindle at 600 rpm.
double waits(const std::string& dwell) {
  double turns = 0.0;
  for (const ProgramSection& s :
       read_gcode("S600 M3\n" + dwell, kTool, {&control_of("haas"), true}).sections)
    for (const Move& m : s.path.moves) turns += std::isnan(m.turns) ? 0.0 : m.turns;
  return turns / 10.0;
}

TEST(Haas, DwellsAreSecondsWithAPointAndMillisecondsWithoutOne) {
  EXPECT_DOUBLE_EQ(waits("G4 P2.\n"), 2.0);
  EXPECT_DOUBLE_EQ(waits("G4 P0.5\n"), 0.5);
  EXPECT_DOUBLE_EQ(waits("G4 P500\n"), 0.5);
  EXPECT_NE(written("G4 P2").find("\nG4 P2.000\n"), std::string::npos);  // P2 would be 2 ms
  const std::string drilled = written("G98 G82 X1 Y1 Z-2 R2 P2 F1\nG80");
  EXPECT_NE(drilled.find(" P2.000"), std::string::npos) << drilled;
}

TEST(Haas, TcpAndFurtherOffsetsHaveTheirOwnWords) {
  const std::vector<ProgramLine> lines =
      program_lines("G234 H1\nG154 P3\nG49\n", control_of("haas"));
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_DOUBLE_EQ(lines[0].words[0].value, 43.4);
  EXPECT_DOUBLE_EQ(lines[1].words[0].value, 54.1);
  EXPECT_DOUBLE_EQ(lines[1].words[1].value, 3.0);  // a number, no time
  EXPECT_NE(written("G54.1 P3\nG0 X1 Y1 Z1").find("\nG154 P3\n"), std::string::npos);
}

TEST(Haas, WhatIsAnotherThingThereIsRefused) {
  for (const char* bad : {"G33 Z1. K1.", "M7", "M98 P1", "G43.4 H1", "G54.1 P1", "G1 X1"})
    EXPECT_THROW(program_lines(bad, control_of("haas")), InputError) << bad;
  EXPECT_THROW(written("M7"), InputError);
  EXPECT_NO_THROW(written("M8"));
}

}  // namespace
}  // namespace patchmill::gcode

// What an operation leaves to the next one beside turned axes: the tool's length, the plane; and arcs that name their
// centre alone.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/gcode_reader.h"
#include "patchmill/gcode/program_writer.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace patchmill::gcode {
namespace {

const Tool kTool{1.0, 2};
constexpr double kPi = 3.14159265358979323846;
const std::string kBegin = "M6 T1\nM3 S600\nG0 X0 Y0 Z20\nG0 X1 Y0 Z20\n";

ProgramStyle style_of(const Control& control) {
  ProgramStyle style;
  style.control = &control;
  style.precision = 3;
  return style;
}

double cut_length(const std::string& program) {
  double length = 0.0;
  for (const ProgramSection& s : read_gcode(program, kTool).sections) {
    Vec3 from = s.path.start.tip;
    for (const Move& m : s.path.moves) {
      if (m.kind == MoveKind::Cut) length += (m.end.tip - from).norm();
      from = m.end.tip;
    }
  }
  return length;
}

TEST(LeftBehind, TheToolsLengthIsThatOfTheNextOperationsTool) {
  const std::string cut = "G0 X5 Y5 Z9\nG1 Z8 F5\n";
  for (const Control* control : controls()) {
    if (!control->can.length_word) continue;
    const auto lengths_after = [&](const std::string& said, bool together) {
      const std::string first = kBegin + said;
      const std::string text = together ? write_program({first + cut}, style_of(*control))
                                        : write_program({first, cut}, style_of(*control));
      return text.find("G43 H1", text.find("\n" + said)) != std::string::npos;
    };
    for (const std::string said : {"G49\n", "G43 H5\n"}) {
      EXPECT_TRUE(lengths_after(said, false)) << control->name << said;
      EXPECT_FALSE(lengths_after(said, true)) << control->name << said;  // as the path says
    }
    const std::string own = kBegin + "G43 H1\n";
    EXPECT_EQ(write_program({own, cut}, style_of(*control)),
              write_program({own + cut}, style_of(*control)));
  }
}

TEST(LeftBehind, ThePlaneIsXY) {
  const std::string text = write_program({kBegin + "G18\n", "G0 X5 Y5 Z9\n"}, style_of(linuxcnc()));
  EXPECT_NE(text.find("\nG18\nG17\n"), std::string::npos) << text;
}

TEST(LeftBehind, AFullCircleNeedsNoEnd) {
  const std::string begin = "G17 G21 G90 G94\nM3 S600\nG0 X0 Y0 Z0\nG1 X1 F120\n";
  EXPECT_NEAR(cut_length(begin + "G2 I-1 J0\n"), 1.0 + 2.0 * kPi, 1e-2);
  EXPECT_NEAR(cut_length(begin + "G3 X1 Y0 I-1\n"), 1.0 + 2.0 * kPi, 1e-2);
  EXPECT_NEAR(cut_length(begin + "G2 I-1\nI-1\n"), 1.0 + 4.0 * kPi, 1e-2);
  const std::string path = kBegin + "G0 Z0\nG2 I-1 J0 F2\n";
  EXPECT_NEAR(cut_length(write_program({path}, style_of(linuxcnc()))), 2.0 * kPi, 1e-2);
}

}  // namespace
}  // namespace patchmill::gcode

// Programs of every control, read back by its reader: places to the last decimal, times, leads.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/program_writer.h"

#include "patchmill/gcode/gcode_reader.h"
#include "patchmill/gcode/program_text.h"
#include "patchmill/geometry/error.h"

#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace patchmill::gcode {
namespace {

const Tool kTool{1.0, 2};
ProgramStyle style_of(const Control& control, int precision = 4) {
  ProgramStyle style;
  style.control = &control;
  style.precision = precision;
  style.header = {"Part: plate (left)", "Phase zero: flute 1 at X"};
  return style;
}

struct Told {
  std::vector<Vec3> points;
  std::vector<std::array<double, 3>> degrees;
  std::vector<double> seconds;  // of each timed move
};

enum class How { PerMinute, Inverse, Locked };

// FreeCAD's text of random moves, and what it tells.
std::string internal_text(How how, bool rotary, Told& told, unsigned seed, int count = 400) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-60.0, 60.0), angle(-200.0, 200.0), time(0.02, 0.4);
  std::string text = "(TC: ball)\nM6 T3\nM3 S1000\nG54\nG0 X0 Y0 Z50\n";
  text += rotary ? "G43.4 H3\nG0 X1.5 Y0 Z50 A0 C0\n" : "G0 X1.5 Y0 Z50\n";
  if (how == How::Inverse) text += "G93\n";
  text += "G61\n";
  Vec3 at(1.5, 0.0, 50.0);
  for (int i = 0; i < count; ++i) {
    const Vec3 p(std::round(place(random) * 1e4) / 1e4, std::round(place(random) * 1e4) / 1e4,
                 std::round(place(random) * 1e4) / 1e4);
    const double a = std::round(angle(random) * 1e4) / 1e4,
                 c = std::round(3.0 * angle(random) * 1e4) / 1e4;
    const double seconds = time(random);
    text += how == How::Locked ? "G33" : "G1";
    text += fmt::format(" X{:.6f} Y{:.6f} Z{:.6f}", p.x(), p.y(), p.z());
    if (rotary) text += fmt::format(" A{:.6f} C{:.6f}", a, c);
    if (how == How::PerMinute) text += fmt::format(" F{:.6f}", (p - at).norm() / seconds);
    if (how == How::Inverse) text += fmt::format(" F{:.6f}", 1.0 / seconds);
    if (how == How::Locked)
      text += fmt::format(" K{:.6f}", (p - at).norm() / (seconds * 1000.0 / 60.0));
    text += "\n";
    at = p;
    told.points.push_back(p);
    told.degrees.push_back({rotary ? a : 0.0, 0.0, rotary ? c : 0.0});
    told.seconds.push_back(seconds);
  }
  if (how == How::Inverse) text += "G94\n";
  return text + "G0 Z60\n";
}

void expect_read_back(const Control& control, How how, bool rotary, const ProgramStyle& style) {
  Told told;
  const std::string text = write_program({internal_text(how, rotary, told, 7)}, style);
  const Program program = read_gcode(text, kTool, {&control, true});
  ASSERT_FALSE(program.sections.empty()) << text.substr(0, 500);
  const ProgramSection& section = program.sections.back();
  EXPECT_EQ(section.tool_number, 3) << control.name;
  EXPECT_DOUBLE_EQ(section.path.spindle.speed, 1000.0 / 60.0) << control.name;
  std::size_t k = 0;
  for (std::size_t i = 0; i < section.path.moves.size(); ++i) {
    const Move& move = section.path.moves[i];
    if (move.kind == MoveKind::Rapid) continue;
    ASSERT_LT(k, told.points.size());
    const double half = 0.5 * std::pow(10.0, -style.precision) + 1e-12;
    ASSERT_LE((move.end.tip - told.points[k]).cwiseAbs().maxCoeff(), half) << control.name;
    for (std::size_t j = 0; j < 3; ++j)
      ASSERT_NEAR(Angle::radians(section.angles[i + 1][j]).degrees(), told.degrees[k][j], half)
          << control.name;
    ASSERT_EQ(section.tcp[i], rotary) << control.name;
    const double seconds = duration(move, section.path.spindle);
    ASSERT_NEAR(seconds, told.seconds[k], 2e-4 * told.seconds[k]) << control.name << " " << i;
    ++k;
  }
  EXPECT_EQ(k, told.points.size()) << control.name;
}

TEST(ProgramWriter, ReadsBackForEveryControl) {
  for (const Control* control : controls())
    for (const How how : {How::PerMinute, How::Inverse})
      for (const bool rotary : {false, true})
        for (const bool modal : {false, true}) {
          if (rotary && !control->can.tcp) continue;
          ProgramStyle style = style_of(*control);
          style.modal = style.axis_modal = modal;
          style.line_numbers = modal;
          expect_read_back(*control, how, rotary, style);
        }
}

TEST(ProgramWriter, LeadsReadBack) {
  expect_read_back(linuxcnc(), How::Locked, false, style_of(linuxcnc()));
  expect_read_back(linuxcnc(), How::Locked, true, style_of(linuxcnc()));
  expect_read_back(control_of("fanuc"), How::Locked, false, style_of(control_of("fanuc")));
  expect_read_back(control_of("siemens"), How::Locked, false, style_of(control_of("siemens")));
}

TEST(ProgramWriter, RefusesWhatAControlCannotSay) {
  Told told;
  for (const auto& [control, rotary] : {std::pair{&control_of("heidenhain"), false},
                                        {&control_of("fanuc"), true},
                                        {&control_of("siemens"), true},
                                        {&control_of("grblhal"), false}}) {
    try {
      write_program({internal_text(How::Locked, rotary, told, 3)}, style_of(*control));
      FAIL() << control->name;
    } catch (const InputError& error) {
      EXPECT_EQ(error.property(), "Strategy");
    }
  }
  EXPECT_THROW(write_program({"G93\nG1 X1\n"}, style_of(linuxcnc())), InputError);
  EXPECT_THROW(write_program({}, style_of(linuxcnc(), 9)), InputError);
}

TEST(ProgramWriter, ProgramsAsTheyAreWrittenByHand) {
  const std::string text =
      "(TC: ball)\nM6 T3\nM3 S1000\nG54\nG0 X0 Y0 Z50\nG43.4 H3\nG0 X1.5 Y0 Z50 A0 C0\nG93\nG61\n"
      "G1 X2 Y0 Z49 A1 C2 F0.5\nG1 X3 Y0 Z49 A1 C2 F0.25\nG94\nG0 Z60\n";
  ProgramStyle style = style_of(control_of("fanuc"), 3);
  style.modal = style.axis_modal = true;
  style.smoothing_on = "G05.1 Q1";
  style.smoothing_off = "G05.1 Q0";
  EXPECT_EQ(
      write_program({text}, style),
      "%\nO0001\n(PATCHMILL)\n(PART: PLATE LEFT)\n(PHASE ZERO: FLUTE 1 AT X)\nG21\n"
      "G17 G40 G49 G80 G90 G94\n(TC: BALL)\nM5\nT3 M6\nS1000 M3\nG54\n"
      "G0 X0.000 Y0.000\nG43 Z50.000 H3\nA0.000 C0.000\nG43.4 H3\nG05.1 Q1\nG0 X1.500 Y0.000\n"
      "Z50.000\nG93\nG61\nG1 X2.000 Z49.000 A1.000 C2.000 F30.000\n"
      "X3.000 F15.000\nG94\nG0 Z60.000\nG05.1 Q0\nG49\nM5\nM30\n%\n");
  EXPECT_EQ(
      write_program({text}, style_of(control_of("heidenhain"), 3)),
      "0 BEGIN PGM PATCHMILL MM\n1 ; Part: plate left\n2 ; Phase zero: flute 1 at X\n"
      "3 ; TC: ball\n4 TOOL CALL 3 Z S1000\n5 M3\n6 L X+0.000 Y+0.000 R0 FMAX\n"
      "7 L Z+50.000 FMAX\n8 L A+0.000 C+0.000 FMAX\n9 M128\n10 L X+1.500 Y+0.000 R0 FMAX\n"
      "11 L Z+50.000 FMAX\n12 L X+2.000 Z+49.000 A+1.000 C+2.000 F33.541\n13 L X+3.000 F15.000\n"
      "14 L Z+60.000 R0 FMAX\n15 M129\n16 M5\n17 M30\n18 END PGM PATCHMILL MM\n");
}

TEST(ProgramWriter, TheFirstRapidsGoAcrossAndThenDownWithTheToolsLength) {
  const std::string text = "M6 T3\nM3 S1000\nG0 X1 Y2 Z50\nG0 Z20\nG1 Z10 F5\n";
  const auto has = [&](const Control& control, const std::string& text_of_blocks) {
    return write_program({text}, style_of(control, 1)).find(text_of_blocks) != std::string::npos;
  };
  EXPECT_TRUE(has(control_of("fanuc"), "\nG0 X1.0 Y2.0\nG0 G43 Z50.0 H3\nG0 Z20.0\nG1 Z10.0 F"));
  EXPECT_TRUE(has(control_of("siemens"), "\nG0 X1.0 Y2.0\nG0 Z50.0\nG0 Z20.0\nG1 Z10.0 F"));
  EXPECT_TRUE(has(control_of("siemens"), "\nM5\nM30\n"));  // nothing changed the path mode
  // a path that begins with Z alone goes across first as well; one that feeds at once still gets its length
  const auto moved = [](const std::string& moves) {
    return write_program({"M6 T3\nM3 S1000\n" + moves}, style_of(control_of("fanuc"), 1));
  };
  EXPECT_NE(moved("G0 Z50\nG0 X1 Y2\n").find("\nG0 X1.0 Y2.0\nG0 G43 Z50.0 H3\n"),
            std::string::npos);
  EXPECT_NE(moved("G0 Z50\nG0 X1 Y2 Z40\n").find("\nG0 X1.0 Y2.0\nG0 G43 Z40.0 H3\n"),
            std::string::npos);
  EXPECT_NE(moved("G0 Z50\nG1 X1 F5\n").find("\nG0 G43 Z50.0 H3\nG1 X1.0 F"), std::string::npos);
  EXPECT_NE(moved("G0 Z50\nM8\nG0 X1\n").find("\nG0 G43 Z50.0 H3\nM8\nG0 X1.0\n"),
            std::string::npos);
  EXPECT_NE(moved("G0 X1\nG0 Z50\n").find("\nG0 X1.0\nG0 G43 Z50.0 H3\n"), std::string::npos);
  EXPECT_NE(moved("G1 X1 F5\n").find("\nG43 H3\nG1 X1.0 F"), std::string::npos);
}

TEST(ProgramWriter, AFeedInInverseTimeThatIsTheSameIsNotGivenAnew) {
  // 10 mm at F 0.723333/s is the same 434 mm/min as 1 mm at 7.23333/s, but for the last digit
  const std::string text =
      "M6 T3\nM3 S1000\nG0 X0 Y0 Z0 A0\nG93\nG1 X1 A1 F7.233333\nG1 X11 A2 F0.723333\n"
      "G1 X12 A3 F7.233400\n";
  const std::string program = write_program({text}, style_of(control_of("heidenhain"), 3));
  EXPECT_NE(program.find("X+1.000 A+1.000 F434.000\n"), std::string::npos) << program;
  EXPECT_NE(program.find("X+11.000 A+2.000\n"), std::string::npos) << program;
  EXPECT_NE(program.find("X+12.000 A+3.000 F434.004\n"), std::string::npos) << program;
}

TEST(ProgramWriter, FixedNumbers) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> value(-2000.0, 2000.0);
  for (int i = 0; i < 20000; ++i) {
    const int decimals = i % 7;
    const double v = i < 100 ? (i - 50) * 1e-4 : value(random);
    std::string mine;
    append_fixed(mine, v, decimals, false);
    std::string other = fmt::format("{:.{}f}", v, decimals);
    if (other.find_first_not_of("-0.") == std::string::npos && other[0] == '-') other.erase(0, 1);
    ASSERT_NEAR(std::stod(mine), std::stod(other), 1.001 * std::pow(10.0, -decimals)) << v;
    ASSERT_EQ(mine.size(), other.size()) << v << " " << mine << " " << other;
    ASSERT_NE(mine.substr(0, 2), "-.");
  }
  std::string zero;
  append_fixed(zero, -1e-9, 3, false);
  EXPECT_EQ(zero, "0.000");
}

}  // namespace
}  // namespace patchmill::gcode

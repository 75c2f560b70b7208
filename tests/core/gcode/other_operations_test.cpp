// Arcs, drilling cycles, relative moves and what one operation leaves to the next, for every control: where the
// tool goes and how long it takes, against closed forms.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/gcode_motion.h"
#include "patchmill/gcode/gcode_reader.h"
#include "patchmill/gcode/program_writer.h"
#include "patchmill/geometry/error.h"

#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace patchmill::gcode {
namespace {

const Tool kTool{1.0, 2};
constexpr double kPi = 3.14159265358979323846;
const std::string kBegin = "M6 T1\nM3 S600\nG0 X0 Y0 Z20\nG0 X1 Y0 Z20\n";

ProgramStyle style_of(const Control& control, int precision = 6) {
  ProgramStyle style;
  style.control = &control;
  style.precision = precision;
  return style;
}

struct Ran {
  std::vector<Vec3> ends;  // of all moves
  double turns = 0.0, length = 0.0;
  std::int64_t rapids = 0;
};
Ran run_of(const Control& control, const std::string& program) {
  Ran run;
  for (const ProgramSection& s : read_gcode(program, kTool, {&control, true}).sections) {
    Vec3 from = s.path.start.tip;
    for (const Move& m : s.path.moves) {
      run.ends.push_back(m.end.tip);
      run.turns += std::isnan(m.turns) ? 0.0 : m.turns;
      if (m.kind == MoveKind::Cut) run.length += (m.end.tip - from).norm();
      run.rapids += m.kind == MoveKind::Rapid;
      from = m.end.tip;
    }
  }
  return run;
}
std::string posted(const Control& control, const std::string& path) {
  return write_program({kBegin + path}, style_of(control));
}

TEST(OtherOperations, AnArcTakesTheTimeOfItsLength) {
  // a quarter of radius 1 about the zero, at 2 mm/s: pi/4 s, at 10 turns a second
  for (const Control* control : controls()) {
    const Ran run = run_of(*control, posted(*control, "G0 Z0\nG3 X0 Y1 Z0 I-1 J0 K0 F2\n"));
    EXPECT_NEAR(run.turns, 10.0 * kPi / 4.0, 1e-5) << control->name;
    EXPECT_NEAR(run.length, kPi / 2.0, 2e-3) << control->name;
    EXPECT_NEAR((run.ends.back() - Vec3(0, 1, 0)).norm(), 0.0, 1e-9) << control->name;
    for (std::size_t i = run.ends.size() - 10; i < run.ends.size(); ++i)
      EXPECT_NEAR(run.ends[i].norm(), 1.0, 1e-3) << control->name;
  }
  // the other way round is three quarters
  for (const Control* control : controls())
    EXPECT_NEAR(run_of(*control, posted(*control, "G0 Z0\nG2 X0 Y1 Z0 I-1 J0 F2\n")).turns,
                10.0 * kPi * 0.75, 1e-5);
}

TEST(OtherOperations, NoWordOfTheAxisAcrossStandsInAnArc) {
  const std::string program = posted(linuxcnc(), "G0 Z0\nG3 X0 Y1 Z0 I-1 J0 K0 F2\n");
  EXPECT_NE(program.find("\nG3 X0.000000 Y1.000000 I-1.000000 J0.000000 F120.000000\n"),
            std::string::npos)
      << program;
  EXPECT_NE(posted(control_of("fanuc"), "G0 Z0\nG18\nG2 X0 Z-1 I-1 K0 F2\n")
                .find("\nG2 X0.000000 Z-1.000000 I-1.000000 K0.000000 F"),
            std::string::npos);
  EXPECT_NE(posted(control_of("heidenhain"), "G0 Z0\nG3 X0 Y1 I-1 J0 F2\n")
                .find(" CC X+0.000000 Y+0.000000\n8 C X+0.000000 Y+1.000000 DR+ F120.000000\n"),
            std::string::npos)
      << posted(control_of("heidenhain"), "G0 Z0\nG3 X0 Y1 I-1 J0 F2\n");
}

TEST(OtherOperations, RandomArcsAndHelicesComeBack) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> u(-1.0, 1.0);
  for (int i = 0; i < 120; ++i) {
    const double radius = 0.5 + 5.0 * std::abs(u(random)), first = kPi * u(random);
    double turned = 0.05 + 6.2 * std::abs(u(random));
    const bool clockwise = i % 2 == 0, helix = i % 3 == 0, full = i % 10 == 0;
    if (full) turned = 2.0 * kPi;
    const Vec3 centre(10.0 * u(random), 10.0 * u(random), 0.0);
    const auto at = [&](double angle) {
      return Vec3(centre.x() + radius * std::cos(angle), centre.y() + radius * std::sin(angle),
                  0.0);
    };
    const double sign = clockwise ? -1.0 : 1.0;
    const Vec3 a = at(first);
    Vec3 b = full ? a : at(first + sign * turned);
    b.z() = helix ? -0.7 : 0.0;
    const std::string path = fmt::format(
        "G0 X{:.6f} Y{:.6f} Z0\n{} X{:.6f} Y{:.6f} Z{:.6f} I{:.6f} J{:.6f} F1.5\n", a.x(), a.y(),
        clockwise ? "G2" : "G3", b.x(), b.y(), b.z(), centre.x() - a.x(), centre.y() - a.y());
    const double length = std::hypot(radius * turned, b.z());
    for (const Control* control : controls()) {
      const Ran run = run_of(*control, posted(*control, path));
      EXPECT_NEAR(run.turns, 10.0 * length / 1.5, 2e-3 * length + 1e-3) << control->name << "\n"
                                                                        << path;
      EXPECT_NEAR((run.ends.back() - b).norm(), 0.0, 2e-6) << control->name;
    }
  }
}

TEST(OtherOperations, ArcsByRadiusInOtherPlanesAndFromNowhere) {
  const auto turns = [](const std::string& arc) {
    return run_of(linuxcnc(), "S600 M3\nG0 X1 Y0 Z0\n" + arc + "\n").turns;
  };
  EXPECT_NEAR(turns("G3 X0 Y1 R1 F60"), 10.0 * kPi / 2.0, 1e-9);
  EXPECT_NEAR(turns("G3 X0 Y1 R-1 F60"), 10.0 * 1.5 * kPi, 1e-9);
  EXPECT_NEAR(turns("G18 G2 X0 Z1 I-1 K0 F60"), 10.0 * kPi / 2.0, 1e-9);
  EXPECT_NEAR(turns("G2 X1 Y0 I-1 J0 F60"), 20.0 * kPi, 1e-9);  // a whole turn
  for (const char* bad : {"G2 X5 Y5 I1 J0 F60", "G2 X0 Y1 F60", "G2 X0 Y1 R0.1 F60",
                          "G2 X0 Y1 I-1 J0 K0 F60", "G93 G2 X0 Y1 I-1 J0", "G2 X0 Y1 I-1 R1 F60"})
    EXPECT_THROW(turns(bad), InputError) << bad;
  EXPECT_THROW(run_of(linuxcnc(), "S600 M3\nG2 X0 Y1 I-1 F60\n"), InputError);
}

// Where each cycle's tool goes in Z, and how long it feeds and waits.
TEST(OtherOperations, DrillingCyclesGoWhereTheySay) {
  struct Case {
    const char* words;
    double fed, waited;
    std::int64_t rapids;
  };
  for (const Case& c : {Case{"G98\nG81 X5 Y5 Z-3 R2 F1", 5.0, 0.0, 3},
                        {"G99\nG81 X5 Y5 Z-3 R2 F1", 5.0, 0.0, 3},
                        {"G98\nG82 X5 Y5 Z-3 R2 P0.5 F1", 5.0, 0.5, 3},
                        {"G98\nG83 X5 Y5 Z-3 R2 Q2 F1", 5.5, 0.0, 7},
                        {"G98\nG73 X5 Y5 Z-3 R2 Q2 F1", 5.5, 0.0, 5},
                        {"G99\nG85 X5 Y5 Z-3 R2 F1", 10.0, 0.0, 2},
                        {"G99\nG89 X5 Y5 Z-3 R2 P0.5 F1", 10.0, 0.5, 2}})
    for (const Control* control : controls()) {
      const std::string program = posted(*control, std::string(c.words) + "\nG80\n");
      const Ran run = run_of(*control, program), before = run_of(*control, posted(*control, ""));
      EXPECT_NEAR(run.length, c.fed, 1e-9) << control->name << " " << c.words << "\n" << program;
      EXPECT_NEAR(run.turns, 10.0 * (c.fed + c.waited), 1e-6) << control->name << " " << c.words;
      EXPECT_EQ(run.rapids - before.rapids, c.rapids) << control->name << " " << c.words << "\n"
                                                      << program;
      const double up = std::string(c.words).substr(0, 3) == "G98" ? 20.0 : 2.0;
      EXPECT_NEAR((run.ends.back() - Vec3(5, 5, up)).norm(), 0.0, 1e-9)
          << control->name << " " << c.words;
    }
  EXPECT_NE(posted(control_of("fanuc"), "G82 X5 Y5 Z-3 R2 P0.5 F1\n")
                .find(" R2.000000 P500 F60.000000\n"),
            std::string::npos);
  // a program may begin with a height and a cycle
  for (const Control* control : controls()) {
    const std::string program =
        write_program({"M6 T1\nM3 S600\nG0 Z20\nG81 X5 Y5 Z-3 R2 F1\nG80\n"}, style_of(*control));
    EXPECT_NEAR(run_of(*control, program).turns, 50.0, 1e-6) << control->name << "\n" << program;
    EXPECT_THROW(write_program({"M6 T1\nG81 X5 Y5 Z-3 R2 F1\n"}, style_of(*control)), InputError);
  }
  for (const char* bad :
       {"G81 X1 Y1 Z5 R2 F1", "G83 X1 Y1 Z-3 R2 F1", "G81 X1 Y1 R2 F1", "G81 X1 Y1 Z-3 R2 L3 F1",
        "G91\nG81 X1 Y1 Z-3 R2 F1", "G81 X1 Y1 Z-3 R2 Q1 F1"})
    for (const Control* control : controls())
      EXPECT_THROW(posted(*control, std::string(bad) + "\n"), InputError) << bad << control->name;
}

TEST(OtherOperations, HolesInARowReturnToTheFirstHeight) {
  for (const Control* control : controls()) {
    const Ran run =
        run_of(*control, posted(*control, "G98\nG81 X5 Y5 Z-3 R2 F1\nG81 X7 Y5 Z-3 R2 F1\nG80\n"));
    EXPECT_NEAR(run.length, 10.0, 1e-9) << control->name;
    EXPECT_NEAR((run.ends.back() - Vec3(7, 5, 20)).norm(), 0.0, 1e-9) << control->name;
  }
}

TEST(OtherOperations, RelativeMovesAndMachineCoordinates) {
  const auto ends = [](const std::string& text) { return run_of(linuxcnc(), text).ends; };
  const std::vector<Vec3> relative = ends("G0 X1 Y2 Z3\nG91 G0 Z5\nG0 X1 Z-1\nG90\nG0 Z1\n");
  ASSERT_EQ(relative.size(), 4u);
  EXPECT_EQ(relative[2], Vec3(2, 2, 7));
  EXPECT_EQ(relative[3], Vec3(2, 2, 1));
  // after G53 nobody knows the height: a new stretch begins, and its moves are unplaced until it is told
  const Program p =
      read_gcode("S600 M3\nG0 X1 Y2 Z3\nG1 X2 F60\nG53 G0 Z0\nG0 X5 Y5\nG1 Z1\nG1 X6\n", kTool,
                 {&linuxcnc(), true});
  ASSERT_EQ(p.sections.size(), 2u);
  EXPECT_EQ(p.sections[1].unplaced, 2);
  EXPECT_TRUE(std::isnan(p.sections[1].path.moves[1].turns));
  EXPECT_FALSE(std::isnan(p.sections[1].path.moves[2].turns));
  // a path mode, inverse time or relative coordinates that an operation leaves are not the next one's
  ProgramStyle style = style_of(linuxcnc(), 3);
  const std::string text =
      write_program({kBegin, "G91\nG0 Z5\n", "G61\nG93\nG1 X5 Y0 Z20 F1\n", "G0 X7 Y7\n"}, style);
  EXPECT_NE(text.find("G0 Z5.000\nG90\nG61\nG93\nG1 X5.000 Y0.000 Z20.000 F60.000\nG94\nG64\nG0 "
                      "X7.000 Y7.000\n"),
            std::string::npos)
      << text;
  for (const char* first : {"G2 X0 Y0 I-2.5 J0 F1\n", "G81 X5 Y5 Z-3 R2 F1\n", "G0 X7 Y7\n"}) {
    const std::string next =
        write_program({kBegin, "G61\nG1 X5 Y0 Z20 F1\n", first}, style_of(linuxcnc(), 3));
    EXPECT_NE(next.find("\nG64\n" + std::string(first).substr(0, 2)), std::string::npos) << next;
  }
  style.own = {true, true, false, true};  // what others set stays
  EXPECT_EQ(
      write_program({kBegin, "", "G61\nG1 X5 Y0 Z20 F1\n", "G0 X7 Y7\n"}, style).find("G64\n"),
      std::string::npos);
}

TEST(OtherOperations, AnUprightOneFindsTheTableAtZero) {
  const std::string tilted = "G43.4 H1\nG0 X1 Y1 Z30 A15 C68\nG1 X2 F5\nG49\n",
                    upright = "G0 X3 Y3 Z30\nG1 Z20 F5\n";
  for (const Control* control : controls()) {
    if (!control->can.tcp) continue;
    ProgramStyle style = style_of(*control, 3);
    EXPECT_THROW(write_program({kBegin, tilted, upright}, style),
                 InputError);  // nobody knows where it is clear
    EXPECT_NO_THROW(write_program({kBegin, upright, tilted}, style));
    EXPECT_NO_THROW(write_program({kBegin, tilted, tilted}, style));
    style.retract = {{'Z', 400.0}};
    const std::string program = write_program({kBegin, tilted, upright}, style);
    const auto sections = read_gcode(program, kTool, {control, true}).sections;
    EXPECT_FALSE(sections.back().tcp.back()) << control->name;
    for (std::size_t i = 0; i < sections.back().path.moves.size(); ++i)
      for (const double angle : sections.back().angles[i])
        EXPECT_TRUE(angle == 0.0 || sections.back().path.moves[i].kind != MoveKind::Cut) << program;
  }
  ProgramStyle style = style_of(control_of("fanuc"), 3);
  style.retract = {{'Z', 0.0}};
  EXPECT_NE(
      write_program({kBegin, tilted, upright}, style)
          .find(
              "\nG49\nG90 G53 G0 Z0.000\nG0 A0.000 C0.000\nG0 X3.000 Y3.000\nG0 G43 Z30.000 H1\n"),
      std::string::npos)  // G49 has ended the length
      << write_program({kBegin, tilted, upright}, style);
  // before the operation's name, once, also with a tool of its own
  style.comments = true;
  const std::string text =
      write_program({kBegin, tilted, "(TC)\nM6 T2\nM3 S500\n", "(Upright)\n" + upright}, style);
  EXPECT_NE(
      text.find(
          "\nG49\n(TC)\nG90 G53 G0 Z0.000\nM5\nT2 M6\nS500 M3\nG0 A0.000 C0.000\n(UPRIGHT)\n"),
      std::string::npos)
      << text;
  // the lead of the first locked move after an approach is along its own way
  style.control = &linuxcnc();
  const auto turned = [&](bool retracts) {
    ProgramStyle other = style;
    if (!retracts) other.retract.clear();
    const std::string locked = "G43.4 H1\nG0 X0 Y0 Z1 A5\nG93\nG1 X0 Y0 Z0 A5 F0.5\nG94\n";
    other.control = &control_of("heidenhain");
    const std::string made = write_program({kBegin + locked}, other);
    return made.substr(made.find("M128")).find("Z+0.000 A+5.000 F30.000") != std::string::npos;
  };
  EXPECT_TRUE(turned(true));
  EXPECT_TRUE(turned(false));
}

TEST(OtherOperations, TheMachinesOwnWordsForTcp) {
  ProgramStyle style = style_of(linuxcnc(), 3);
  style.tcp_on = "M440";
  style.tcp_off = "M441";
  const std::string text =
      write_program({kBegin + "M440\nG0 X1 Y1 Z1 A5\nG1 X2 F5\nM441\n"}, style);
  EXPECT_NE(text.find("G0 A5.000\nM440\nG0 X1.000 Y1.000\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\nM441\n"), std::string::npos) << text;
}

TEST(OtherOperations, HeidenhainGetsItsBlankAndFanucItsNumber) {
  ProgramStyle style = style_of(control_of("heidenhain"), 3);
  style.stock = std::pair(Vec3(-1, -2, -3), Vec3(4, 5, 0));
  EXPECT_NE(write_program({kBegin}, style)
                .find("\n1 BLK FORM 0.1 Z X-1.000 Y-2.000 Z-3.000\n2 BLK FORM 0.2 X+4.000 Y+5.000 "
                      "Z+0.000\n"),
            std::string::npos);
  style = style_of(control_of("fanuc"), 3);
  style.number = 42;
  EXPECT_EQ(write_program({kBegin}, style).substr(0, 8), "%\nO0042\n");
  style.number = 0;
  EXPECT_THROW(write_program({kBegin}, style), InputError);
}

}  // namespace
}  // namespace patchmill::gcode

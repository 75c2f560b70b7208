// Arcs that are about as short as the last decimal of a program: what their words say is the arc, and never a whole
// circle, nor one without a radius, for every control.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/gcode_motion.h"
#include "patchmill/gcode/gcode_reader.h"
#include "patchmill/gcode/program_writer.h"

#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace patchmill::gcode {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kUnit = 1e-3;
const std::string kBegin = "M6 T1\nM3 S600\nG0 X0 Y0 Z20\n";

std::string posted(const Control& control, const std::string& path) {
  ProgramStyle style;
  style.control = &control;
  style.precision = 3;
  return write_program({kBegin + path}, style);
}

struct Ran {
  double length = 0.0, turns = 0.0;  // of cuts
  Vec3 end = Vec3::Zero();
};
Ran run_of(const Control& control, const std::string& program) {
  Ran run;
  for (const ProgramSection& s : read_gcode(program, Tool{1.0, 2}, {&control, true}).sections) {
    Vec3 from = s.path.start.tip;
    for (const Move& m : s.path.moves) {
      if (m.kind == MoveKind::Cut) {
        run.length += (m.end.tip - from).norm();
        run.turns += m.turns;
      }
      run.end = from = m.end.tip;
    }
  }
  return run;
}

struct Short {
  std::string path;
  Vec3 end;
  double length;
};
Short arc_of(double radius, double first, double turned, bool clockwise, const Vec3& centre,
             const std::string& before) {
  const auto at = [&](double angle) -> Vec3 {
    return centre + radius * Vec3(std::cos(angle), std::sin(angle), 0.0);
  };
  const Vec3 a = at(first), b = at(first + (clockwise ? -turned : turned));
  return {fmt::format("G0 X{:.9f} Y{:.9f} Z0\n{}{} X{:.9f} Y{:.9f} I{:.9f} J{:.9f} F{}\n", a.x(),
                      a.y(), before, clockwise ? "G2" : "G3", b.x(), b.y(), centre.x() - a.x(),
                      centre.y() - a.y(), before.empty() ? "1" : "0.5"),
          b, radius * turned};
}

TEST(ShortArcs, AreAsLongAsTheyWere) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> u(-1.0, 1.0);
  for (int i = 0; i < 400; ++i) {
    const double radius = std::pow(10.0, 2.0 * u(random) - 1.5);  // 0.3 um to 3 mm
    const double turned = i % 5 == 0 ? 2.0 * kPi - 1e-4 * std::abs(u(random))
                                     : std::min(std::pow(10.0, 3.0 * u(random) - 2.0), 6.0);
    const Short s = arc_of(radius, kPi * u(random), turned, i % 2 == 0,
                           {10.0 * u(random), 10.0 * u(random), 0.0}, "");
    for (const Control* control : controls()) {
      const std::string program = posted(*control, s.path);
      const Ran run = run_of(*control, program);
      // ends and centre are rounded, and with them the radius by up to 1.4 units
      EXPECT_NEAR(run.length, s.length, 10.0 * kUnit + 0.02 * s.length) << s.path << program;
      EXPECT_LE((run.end - s.end).cwiseAbs().maxCoeff(), 0.5001 * kUnit) << program;
    }
  }
}

TEST(ShortArcs, OneWithinTheLastDecimalIsNoWholeCircle) {
  for (const char* arc : {"G2 X0 Y0.0001 I1 J0 F1", "G3 X0 Y-0.0001 I1 J0 F1",
                          "G2 X0.0004 Y0.0004 I0.0002 J0.0002 F1"})
    for (const Control* control : controls())
      EXPECT_LT(run_of(*control, posted(*control, fmt::format("G0 Z0\n{}\n", arc))).length, kUnit)
          << control->name << arc;
  const std::string whole = posted(linuxcnc(), "G0 Z0\nG3 X0 Y0.0001 I1 J0 F1\n");
  EXPECT_NEAR(run_of(linuxcnc(), whole).length, 2.0 * kPi, 0.01);
}

TEST(ShortArcs, InInverseTimeTheLinesTakeTheTimeOfTheArc) {
  // a radius of 0.4 um; F is 1/s for the whole of it: 2 s at 10 turns a second
  const Short s = arc_of(4e-4, 0.0, 6.0, false, {0.0007, 0.0, 0.0}, "G93\n");
  for (const Control* control : controls()) {
    if (!control->can.inverse_time) continue;
    const std::string program = posted(*control, s.path);
    EXPECT_EQ(program.find("G3 "), std::string::npos) << program;
    EXPECT_LE(run_of(*control, program).turns, 20.0 + 1e-6) << program;
  }
}

}  // namespace
}  // namespace patchmill::gcode

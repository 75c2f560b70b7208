// What a control's program is not to have is refused with what to do instead.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/program_writer.h"
#include "patchmill/geometry/error.h"

#include <gtest/gtest.h>

namespace patchmill::gcode {
namespace {

TEST(NotPosted, SaysWhatToDoInstead) {
  const auto remedy = [](const Control& control, const std::string& path) {
    ProgramStyle style;
    style.control = &control;
    try {
      write_program({"M6 T1\nM3 S600\nG0 X0 Y0 Z20\n" + path + "\n"}, style);
    } catch (const InputError& error) {
      return error.remedy();
    }
    return std::string();
  };
  for (const Control* control : controls())
    for (const auto& [path, instead] : {std::pair{"G92 X0", "work offset"},
                                        {"G10 L2 P1 X0", "work offset"},
                                        {"G52 X1", "work offset"},
                                        {"G68 R30", "model"},
                                        {"G51 X2", "model"},
                                        {"G38.2 Z1", "probe"},
                                        {"G41 D1", "radius"},
                                        {"G65 P1", "one piece"},
                                        {"G95", "mm/min"},
                                        {"M2", "take it out"},
                                        {"G20", "take it out"},
                                        {"X45", "begin the line"},
                                        {"G83 X1 Y1 Z-1 R2 F1", "each peck"},
                                        {"G73 X1 Y1 Z-1 R2 Q0 F1", "each peck"},
                                        {"G4 P-1", "not less than 0"},
                                        {"G999", "take it out"}})
      EXPECT_NE(remedy(*control, path).find(instead), std::string::npos)
          << control->name << " " << path << ": " << remedy(*control, path);
  for (const char* control : {"linuxcnc", "fanuc", "haas", "grblhal"})
    EXPECT_NE(remedy(control_of(control), "M98").find("one piece"), std::string::npos) << control;
}

// (property, remedy) of what is said of a block in an operation of ours or of others; empty if it is posted.
std::pair<std::string, std::string> said(const char* control, const std::string& path, bool own) {
  ProgramStyle style;
  style.control = &control_of(control);
  style.own = {own};
  try {
    write_program({"M6 T1\nM3 S600\nG0 X0 Y0 Z20\n" + path + "\nG1 X9 F10\n"}, style);
  } catch (const InputError& error) {
    return {error.property(), error.remedy()};
  }
  return {};
}

TEST(NotPosted, RoundingThatAControlHasNoWordFor) {
  for (const char* control : {"fanuc", "haas", "heidenhain"}) {
    EXPECT_EQ(said(control, "G64 P0.01 Q0", true).first, "") << control;
    EXPECT_EQ(said(control, "G64", false).first, "") << control;
    EXPECT_EQ(said(control, "G64 P0.01", false).first, "Path") << control;
    EXPECT_NE(said(control, "G64 P0.01", false).second.find("no word P"), std::string::npos);
  }
  EXPECT_EQ(said("linuxcnc", "G64 P0.01 Q0.01", false).first, "");
  EXPECT_EQ(said("siemens", "G64 P0.01", false).first, "");
  EXPECT_EQ(said("siemens", "G64 P0.01 Q0.01", false).first, "Path");
  EXPECT_EQ(said("grblhal", "G64 P0.01", false).first, "Path");
  EXPECT_EQ(said("grblhal", "G64 P0.01 Q0", true).first, "Strategy");
}

TEST(NotPosted, WhatOursChooseAndOthersTakeOut) {
  for (const char* on : {"G43.4 H1", "M428"}) {
    EXPECT_EQ(said("grblhal", on, true).first, "ProgramForm");
    EXPECT_EQ(said("grblhal", on, false).first, "Path");
    EXPECT_NE(said("grblhal", on, false).second.find("take it out"), std::string::npos);
  }
  for (const char* control : {"haas", "heidenhain", "grblhal"}) {
    EXPECT_EQ(said(control, "G33 X5 K1", true).first, "Strategy") << control;
    EXPECT_EQ(said(control, "G33 X5 K1", false).first, "Path") << control;
    EXPECT_NE(said(control, "G33 X5 K1", false).second.find("take it out"), std::string::npos);
  }
}

}  // namespace
}  // namespace patchmill::gcode

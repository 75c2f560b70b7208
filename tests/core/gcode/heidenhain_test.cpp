// What plain text of a Heidenhain control has otherwise than words of letters and numbers: blocks that are refused as
// the control refuses them, presets and datum shifts by cycles.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/controls/control.h"
#include "patchmill/gcode/gcode_reader.h"
#include "patchmill/geometry/error.h"

#include <gtest/gtest.h>

namespace patchmill::gcode {
namespace {

const Tool kTool{1.0, 2};

bool reads(const std::string& block) {
  try {
    read_gcode("TOOL CALL 1 Z S600\nM3\nL X+0 Y+0 Z+20 R0 FMAX\n" + block + "\n", kTool,
               {&control_of("heidenhain"), true});
    return true;
  } catch (const InputError&) {
    return false;
  }
}

TEST(Heidenhain, RefusesWhatTheControlDoes) {
  for (const char* bad :
       {"L X+1 X+2 FMAX", "L X+1 F100 F200", "L X+1 M3 M4", "TOOL CALL", "CYCL DEF 9.1",
        "CYCL DEF 200 DRILLING", "L X+inf FMAX", "L X+1 DR+", "LBL 1", "CALL LBL 1", "FN 0: Q1 = 3",
        "C X+1 Y+1", "TOOL CALL 1 Y S100", "M98", "L IX+1 FMAX"})
    EXPECT_FALSE(reads(bad)) << bad;
}

TEST(Heidenhain, TakesOneFeed) {
  for (const char* good : {"L X+1 F+23.0", "L X+1 FMAX", "L X+1 FT2"})
    EXPECT_TRUE(reads(good)) << good;
  for (const char* bad : {"L X+1 F+23.0 FMAX", "L X+1 FT2 F100"}) EXPECT_FALSE(reads(bad)) << bad;
}

TEST(Heidenhain, CornersOfTheStockAreThreeNumbers) {
  for (const char* good :
       {"BLK FORM 0.1 Z X-1 Y-2 Z-3", "BLK FORM 0.2 X+4 Y+5 Z+0", "BLK FORM 0.2 IX+4 IY+5 IZ+0",
        "BLK FORM CYLINDER Z R50 L105", "BLK FORM FILE \"a.stl\""})
    EXPECT_TRUE(reads(good)) << good;
  for (const char* bad : {"BLK FORM 0.2 X+4 Y+5 F+0", "BLK FORM 0.1 Z X+4 Y+5",
                          "BLK FORM 0.1 Z X+4 X+5 Z+1", "BLK FORM 0.2 X+4 Y+5 Zq", "BLK FORM 0.1"})
    EXPECT_FALSE(reads(bad)) << bad;
}

TEST(Heidenhain, PresetsAndShiftsByCycles) {
  for (const char* preset : {"CYCL DEF 247 DATUM SETTING Q339=+2 ;DATUM NUMBER\n",
                             "5 CYCL DEF 247 DATUM SETTING ~\nQ339=+2 ;DATUM NUMBER\n"})
    EXPECT_EQ(read_gcode(std::string(preset) + "L X+1 Y+1 Z+1 R0 FMAX\n", kTool,
                         {&control_of("heidenhain"), true})
                  .sections[0]
                  .offset,
              "G54.1 P2");
  const Program shifted = read_gcode(
      "L X+1 Y+1 Z+1 R0 FMAX\nCYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+10\nL X+1 Y+1 Z+1 R0 FMAX\n",
      kTool, {&control_of("heidenhain"), true});
  EXPECT_EQ(shifted.sections.size(), 2u);
}

}  // namespace
}  // namespace patchmill::gcode

// Reading G-code: closed forms for every feed mode, refusals, and a round trip through text.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/gcode_reader.h"

#include "patchmill/gcode/freecad_text.h"
#include "patchmill/geometry/error.h"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::gcode {
namespace {

const Tool kTool{1.0, 2};

TEST(ReadGcode, CountsTurnsInEveryFeedMode) {
  const Program program = read_gcode(
      "%\n(start) G21 G90\nT1 M6\nM3 S600\n"
      "G0 X0 Y0 Z5\n"
      "G1 Z0 F300\n"              // 5 mm at 5 mm/s: 1 s, 10 turns
      "G93\nG1 X3 Y4 F30 ;2 s\n"  // 20 turns
      "G33 X3 Y4 Z-6 K1.5\n"      // 6 mm at 1.5 mm a turn: 4 turns
      "G4 P0.5\n"                 // 5 turns
      "G94 N90 g1 x 0 F 60.0\n"   // 3 mm at 1 mm/s: 30 turns
      "M5\nM2\n",
      kTool);
  ASSERT_EQ(program.sections.size(), 1u);
  const ProgramSection& s = program.sections[0];
  EXPECT_EQ(s.tool_number, 1);
  EXPECT_EQ(s.path.spindle.sense, SpindleSense::M3);
  EXPECT_DOUBLE_EQ(s.path.spindle.speed, 10.0);
  const double turns[] = {NAN, 10, 20, 4, 5, 30};
  ASSERT_EQ(s.path.moves.size(), 6u);
  EXPECT_TRUE(std::isnan(s.path.moves[0].turns));
  for (std::size_t i = 1; i < 6; ++i) EXPECT_NEAR(s.path.moves[i].turns, turns[i], 1e-12) << i;
  EXPECT_EQ(s.lines[1], 6);
  EXPECT_NEAR((s.path.moves[5].end.tip - Vec3(0, 4, -6)).norm(), 0.0, 1e-12);
}

TEST(ReadGcode, InchesAreMillimetresTimes25point4) {
  const Program p = read_gcode("G20\nM4 S60\nG0 X0 Y0 Z0\nG1 X1 F60\n", kTool);
  const Move& move = p.sections[0].path.moves[1];
  EXPECT_DOUBLE_EQ(move.end.tip.x(), 25.4);
  EXPECT_DOUBLE_EQ(move.turns, 1.0);
  EXPECT_EQ(p.sections[0].path.spindle.sense, SpindleSense::M4);
}

TEST(ReadGcode, NewSpeedOrSenseOrToolBeginsASection) {
  const Program p = read_gcode(
      "S60 M3\nG0 X0 Y0 Z0\nG1 X1 F60\nS120\nG1 X2\nM4\nG1 X3\nT2 M6\nM3\nG1 X4\n", kTool);
  ASSERT_EQ(p.sections.size(), 4u);
  EXPECT_DOUBLE_EQ(p.sections[1].path.spindle.speed, 2.0);
  EXPECT_EQ(p.sections[2].path.spindle.sense, SpindleSense::M4);
  EXPECT_EQ(p.sections[3].tool_number, 2);
  EXPECT_DOUBLE_EQ(p.sections[1].path.start.tip.x(), 1.0);
}

TEST(ReadGcode, ATurningPartWithTheSpindleOffHasUnknownTurns) {
  const Program p = read_gcode("G0 X0 Y0 Z0\nG1 X1 F60\n", kTool);
  EXPECT_TRUE(std::isnan(p.sections[0].path.moves[1].turns));
}

TEST(ReadGcode, ABlockThatFollowsTheSpindleHasNoFeed) {
  const auto reads = [](const char* control, const std::string& block) {
    try {
      read_gcode("S600 M3\nG0 X0. Y0. Z0.\n" + block + "\n", kTool, {&control_of(control), true});
      return true;
    } catch (const InputError&) {
      return false;
    }
  };
  EXPECT_TRUE(reads("siemens", "G33 X1. I0.5"));
  EXPECT_FALSE(reads("siemens", "G33 X1. I0.5\nF37700 X2. I0.5"));
  EXPECT_FALSE(reads("linuxcnc", "G33 X1. K0.5\nX2. K0.5 F100"));
  EXPECT_TRUE(reads("fanuc", "G33 X1. F0.5\nX2. F0.5"));
}

TEST(ReadGcode, ASpindleThatIsTurnedToAnAngleStands) {
  const Program p = read_gcode("M3 S600\nG0 X0 Y0 Z0\nM19 R45\nG1 X1 F60\nM3\nG1 X2\n", kTool);
  ASSERT_EQ(p.sections.size(), 3u);
  EXPECT_TRUE(std::isnan(p.sections[1].path.moves[0].turns));
  EXPECT_DOUBLE_EQ(p.sections[2].path.moves[0].turns, 10.0);
}

TEST(ReadGcode, RefusesWhatItDoesNotKnowAndNamesTheLine) {
  for (const char* bad :
       {"G2 X1 Y1 I1", "G1 X[1+2]", "G1 X#3", "O100 CALL", "G1 X1 A5 F1", "G1 X1 U2 F1", "M98 P1",
        "G81 Z1 R2", "G1 X1 (open", "/G1 X1", "G33 X1", "G93\nG1 X1", "G1 X1", "X1", "G1 X"}) {
    try {
      read_gcode(std::string("G21\n") + bad + "\n", kTool);
      ADD_FAILURE() << bad;
    } catch (const InputError& e) {
      EXPECT_EQ(e.property().rfind("G-code line ", 0), 0u) << e.what();
    }
  }
}

ToolPath random_path() {
  ToolPath path{kTool, {1000.0 / 60.0, SpindleSense::M3}, {}, {}};
  const Decimals three(3);
  const double feed = 434.413 / 60.0;
  Vec3 at(0, 0, 50);
  path.start.tip = at;
  path.moves.push_back({{at, Vec3::UnitZ()}, kUnknownTurns, kNoDimple, MoveKind::Rapid});
  const int count = *rc::gen::inRange(1, 60);
  for (int i = 0; i < count; ++i) {
    const auto c = [] { return *rc::gen::inRange(-50000, 50000) / 1000.0; };
    const Vec3 p = three.round(Vec3(c(), c(), c()));
    const bool link = *rc::gen::inRange(0, 4) == 0;
    const double turns = (p - at).norm() / feed * path.spindle.speed;
    path.moves.push_back(
        {{p, Vec3::UnitZ()}, turns, link ? kNoDimple : i, link ? MoveKind::Link : MoveKind::Cut});
    at = p;
  }
  return path;
}

// FreeCAD's text has F in mm/s; as a post does, write it in mm/min.
std::string posted(const ToolPath& path) {
  std::string text = freecad_text(path, 434.413 / 60.0, Decimals(3)), out = "M3 S1000\n";
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != 'F') {
      out += text[i];
      continue;
    }
    out += "F434.413";
    while (text[i + 1] != '\n') ++i;
  }
  return out;
}

RC_GTEST_PROP(ReadGcode, ReadsBackWhatWasWritten, ()) {
  const ToolPath plan = random_path();
  Program program = read_gcode(posted(plan), kTool);
  RC_ASSERT(program.sections.size() == 1u);
  ToolPath& read = program.sections[0].path;
  const PlanMatch match = match_plan(read, plan, 5e-4);
  RC_ASSERT(match.complete);
  RC_ASSERT(match.extra_moves == 0);
  RC_ASSERT(match.largest_miss < 1e-9);
  double planned = 0, found = 0;
  for (const Move& m : plan.moves) planned += std::isnan(m.turns) ? 0 : m.turns;
  for (const Move& m : read.moves) found += std::isnan(m.turns) ? 0 : m.turns;
  RC_ASSERT(std::abs(planned - found) < 1e-6 * (1 + planned));
}

TEST(MatchPlan, SeesWhatIsMissingAndWhatIsTooMuch) {
  ToolPath plan{kTool, {10, SpindleSense::M3}, {}, {}};
  for (int i = 0; i < 5; ++i)
    plan.moves.push_back({{Vec3(i, 0, 0), Vec3::UnitZ()}, 1.0, i, MoveKind::Cut});
  ToolPath longer = plan, shorter = plan;
  longer.moves.insert(longer.moves.begin() + 2,
                      {{Vec3(9, 9, 9), Vec3::UnitZ()}, 1.0, kNoDimple, MoveKind::Cut});
  shorter.moves.erase(shorter.moves.begin() + 2);
  const PlanMatch a = match_plan(longer, plan, 1e-3), b = match_plan(shorter, plan, 1e-3);
  EXPECT_TRUE(a.complete);
  EXPECT_EQ(a.extra_moves, 1);
  EXPECT_FALSE(b.complete);
  EXPECT_EQ(b.found, 2);
  EXPECT_EQ(b.lost_moves, 3);
}

// Any text either reads or is refused by name; nothing crashes, nothing is a NaN place.
RC_GTEST_PROP(ReadGcode, SurvivesAnyText, ()) {
  const auto piece = rc::gen::element<std::string>(
      "G0", "G1", "G33", "G93", "X", "Y1", "Z-2.5", "F", "F100", "M3", "S", "S60", "\n", " ", "(",
      ")", ";", "%", "K0", "K1", "1e9", ".", "-", "G4", "P1", "T", "\t", "N5", "G20");
  const auto pieces = *rc::gen::container<std::vector<std::string>>(piece);
  std::string text;
  for (const auto& p : pieces) text += p;
  try {
    for (const ProgramSection& s : read_gcode(text, kTool).sections)
      for (const Move& m : s.path.moves) RC_ASSERT(m.end.tip.allFinite());
  } catch (const InputError& e) {
    RC_ASSERT(e.property().rfind("G-code line ", 0) == 0u);
  }
}

TEST(FreecadText, RefusesAPathThatIsNotOfConstantFeed) {
  ToolPath path{kTool, {10, SpindleSense::M3}, {}, {}};
  path.moves.push_back({{Vec3(1, 0, 0), Vec3::UnitZ()}, 5.0, 0, MoveKind::Cut});
  EXPECT_NO_THROW(freecad_text(path, 2.0, Decimals(3)));
  EXPECT_THROW(freecad_text(path, 2.1, Decimals(3)), InputError);
}

TEST(ReadGcode, SaysTheFeedOfEachMove) {
  const auto sections = read_gcode(
                            "M3 S600\nG0 X0 Y0 Z5\nG1 Z0 F120.5\nX3\nG93 G1 X4 F2\nG94\nG33 X5 "
                            "K0.5\nG0 Z5\nG1 X6 F7\n",
                            kTool)
                            .sections;
  ASSERT_EQ(sections.size(), 1u);
  const std::vector<double>& feeds = sections[0].feeds;
  const std::vector<double> wanted = {-1, 120.5, 120.5, 2, -1, -1, 7};
  ASSERT_EQ(feeds.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i)
    EXPECT_TRUE(wanted[i] < 0 ? std::isnan(feeds[i]) : feeds[i] == wanted[i]) << i;
  EXPECT_EQ(sections[0].inverse,
            (std::vector<bool>{false, false, false, true, false, false, false}));
}

TEST(ReadGcode, WordsOfArcsAreRefusedInStraightMoves) {
  const std::string begin = "M3 S600\nG0 X0 Y0 Z5\nG1 Z1 F100\n";
  EXPECT_NO_THROW(read_gcode(begin + "X3 Y1\n", kTool));
  for (const char* word : {"I1", "J1", "K1", "R1"})
    EXPECT_THROW(read_gcode(begin + word + " X3 Y1\n", kTool), InputError) << word;
  EXPECT_NO_THROW(read_gcode(begin + "G0 G53 Z0\n", kTool));
  EXPECT_THROW(read_gcode(begin + "G0 G53 Z0 J0\n", kTool), InputError);
  const std::string locked = begin + "G33 X3 Y1 K0.5\n";
  EXPECT_NO_THROW(read_gcode(locked + "X4 K0.5\n", kTool));
  EXPECT_THROW(read_gcode(locked + "R33 X4 K0.5\n", kTool), InputError);  // of G33 that is in force
}

TEST(ReadGcode, ALeadOfAnotherAxisIsRefused) {
  const ReadOptions siemens{&control_of("siemens")};
  const std::string begin = "G0 X0 Y0 Z5\nS600 M3\n";
  EXPECT_NO_THROW(read_gcode(begin + "G33 X3 Y1 I0.5\n", kTool, siemens));
  EXPECT_THROW(read_gcode(begin + "G33 X3 Y1 I0.5 K4\n", kTool, siemens), InputError);
  EXPECT_THROW(read_gcode(begin + "G33 X3 Y1 J0.5\n", kTool, siemens), InputError);
}

}  // namespace
}  // namespace patchmill::gcode

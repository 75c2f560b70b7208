// Comments: whatever a label holds, no control acts on it, and the program stays the same.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/controls/control.h"
#include "patchmill/gcode/gcode_reader.h"
#include "patchmill/gcode/program_writer.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchmill::gcode {
namespace {

const std::string kBegin = "M6 T1\nM3 S600\nG0 X0 Y0 Z20\nG0 X1 Y0 Z20\nG1 X0 F10\n";

// The whole of a program but its comments is the same whatever they hold.
RC_GTEST_PROP(Comments, NoCommentIsEverACommand, ()) {
  const auto piece = rc::gen::element<std::string>(
      "M30", ")", "(", ";", "%", "\r", "\n", "abort,", "PY,", " msg,", "_debug,", "log",
      "LOGOPEN,x", "print,", "\t", "G0 Z-5", "~", "/", "\xc3\xa4", std::string(1, '\0'), "O100",
      "#1=2", "N5", "part", " ", "100 %", "N10 M30", "\x7f", std::string(300, 'x'));
  std::string label;
  for (const auto& p : *rc::gen::container<std::vector<std::string>>(piece)) label += p;
  for (const Control* control : controls()) {
    ProgramStyle style;
    style.control = control;
    const auto plain = program_lines(write_program({kBegin}, style), *control);
    style.header = {label, "100 %"};
    std::string inside = label;  // FreeCAD ends a command's text at a line's end
    for (char& c : inside)
      if (c == '\n') c = ' ';
    const std::string text = write_program({"(" + inside + ")\n" + kBegin}, style);
    std::size_t longest = 0, from = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
      RC_ASSERT(text[i] == '\n' || (text[i] >= ' ' && text[i] <= '~'));
      if (text[i] != '\n') continue;
      const std::string line = text.substr(from, i - from);
      longest = std::max(longest, line.size());
      RC_ASSERT(line.find('%') == std::string::npos || control != &control_of("fanuc") ||
                line == "%");
      from = i + 1;
    }
    RC_ASSERT(longest <= 255u);
    const auto lines = program_lines(text, *control);
    RC_ASSERT(lines.size() == plain.size());
    for (std::size_t i = 0; i < lines.size(); ++i)
      RC_ASSERT(lines[i].words.size() == plain[i].words.size());
  }
}

TEST(Comments, ActiveCommentsAreMadeHarmless) {
  for (const char* active :
       {"abort, now", "PY, x", " msg, hello", "_d e b u g, #1", "LOGOPEN, x", "print,y"}) {
    const std::string safe = safe_comment(linuxcnc().comments, active);
    EXPECT_EQ(safe.substr(0, 3), "(- ") << safe;
  }
  EXPECT_EQ(safe_comment(linuxcnc().comments, "Part: plate (left), 100 %"),
            "(Part: plate left, 100 %)");
  EXPECT_EQ(safe_comment(control_of("fanuc").comments, "feed override 100 %"),
            "(FEED OVERRIDE 100  )");
  EXPECT_EQ(safe_comment(control_of("siemens").comments, "a; M30\r\nM30"), "; a M30??M30");
}

}  // namespace
}  // namespace patchmill::gcode

// Any bytes as a program of any control: it is read, or refused by an InputError; what is read is finite.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/gcode/controls/control.h"
#include "patchmill/gcode/gcode_reader.h"
#include "patchmill/geometry/error.h"

#include <cstdint>
#include <cstdlib>

namespace patchmill::fuzz {

/// The first byte says which control, and whether there are rotary axes; the others are the text. Ends the process
/// where what is read is not as it must be.
inline void read_program(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return;
  const auto& controls = gcode::controls();
  gcode::ReadOptions options;
  options.control = controls[data[0] / 2 % controls.size()];
  options.rotary = data[0] % 2 == 1;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    const gcode::Program program = gcode::read_gcode(text, Tool{1.0, 2}, options);
    for (const gcode::ProgramSection& section : program.sections) {
      if (section.lines.size() != section.path.moves.size()) std::abort();
      for (const Move& move : section.path.moves)
        if (!move.end.tip.allFinite()) std::abort();
    }
  } catch (const InputError&) {  // a refusal
  }
  try {
    gcode::program_lines(text, *options.control);
  } catch (const InputError&) {
  }
}

}  // namespace patchmill::fuzz

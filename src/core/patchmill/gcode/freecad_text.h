// ToolPath as the text that FreeCAD's Path.Path(text) reads: FreeCAD's own internal dialect, F in
// mm/s.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/path/rounding.h"
#include "patchmill/path/tool_path.h"

#include <string>

namespace patchmill::gcode {

/// G0 for rapids; G1 with an F word for timed moves, F = length / duration (the moves of a
/// constant-feed path all have the same). One comment per patch change is left out: FreeCAD's post
/// copies comments, and a controller has no use for thousands. `feed` [mm/s] is written as given to
/// 9 decimals. Errors: InputError naming Feed if a timed move's own feed is not `feed` within 1e-6
/// of it: this writer is for constant feed, and never guesses.
std::string freecad_text(const ToolPath& path, double feed, const Decimals& decimals);

/// The same of a path whose moves have feeds of their own. A timed move of no length is left out: it has no
/// feed. Errors: InputError naming Feed if a timed move has none.
std::string freecad_text(const ToolPath& path, const Decimals& decimals);

}  // namespace patchmill::gcode

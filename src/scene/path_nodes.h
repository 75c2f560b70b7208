// A tool path as it is, in the work frame. FreeCAD draws paths that have rotary words as machine
// coordinates on a rotary table, so that a program with the tool tip kept by the controller becomes a
// spiral: five-axis paths are drawn here.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/path/tool_path.h"
#include "scene/display.h"

namespace patchmill::scene {

/// Lines along the tool tip, coloured by the kind of move; of the moves from `first` up to but not
/// including `last`.
Display path_display(const ToolPath& path, std::size_t first, std::size_t last);

/// Lines of `length` [mm] along the tool axis at the ends of moves, at most `most`, evenly chosen.
Display path_axis_display(const ToolPath& path, double length, std::size_t most);

}  // namespace patchmill::scene

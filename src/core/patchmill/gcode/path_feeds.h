// F words of a path's text. FreeCAD writes them with six decimals of mm/s, which is less than a phase needs over
// thousands of turns; the plan knows them exactly, and they are put back.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace patchmill::gcode {

/// The values of all F words of `text` in their order, but for those in comments.
std::vector<double> feeds_of(std::string_view text);

/// `text` with the values of its F words replaced by `feeds`, with twelve decimals; `text` as it is unless there are as
/// many, each the same to half a unit of the text's sixth decimal. Errors: InputError naming feeds (0 .. 1e9).
std::string with_feeds(const std::string& text, const std::vector<double>& feeds);

}  // namespace patchmill::gcode

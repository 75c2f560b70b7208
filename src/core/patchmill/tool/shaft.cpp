// Edges, shank and holder; see shaft.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/tool/shaft.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/require.h"

#include <algorithm>

#include <fmt/format.h>

namespace patchmill {

bool operator==(const Frustum& a, const Frustum& b) {
  return a.from == b.from && a.to == b.to && a.radius_from == b.radius_from &&
         a.radius_to == b.radius_to;
}

bool operator==(const Shaft& a, const Shaft& b) {
  return a.cutting_length == b.cutting_length && a.shank_radius == b.shank_radius &&
         a.stick_out == b.stick_out && a.holder == b.holder;
}

const char* name(ToolPart part) {
  switch (part) {
    case ToolPart::Ball:
      return "ball";
    case ToolPart::End:
      return "cutting end";
    case ToolPart::Flute:
      return "flute";
    case ToolPart::Shank:
      return "shank";
    default:
      return "holder";
  }
}

bool cuts(ToolPart part) {
  return part != ToolPart::Shank && part != ToolPart::Holder;
}

void require_valid(const ToolSection& s) {
  constexpr double kMost = 1e6;  // mm
  if (s.from >= 0.0 && s.from < s.to && s.to <= kMost &&
      std::min(s.radius_from, s.radius_to) >= 0.0 && s.radius_from <= kMost && s.radius_to <= kMost)
    return;
  throw InputError("ToolSection",
                   fmt::format("{} from {} to {} mm, radii {} and {} mm", name(s.part), s.from,
                               s.to, s.radius_from, s.radius_to),
                   "a section goes upward from 0 or more, has radii of 0 or more, and all are at "
                   "most 1e6 mm.");
}

void require_valid(const Shaft& shaft) {
  require_in_range("CuttingLength", shaft.cutting_length, 0.0, 1e6, "mm");
  require_in_range("ShankRadius", shaft.shank_radius, 0.0, 1e6, "mm");
  require_in_range("StickOut", shaft.stick_out, 0.0, 1e6, "mm");
  for (const Frustum& f : shaft.holder)
    require_valid(ToolSection{ToolPart::Holder, f.from, f.to, f.radius_from, f.radius_to});
}

}  // namespace patchmill

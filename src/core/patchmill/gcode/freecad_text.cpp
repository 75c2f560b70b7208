// Writing FreeCAD's internal G-code; see freecad_text.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/gcode/freecad_text.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace patchmill::gcode {

namespace {

// The text with the feed that `feed_of` (length [mm], own feed [mm/s]) says for each timed move.
template <class FeedOf>
std::string text_of(const ToolPath& path, const Decimals& decimals, const FeedOf& feed_of) {
  std::string text;
  text.reserve(path.moves.size() * 56);
  const auto out = std::back_inserter(text);
  const int d = decimals.count();
  Vec3 from = path.start.tip;
  for (const Move& move : path.moves) {
    stop_point();
    const Vec3& p = move.end.tip;
    if (move.kind == MoveKind::Rapid) {
      fmt::format_to(out, "G0 X{:.{}f} Y{:.{}f} Z{:.{}f}\n", p.x(), d, p.y(), d, p.z(), d);
    } else {
      const double length = (p - from).norm();
      const double feed = feed_of(length, length / duration(move, path.spindle));
      if (feed > 0.0)
        fmt::format_to(out, "G1 X{:.{}f} Y{:.{}f} Z{:.{}f} F{:.9f}\n", p.x(), d, p.y(), d, p.z(), d,
                       feed);
    }
    from = p;
  }
  return text;
}

}  // namespace

std::string freecad_text(const ToolPath& path, double feed, const Decimals& decimals) {
  require_positive("Feed", feed, "mm/s");
  return text_of(path, decimals, [&](double length, double own) {
    if (!(std::abs(own - feed) <= 1e-6 * feed) && length > 0.0)
      throw InputError("Feed", fmt::format("{} mm/s", own),
                       fmt::format("the path is not of constant feed {} mm/s.", feed));
    return feed;
  });
}

std::string freecad_text(const ToolPath& path, const Decimals& decimals) {
  return text_of(path, decimals, [](double length, double own) {
    if (!(length > 0.0)) return 0.0;
    require_positive("Feed", own, "mm/s");
    return own;
  });
}

}  // namespace patchmill::gcode

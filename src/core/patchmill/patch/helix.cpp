// Helical order on patches of any shape; see helix.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/helix.h"

#include "patchmill/geometry/error.h"

#include <algorithm>

namespace patchmill::patch {

std::int64_t point_count(PatchShape shape, PatchSize size) {
  return traits(shape).point_count(size);
}

void require_valid(PatchShape shape, PatchSize size) {
  const ShapeTraits& t = traits(shape);
  require_in_range("PatchSide", size.side, t.least.side, t.greatest.side, t.size_unit);
  if (t.two_sided)
    require_in_range("PatchSideAcross", size.across, t.least.across, t.greatest.across,
                     t.size_unit);
}

std::vector<LatticePoint> patch_helix(PatchShape shape, PatchSize size, HelixOrder order, bool down,
                                      int turn) {
  require_valid(shape, size);
  const ShapeTraits& t = traits(shape);
  std::vector<LatticePoint> path = t.helix(size);
  for (LatticePoint& p : path) {
    for (int i = 0; i < turn; ++i) p = t.turned(size, p);
    if (down && t.inverted) p = t.inverted(size, p);
  }
  if (order == HelixOrder::Outward) std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace patchmill::patch

// Names and counts of dimple states; depth.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/dimple.h"

#include "patchmill/geometry/error.h"

namespace patchmill::patch {

const char* name(DimpleState state) {
  switch (state) {
    case DimpleState::Cut:
      return "cut";
    case DimpleState::OffFace:
      return "off the face";
    case DimpleState::TooSteep:
      return "too steep";
    case DimpleState::ToolTip:
      return "tool tip";
    case DimpleState::Undercut:
      return "undercut";
    case DimpleState::NearEdge:
      return "near an edge";
    case DimpleState::Sliver:
      return "sliver";
    case DimpleState::Masked:
      return "masked";
    case DimpleState::NoFacet:
      return "no facet";
    case DimpleState::OffNet:
      return "off the net";
    case DimpleState::Crowded:
      return "crowded";
  }
  return "?";
}

void sink(Dimples& dimples, double depth) {
  require_in_range("Depth", depth, 0.0, 1e3, "mm");
  for (Dimple& dimple : dimples) dimple.depth = depth;
}

std::array<std::int64_t, kDimpleStates> count_states(const Dimples& dimples) {
  std::array<std::int64_t, kDimpleStates> count{};
  for (const Dimple& dimple : dimples) ++count[static_cast<std::size_t>(dimple.state)];
  return count;
}

}  // namespace patchmill::patch

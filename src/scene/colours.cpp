// The colour tables; see colours.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/colours.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace patchmill::scene {
namespace {

using Rgb = std::array<double, 3>;

// Nodes of the scale at equal steps; lightness rises by the same amount from each to the next.
constexpr std::array<Rgb, 6> kScale{{{0.18, 0.09, 0.38},
                                     {0.16, 0.27, 0.56},
                                     {0.11, 0.45, 0.56},
                                     {0.16, 0.63, 0.48},
                                     {0.51, 0.79, 0.28},
                                     {0.98, 0.91, 0.25}}};

Rgba packed(const Rgb& colour) {
  Rgba word = 0;
  for (const double channel : colour)
    word = (word << 8) | static_cast<Rgba>(std::lround(255.0 * channel));
  return (word << 8) | 0xffu;
}

}  // namespace

Rgba scale_colour(double share) {
  if (std::isnan(share)) return 0xd9d9d9ff;
  const double place = std::clamp(share, 0.0, 1.0) * (kScale.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(place), kScale.size() - 2);
  const double t = place - static_cast<double>(low);
  Rgb mixed{};
  for (std::size_t i = 0; i < 3; ++i)
    mixed[i] = (1.0 - t) * kScale[low][i] + t * kScale[low + 1][i];
  return packed(mixed);
}

Rgba state_colour(patch::DimpleState state) {
  switch (state) {
    case patch::DimpleState::Cut:
      return 0x0072b2ff;
    case patch::DimpleState::OffFace:
      return 0xb0b0b0ff;
    case patch::DimpleState::TooSteep:
      return 0xd55e00ff;
    case patch::DimpleState::ToolTip:
      return 0xcc79a7ff;
    case patch::DimpleState::Undercut:
      return 0x7f3b08ff;
    case patch::DimpleState::NearEdge:
      return 0xe69f00ff;
    case patch::DimpleState::Sliver:
      return 0xf0e442ff;
    case patch::DimpleState::Masked:
      return 0xe0e0e0ff;
    case patch::DimpleState::NoFacet:
      return 0x882255ff;
    case patch::DimpleState::OffNet:
      return 0x909090ff;
    case patch::DimpleState::Crowded:
      return 0x44aa99ff;
  }
  return 0x000000ff;
}

Rgba move_colour(MoveKind kind) {
  switch (kind) {
    case MoveKind::Rapid:
      return 0xd55e00ff;
    case MoveKind::Link:
      return 0xe69f00ff;
    case MoveKind::Cut:
      return 0x009e73ff;
  }
  return 0x000000ff;
}

}  // namespace patchmill::scene

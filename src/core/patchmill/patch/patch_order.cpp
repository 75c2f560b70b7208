// Patches in milling order; see patch_order.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/patch_order.h"

#include "patchmill/geometry/error.h"

#include <algorithm>

#include <fmt/format.h>

namespace patchmill::patch {

std::vector<int> milled_patches(const Dimples& dimples) {
  std::vector<int> patches;
  for (const Dimple& dimple : dimples)
    if (dimple.state == DimpleState::Cut && (patches.empty() || patches.back() != dimple.patch))
      patches.push_back(dimple.patch);
  return patches;
}

Dimples from_patch(const Dimples& dimples, int first) {
  const std::vector<int> patches = milled_patches(dimples);
  if (first < 1 || static_cast<std::size_t>(first) > patches.size())
    throw InputError("FirstPatch", std::to_string(first),
                     fmt::format("the texture has the patches 1 to {}.", patches.size()));
  const int patch = patches[static_cast<std::size_t>(first) - 1];
  const auto begin = std::find_if(dimples.begin(), dimples.end(), [patch](const Dimple& dimple) {
    return dimple.state == DimpleState::Cut && dimple.patch == patch;
  });
  return Dimples(begin, dimples.end());
}

}  // namespace patchmill::patch

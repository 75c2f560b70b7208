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

Dimples up_to_patch(const Dimples& dimples, int last) {
  const auto count = static_cast<int>(milled_patches(dimples).size());
  if (last < 1 || last > count)
    throw InputError("LastPatch", std::to_string(last),
                     fmt::format("the texture has the patches 1 to {}.", count));
  if (last == count) return dimples;
  const Dimples after = from_patch(dimples, last + 1);
  const Dimples before(dimples.begin(), dimples.end() - static_cast<std::ptrdiff_t>(after.size()));
  const auto cut = [](const Dimple& dimple) { return dimple.state == DimpleState::Cut; };
  return Dimples(before.begin(), std::find_if(before.rbegin(), before.rend(), cut).base());
}

}  // namespace patchmill::patch

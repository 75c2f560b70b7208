// The patches of a texture in the order in which they are milled, numbered from 1: what an operator counts, and from
// where a program that was stopped goes on.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/dimple.h"

namespace patchmill::patch {

/// Dimple::patch of the patches that have dimples to be cut, in milling order, each once.
std::vector<int> milled_patches(const Dimples& dimples);

/// The dimples from the first one that is cut of the patch number `first` (from 1) in milling order on. Errors:
/// InputError naming FirstPatch (1 .. number of milled patches).
Dimples from_patch(const Dimples& dimples, int first);

/// The dimples up to the last one that is cut of the patch number `last` (from 1) in milling order. Errors: InputError
/// naming LastPatch (1 .. number of milled patches).
Dimples up_to_patch(const Dimples& dimples, int last);

}  // namespace patchmill::patch

// The path of Matsuda's free form (Matsuda 2008, section 2.2): straight on along the helix at constant
// feed, one tooth every f_z = F / (N S), with nothing between marks but the helix' own corners. And the
// phase difference of neighbouring passes as the path really makes it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/patch/free_texture.h"
#include "patchmill/patch/phase_difference.h"
#include "patchmill/sync/constant_feed.h"

namespace patchmill::sync {

/// The path of a fixed vertical tool over all Cut marks of `dimples`, which are those of `texture` with
/// some left out. Marks are one tooth apart; links, to the next patch and over marks left out, arrive
/// with a tooth on the mark (Eq. 3 of Xu & Sasahara 2016). Positions lie on `decimals`; what rounding
/// takes from the length of the path is made up for at the next mark, along the side. `feed` is used as
/// given, not rounded.
/// Errors: as constant_feed_path(), and InputError naming FeedPerTooth if feed / (N S) is not the
/// texture's by one part in 10⁶, ExtraTurns or SameFlute if the rule is not one tooth of any flute, or Dimples
/// if they are not the texture's.
ToolPath free_form_path(const patch::FreeTexture& texture, const patch::Dimples& dimples,
                        const Tool& tool, const Spindle& spindle, const ConstantFeed& rule,
                        const Decimals& decimals);

/// Phase differences of neighbouring passes of patch number `patch` as a path makes them: teeth are
/// counted along its moves from the patch's first mark on, where each passes is brought back to the
/// patch's plane, and measure_phase() compares the passes. Knows the path's moves and the helix' sides,
/// not where marks were planned. `dimples` gives the depth. Moves of unknown duration end it. Errors:
/// InputError naming Dimples (not the texture's), Patch or Dimple (a number that there is not).
std::vector<patch::MeasuredPhase> measure_phase(const ToolPath& path,
                                                const patch::FreeTexture& texture,
                                                const patch::Dimples& dimples, int patch);

}  // namespace patchmill::sync

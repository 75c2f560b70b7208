"""Safe and clearance height: as they are given, or, where they are not the user's own, above what is milled.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import replace

from _patchmill import DimpleState, InputError

ABOVE = 1.0  # mm over the highest dimple; links between dimples may ask for more
TRIES = 8


def plan_above(given, dimples, remarks, make):
    """make(TextureInput) for the heights that are given, or, if they are too low and follow the part, for the
    lowest of a few greater ones that are not; that is said in `remarks`.

    Raises InputError naming SafeHeight if the heights are the user's own, or nothing helps."""
    try:
        return make(given)
    except InputError as error:
        if error.property not in ("SafeHeight", "ClearanceHeight") or not given.heights_follow:
            raise
        refused = error
    cut = dimples.positions[dimples.states == DimpleState.CUT]
    safe = max(given.safe_height, cut[:, 2].max() + given.lift + ABOVE)
    for attempt in range(TRIES):
        higher = replace(
            given, safe_height=safe, clearance_height=max(given.clearance_height, safe + ABOVE)
        )
        try:
            made = make(higher)
        except InputError as error:
            if error.property != "SafeHeight":
                raise
            refused = error
            safe += 2.0**attempt
            continue
        remarks.append("The safe height was raised to Z %.4g mm, above what is milled." % safe)
        return made
    raise refused

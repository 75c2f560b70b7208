"""Matsuda's free form (Matsuda 2008, section 2.2): side, cross-feed and feed per tooth are independent, and
whether marks stand in rows follows from them (docs/matsuda-condition.md).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import replace

from typing import Any, Callable, Optional

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill.textures import strategies
from patchmill.textures.division import divide_through_plane, sampler_on


def place(given: Any, progress: Optional[Callable[[float], bool]] = None) -> Optional[dict]:
    """The fields of a PlacedTexture in free form, as a dict; None if `progress` returned False."""
    if given.texture_kind != "Overlapping":
        raise InputError("TextureKind", given.texture_kind, "the free form's marks overlap: choose so.")
    given = _with_feed(given)
    if not given.free_side > 0.0:
        raise InputError("FreeSide", "%g mm" % given.free_side, "give a length greater than zero.")
    patch = core.FreePatch(
        given.patch_shape, given.free_side, given.cross_feed, given.feed_per_tooth
    )
    remarks: list[str] = []
    plane, sampler, low, high = sampler_on(given, remarks)
    divided = _stands(given, patch, plane, sampler, low, high, progress)
    if divided is None:
        return None
    stands, lattice = divided
    outward = given.helix_order == "Outward"
    corners_fit = given.plane_fit == "Corners"
    placed = core.place_free(
        patch, outward, stands, lattice, plane, sampler, corners_fit, progress
    )
    if placed is None:
        return None
    free, dimples = placed
    return {
        "input": given,
        "plane": plane,
        "division": stands,
        "dimples": dimples,
        "size": patch.size(given.tool.radius),
        "lattice": lattice,
        "extent": (low, high),
        "free": free,
        "remarks": remarks,
    }


def _with_feed(given):
    """The input with its feed as it is posted, and the feed per tooth and spacing that this makes."""
    teeth_per_second = given.tool.flutes * given.spindle.speed
    if given.feed_per_tooth < 0.0:
        raise InputError("FeedPerTooth", "%g mm" % given.feed_per_tooth, "give zero or more.")
    feed = given.feed_per_tooth * teeth_per_second or given.feed
    feed = core.posted_feed(feed, given.decimals)
    if not feed > 0.0:
        raise InputError("Feed", "%g mm/min" % (60.0 * feed), "give the tool controller a feed.")
    f_z = feed / teeth_per_second
    return replace(given, feed=feed, feed_per_tooth=f_z, spacing=f_z)


def _stands(given, patch, plane, sampler, low, high, progress):
    """Where the patches stand, and the lattice laid on the surface or None; None if `progress` returned
    False."""
    pattern = patch.stands()
    if given.mapping != "Projected":
        return divide_through_plane(given, pattern, plane, sampler, low, high, progress)
    if given.patches_x or given.patches_y:
        return core.patch_block(pattern, given.patches_x, given.patches_y), None
    return core.cover(pattern, low, high), None


def pacing(given, free, dimples, rule, machine):
    """strategies.Pacing of a free form: constant feed, straight on along the helix."""
    if given.strategy != strategies.CONSTANT:
        raise InputError(
            "Strategy",
            given.strategy,
            "in the free form the phase follows from the feed: choose '%s'." % strategies.CONSTANT,
        )

    def path_of(spindle):  # at another speed the feed goes with it, so that the marks stay
        feed = given.feed_per_tooth * given.tool.flutes * spindle.speed
        return core.free_form_path(
            free,
            dimples,
            given.tool,
            spindle,
            feed,
            given.safe_height,
            given.clearance_height,
            given.decimals,
        )

    return strategies.make(given, dimples, rule, machine, path_of)


def phase_differences(plan, path=None):
    """How neighbouring passes stand to one another on `path`, the planned one if None: a dict with arrays
    lap, side, measured and predicted [teeth] of the patch of which most marks are cut, and with

        state              Matsuda's condition in one sentence
        drift              predicted change from a pass to the next inside it [teeth]
        measured_drift     the same, measured; NaN if the patch has too few passes
        largest_miss       largest difference of measured and predicted, NaN if there is none"""
    cut = plan.dimples.states == core.DimpleState.CUT
    patches = plan.dimples.patches
    patch = int(np.bincount(patches[cut], minlength=len(plan.free)).argmax())
    found = core.free_form_phases(path or plan.path, plan.free, plan.dimples, patch)
    misses = _wrapped(found["measured"] - found["predicted"])
    changes = []
    for side in np.unique(found["side"]):
        here = np.flatnonzero(found["side"] == side)
        here = here[np.argsort(found["lap"][here])]
        whole = np.diff(found["lap"][here]) == 1
        changes.extend(_wrapped(np.diff(found["measured"][here]))[whole])
    drift = plan.free.patch.drift_per_lap()
    # changes are known but for whole teeth: nearest to one another, not to zero
    around = [drift + _wrapped(c - drift) for c in changes]
    found["state"] = plan.free.patch.state()
    found["drift"] = drift
    found["measured_drift"] = float(np.mean(around)) if around else float("nan")
    found["largest_miss"] = float(np.abs(misses).max()) if len(misses) else float("nan")
    return found


def _wrapped(teeth):
    return teeth - np.round(teeth)

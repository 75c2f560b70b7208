"""The advisor of Matsuda's free form, for macros and panels (docs/matsuda-condition.md).

    for p in patchmill.advise(diameter=2, flutes=2, speed=1000, side=14, spacing=0.5, cross_feed=0.505):
        print(p.kept, p.changes, p.feed, p.state)

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import dataclass

import _patchmill as core
from _patchmill import InputError


@dataclass
class Proposal:
    """Sides of a patch whose cutter marks stand in rows. Lengths in mm, feed in mm/min. `kept` is what the
    proposal leaves as wished, `changes` says the rest in words, `change` is the largest one, relative."""

    kept: str
    side: float
    cross_feed: float
    feed_per_tooth: float
    feed: float
    ridge_height: float
    state: str
    change: float
    changes: str


def _wish(diameter, flutes, speed, side, spacing, ridge_height, cross_feed, shape, array):
    if not diameter > 0.0:
        raise InputError("Diameter", "%g mm" % diameter, "give a finite value greater than zero.")
    return core.MarkWish(
        core.BallEndMill(0.5 * diameter, flutes),
        speed / 60.0,
        shape,
        side,
        array,
        feed_per_tooth=spacing,
        ridge_height=ridge_height,
        cross_feed=cross_feed,
    )


def advise(
    diameter,
    flutes,
    speed,
    side,
    spacing=None,
    ridge_height=None,
    cross_feed=None,
    shape="Square",
    array="Square",
):
    """The aligned patches next to a wish, a list of Proposal, the one that changes least first.

    `diameter` of the ball [mm], `speed` in rpm, `side` of the patch [mm]; either `spacing`, the wanted
    distance of marks along the path, or `ridge_height`, the highest point that may stay between them [mm];
    `cross_feed` [mm] if not the spacing itself. `shape`: Square, Hexagon or Triangle; `array`: Square or
    Staggered. Raises InputError naming what is wrong."""
    wish = _wish(diameter, flutes, speed, side, spacing, ridge_height, cross_feed, shape, array)
    proposals = core.advise(wish)
    for proposal in proposals:
        proposal["feed"] *= 60.0
    return [Proposal(**proposal) for proposal in proposals]


def mark_state(
    diameter, flutes, speed, side, spacing, cross_feed=None, shape="Square", array="Square"
):
    """The array that marks make as wished, in one sentence; arguments as for advise()."""
    return _wish(diameter, flutes, speed, side, spacing, None, cross_feed, shape, array).state()


def advise_operation(obj, array="Square"):
    """advise() for a PlanarTexture in free form: its side, cross-feed, feed per tooth and tool."""
    given = obj.Proxy.texture_input(obj)
    teeth_per_second = given.tool.flutes * given.spindle.speed
    return advise(
        2.0 * given.tool.radius,
        given.tool.flutes,
        60.0 * given.spindle.speed,
        given.free_side,
        spacing=given.feed_per_tooth or given.feed / teeth_per_second,
        cross_feed=given.cross_feed,
        shape=given.patch_shape,
        array=array,
    )


def take(obj, proposal):
    """Gives a PlanarTexture in free form what a Proposal says."""
    obj.FreeSide, obj.CrossFeed = proposal.side, proposal.cross_feed
    obj.FeedPerTooth = proposal.feed_per_tooth

"""How good a texture will be: single patches of it, planned and simulated as the machine's model runs them.

A texture is milled patch by patch, so that one patch simulated alone says what each of its kind is worth. The
patches that are looked at stand for equal parts of the dimples, from the flattest to the steepest place:
quality depends on the tilt between tool axis and face more than on anything else. They lie away from the
borders of
the faces, where there are such places: along a border the tip leaves marks that no neighbour takes away.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import replace
from functools import partial

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill.advice.found import GOOD, Assessment, PatchQuality
from patchmill.textures import tool_posture
from patchmill.textures.plan import place_texture, plan_texture


WINDOW = 8  # spacings along the side of what is simulated
ABOUT = 0.95  # of the most neighbours: a place in the middle


def with_simulation(simulate):
    """assess() as a function of a TextureInput alone; `simulate` is patchmill.simulate."""
    return partial(assess, simulate)


def assess(simulate, given, count=5, progress=None, first=None):
    """Assessment of a TextureInput from `count` patches; None if `progress` (fraction -> bool) returned
    False. Raises InputError where no dimple can be placed.

    `first`: the number of a patch that is looked at before the others; if it is not GOOD, they are not looked
    at, and count as it does."""
    placed = place_texture(given)
    counts = dict(placed.dimples.counts())
    cut = placed.dimples.states == core.DimpleState.CUT
    on_faces = sum(n for name, n in counts.items() if name not in ("off the face", "off the net", "masked"))
    found = Assessment(int(cut.sum()), float(cut.sum()) / max(1, on_faces), counts)
    if not cut.any() or placed.free is not None:
        return found
    tilts = _tilts(placed)
    numbers = np.flatnonzero(cut)
    order = numbers[np.argsort(tilts[numbers], kind="stable")]
    middles = _middles(order, _neighbours(placed, cut), count)
    made: dict[int, PatchQuality] = {}
    for k in sorted(range(count), key=lambda k: k != first):
        if progress and not progress(len(made) / count):
            return None
        number = middles[k]
        made[k] = _patch(simulate, given, placed, number, float(np.degrees(tilts[number])))
        if k == first and made[k].quality < GOOD:
            break
    found.patches = [made[k] for k in sorted(made)]
    rates = [patch.seconds_per_dimple for patch in found.patches if patch.seconds_per_dimple]
    found.seconds = float(np.mean(rates)) * found.dimples if rates else 0.0
    return found


def _neighbours(placed, cut):
    """How many dimples are milled in a square of WINDOW spacings around each lattice point."""
    places = np.where(np.isfinite(placed.places()), placed.places(), 0.0)
    cells = np.rint(places / placed.input.spacing).astype(int)
    half = WINDOW // 2
    cells += half + 1 - cells.min(axis=0)
    count = np.zeros(cells.max(axis=0) + half + 1, dtype=int)
    np.add.at(count, tuple(cells[cut].T), 1)
    total = count.cumsum(axis=0).cumsum(axis=1)
    (x0, y0), (x1, y1) = (cells - half - 1).T, (cells + half).T
    return total[x1, y1] - total[x0, y1] - total[x1, y0] + total[x0, y0]


def _middles(order, neighbours, count):
    """Of each of `count` equal parts of `order`, the number nearest to the part's middle among those that
    have about as many neighbours as any of the part."""
    found = []
    for part in np.array_split(order, count) if len(order) >= count else [order] * count:
        full = neighbours[part] >= ABOUT * neighbours[part].max()
        ranks = np.flatnonzero(full)
        found.append(int(part[ranks[np.abs(ranks - len(part) // 2).argmin()]]))
    return found


def _tilts(placed):
    """Angle between tool axis and face at each dimple [rad]."""
    if tool_posture.is_vertical(placed.input):
        return np.asarray(core.tilts(placed.dimples, (0.0, 0.0, 1.0)))
    cosine = np.sum(tool_posture.axes(placed.input, placed.dimples) * placed.dimples.normals, axis=1)
    return np.arccos(np.clip(cosine, -1.0, 1.0))


def _patch(simulate, given, placed, number, tilt):
    """PatchQuality of one patch whose middle is where dimple `number` of a PlacedTexture is."""
    position = tuple(float(c) for c in placed.dimples.positions[number])
    looked = PatchQuality(position, tilt)
    try:
        plan = plan_texture(replace(given, origin=position, patches_x=1, patches_y=1, minimum_dimples=0))
        spacing = plan.input.spacing
        half = spacing * min(0.5 * WINDOW, 0.5 * given.patch_side)
        window = ((-half, -half), (half, half))
        result = simulate(plan, machine=plan.machine, window=window)
    except InputError as error:
        looked.problem = str(error)
        return looked
    looked.quality = float(result.quality)
    verdict = plan.pacing.verdict
    looked.holds = verdict is None or verdict.holding in ("holds", "unknown")
    looked.array = result.alignment["state"]
    looked.seconds_per_dimple = plan.path.statistics()["timed_seconds"] / max(1, plan.counts["cut"])
    return looked

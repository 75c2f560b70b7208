"""Which part of a texture's area is as planned, dimple by dimple. Each milled dimple has a cell, a square of
one spacing seen along the texture's direction; a mark that nobody planned is in the cell of the dimple that
is nearest to it. So a row of marks along a border spoils the cells of the outermost row, and no others.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math

import _patchmill as core
import numpy as np

from patchmill.advice.found import GOOD

WINDOW = 8  # spacings along the side of what is simulated
GOLDEN = 0.5 * (math.sqrt(5.0) - 1.0)


def good_cells(result):
    """(n,) bool of a SimulatedTexture's planned dimples, in the order of found["dimple"]: whether the dimple
    is there, no farther from its place than quality GOOD allows, and alone in its cell."""
    found, spacing = result.found, result.plan.input.spacing
    moved = np.linalg.norm(np.asarray(found["moved"]).reshape(-1, 2), axis=1)
    good = (np.asarray(found["found"]) >= 0) & (1.0 - (4.0 * moved / spacing) ** 2 >= GOOD)
    extra = np.asarray(found["places"]).reshape(-1, 2)[np.asarray(found["extra"], dtype=int)]
    planned = result.plan.places()[np.asarray(found["dimple"], dtype=int)]
    for place in extra if len(planned) else ():
        good[np.linalg.norm(planned - place, axis=1).argmin()] = False
    return good


def areas(plan, numbers):
    """(n,) areas [mm²] of the faces in the cells of dimples, by their numbers in a PlannedTexture: where the
    lattice is projected a cell is the larger the steeper the faces are."""
    area = np.full(len(numbers), plan.input.spacing**2)
    if plan.input.mapping == "Projected":
        area /= np.maximum(-(plan.dimples.normals[numbers] @ np.asarray(plan.plane.direction)), 1e-3)
    return area


def good_share(results):
    """Of the area in the cells of some SimulatedTextures, 0 to 1, what is as planned; NaN where they have no
    dimple."""
    good = total = 0.0
    for result in results:
        area = areas(result.plan, np.asarray(result.found["dimple"], dtype=int))
        good += float(area[good_cells(result)].sum())
        total += float(area.sum())
    return good / total if total else float("nan")


def squares(plan, most):
    """Up to `most` windows, WINDOW spacings wide or about so, spread over the milled dimples of a plan."""
    places = plan.places()[plan.dimples.states == core.DimpleState.CUT]
    spacing = plan.input.spacing
    low, high = places.min(axis=0) - 0.5 * spacing, places.max(axis=0) + 0.5 * spacing
    count = np.maximum(1, np.rint((high - low) / (WINDOW * spacing))).astype(int)
    sides = (high - low) / count
    there = np.unique(np.minimum(((places - low) / sides).astype(int), count - 1), axis=0)
    chosen = np.argsort((GOLDEN * np.arange(len(there))) % 1.0)[:most]  # in no step that meets one side only
    corners = low + there[chosen] * sides
    return [(tuple(corner), tuple(corner + sides)) for corner in corners]


def quality_in(simulate, plan, windows):
    """(quality, part of the area that is as planned) of all that lies in some windows of a plan."""
    results = [simulate(plan, machine=plan.machine, window=window) for window in windows]
    marks = [len(result.found["dimple"]) + len(result.found["extra"]) for result in results]
    quality = np.average([result.quality for result in results], weights=marks)
    return float(quality), good_share(results)


def steepest(plan):
    """Angle [rad] of the milled dimples' normals to where the texture is projected from."""
    normals = plan.dimples.normals[plan.dimples.states == core.DimpleState.CUT]
    return float(np.arccos(np.clip(-(normals @ np.asarray(plan.plane.direction)).max(), -1.0, 1.0)))

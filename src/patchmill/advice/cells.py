"""Which part of a texture's area is as planned, dimple by dimple. Each milled dimple has a cell, a square of
one spacing seen along the texture's direction; a mark that nobody planned is in the cell of the dimple that
is nearest to it. So a row of marks along a border spoils the cells of the outermost row, and no others.

Many values are tried, and some change nothing, as a margin on a closed face: Once simulates no plan twice.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import hashlib
import math
import threading
from collections import OrderedDict
from types import SimpleNamespace

import _patchmill as core
import numpy as np

from patchmill.advice.found import GOOD

WINDOW = 8  # spacings along the side of what is simulated
GOLDEN = 0.5 * (math.sqrt(5.0) - 1.0)
KEPT = 500  # simulations, each of a patch, a square or a small whole
# Fields of a TextureInput that say which dimples are milled, and nothing of how: the dimples tell it
PLACING = ("margin", "minimum_dimples", "minimum_tilt", "avoid_rubbing", "mask")
PLAIN = (str, int, float, bool, tuple, list, type(None))


class Once:
    """patchmill.simulate of plans with their own path, each that comes out equal to one before it once. What
    is kept has the `plan` it is asked for, `quality`, `alignment` and `found` of a SimulatedTexture, and no
    relief. For any thread."""

    def __init__(self, simulate):
        self.simulate = simulate
        self._kept: OrderedDict[bytes, SimpleNamespace] = OrderedDict()
        self._lock = threading.Lock()

    def __call__(self, plan, **options):
        key = _key(plan, options)
        with self._lock:
            kept = self._kept.get(key)
            if kept is not None:
                self._kept.move_to_end(key)
        if kept is not None:
            return SimpleNamespace(plan=plan, **vars(kept))
        return self._made(key, plan, options)

    def afresh(self, plan, **options):
        """The SimulatedTexture itself, with its relief, whether or not there was one; it is kept as well."""
        return self._made(_key(plan, options), plan, options)

    def _made(self, key, plan, options):
        made = self.simulate(plan, **options)
        if made is not None:  # not cancelled
            kept = SimpleNamespace(quality=made.quality, alignment=made.alignment, found=made.found)
            with self._lock:
                self._kept[key] = kept
                while len(self._kept) > KEPT:
                    self._kept.popitem(last=False)
        return made


def _key(plan, options):
    """Of all that the simulation of a PlannedTexture follows from, with some `options` of simulate."""
    given, path, machine = plan.input, plan.path, options.get("machine")
    found = hashlib.blake2b(digest_size=16)
    for array in (path.start, path.tips, path.axes, path.turns, path.kinds, path.dimples):
        found.update(np.ascontiguousarray(array).tobytes())
    for name in ("states", "positions", "normals", "lattice"):
        found.update(np.ascontiguousarray(getattr(plan.dimples, name)).tobytes())
    if plan.posture is not None:
        found.update(np.ascontiguousarray(plan.posture.work.joints).tobytes())
    plain = [(name, value) for name, value in vars(given).items() if isinstance(value, PLAIN)]
    values = [(name, value) for name, value in plain if name not in PLACING]
    plane = [tuple(getattr(plan.plane, name)) for name in ("origin", "x_axis", "y_axis", "direction")]
    tool = given.tool.radius, given.tool.flutes, given.spindle.speed, given.spindle.sense
    timed = path.statistics()["timed_seconds"]
    others = {name: value for name, value in options.items() if name != "machine"}
    runs = machine and getattr(machine, "data", machine)
    found.update(repr((values, plane, tool, timed, others, runs)).encode())
    return found.digest()


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

"""What helps where a texture cannot be good: each remedy is tried before it is offered.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass, replace

import numpy as np
import Part
from _patchmill import DimpleState, InputError
from FreeCAD import Rotation, Vector

from patchmill.advice.found import GOOD, Assessment
from patchmill.machine import machines
from patchmill.textures.plan import place_texture, plan_texture

LEAST_GAIN = 0.02  # of the faces, that a remedy must make good besides
ANGLES = (20.0, 30.0)  # that a part or a tool is leant by [degrees]
BEST_TILTS = (14.0, 60.0)  # between tool axis and face, at which flutes cut well [degrees]


@dataclass
class Remedy:
    """`kind`: values, incline, lean, leave out. `fields`: of a TextureInput; `axis` and `angle` [degrees]:
    how the part is turned about its middle, or the tool the other way."""

    kind: str
    fields: dict
    assessment: Assessment
    axis: tuple = None
    angle: float = 0.0


def turned(given, axis, angle):
    """`given` with its faces turned by `angle` [degrees] about `axis` through the origin."""
    rotation = Rotation(Vector(*axis), angle)
    breps = []
    for text in given.breps:
        shape = Part.Shape()
        shape.importBrepFromString(text)
        shape.rotate(Vector(0, 0, 0), Vector(*axis), angle)
        breps.append(shape.exportBrepToString())
    origin = None if given.origin is None else tuple(rotation.multVec(Vector(*given.origin)))
    top = max(_top(text) for text in breps)
    above = given.safe_height - max(_top(text) for text in given.breps)
    clear = given.clearance_height - given.safe_height
    safe = top + above
    return replace(given, breps=breps, origin=origin, safe_height=safe, clearance_height=safe + clear)


def _top(text):
    shape = Part.Shape()
    shape.importBrepFromString(text)
    return shape.BoundBox.ZMax


def leanings(normals, angles=ANGLES):
    """(fraction of normals at good tilts, angle, axis) for axes in the plane, the best first; `axis` turns
    the part, or the tool the other way."""
    found = []
    for angle in angles:
        for k in range(8):
            azimuth = math.pi * k / 4.0
            axis = (math.cos(azimuth), math.sin(azimuth), 0.0)
            up = Rotation(Vector(*axis), -angle).multVec(Vector(0, 0, 1))
            tilts = np.degrees(np.arccos(np.clip(normals @ np.array(tuple(up)), -1.0, 1.0)))
            good = float(((tilts > BEST_TILTS[0]) & (tilts < BEST_TILTS[1])).mean())
            found.append((round(good, 3), -angle, -k, axis))
    return [(good, -angle, axis) for good, angle, _, axis in sorted(found, reverse=True)]


def face_normals(given):
    """(n, 3) normals of all lattice points that lie on the faces."""
    dimples = place_texture(replace(given, minimum_tilt=0.01, avoid_rubbing=False, margin=0.0)).dimples
    normals = np.asarray(dimples.normals)
    on_faces = ~np.isin(dimples.states, (DimpleState.OFF_FACE, DimpleState.OFF_NET))
    return normals[on_faces & np.isfinite(normals).all(axis=1)]


class Finder:
    """Looks for remedies. `assess`: see assessment.with_simulation; `choose`: choice.choose with it.
    `free`, `can_incline`: the tool controller, and how the part lies, may be changed, too; `chosen`: the
    texture's values are those of choose() already."""

    def __init__(self, assess, choose, free=False, can_incline=True, chosen=False):
        self.assess, self.choose, self.free = assess, choose, free
        self.can_incline, self.chosen = can_incline, chosen

    def find(self, given, progress=None):
        """The Remedies that were tried and help, the best first; None if `progress` (fraction -> bool)
        returned False."""
        normals = face_normals(given)
        if not len(normals):
            return []
        best = leanings(normals)[0]
        machine = machines.load(given.machine) if given.machine else None
        tries = [] if self.chosen else [lambda: self._values(given)]
        if self.can_incline:
            tries.append(lambda: self._incline(given, best))
        if machine is not None and machine.rotary_letters:
            tries.append(lambda: self._lean(given, best))
        tries.append(lambda: self.leave_out(given))
        now = self._good_fraction(given)
        found = []
        for number, attempt in enumerate(tries):
            if progress and not progress(number / len(tries)):
                return None
            try:
                remedy = attempt()
            except InputError:
                continue
            if remedy is not None and remedy.assessment.good_fraction > now + LEAST_GAIN:
                found.append(remedy)
        return sorted(found, key=lambda r: -r.assessment.good_fraction)

    def _good_fraction(self, given):
        """Of the texture as it is; 0 where it cannot be made."""
        try:
            plan_texture(given)
            return self.assess(given, 3).good_fraction
        except InputError:
            return 0.0

    def _values(self, given):
        choice = self.choose(given, self.free)
        return choice and Remedy("values", choice.fields, choice.assessment)

    def _incline(self, given, leaning):
        _, angle, axis = leaning
        choice = self.choose(turned(given, axis, angle), self.free)
        return choice and Remedy("incline", choice.fields, choice.assessment, axis, angle)

    def _lean(self, given, leaning):
        """The tool leant as the part would be, the other way round."""
        _, angle, axis = leaning
        up = Rotation(Vector(*axis), -angle).multVec(Vector(0, 0, 1))
        fields = {"tool_axis_mode": "Fixed", "fixed_axis": tuple(up)}
        choice = self.choose(replace(given, **fields), self.free)
        fields.update(choice.fields if choice else {})
        return choice and Remedy("lean", fields, choice.assessment, axis, angle)

    def leave_out(self, given):
        """Remedy that leaves out what is too flat, or None: below the least tilt from which on all patches
        that were looked at are good."""
        found = self.assess(given, 7)
        flat = max((p.tilt for p in found.patches if p.quality < GOOD), default=None)
        good = [p.tilt for p in found.patches if p.quality >= GOOD and flat is not None and p.tilt > flat]
        if not good:
            return None
        fields = {"minimum_tilt": round(0.5 * (flat + min(good)), 1)}
        asked = replace(given, **fields)
        plan_texture(asked)
        return Remedy("leave out", fields, self.assess(asked, 3))

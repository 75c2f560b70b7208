"""What was found out about a texture: quality of single patches, and of the whole.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import dataclass, field
from typing import Optional

GOOD = 0.95  # of quality: the texture as planned, to the eye and to a profilometer
SMALL = 1500  # dimples; so many are simulated as a whole, of more a sample
GOOD_FRACTION = 0.95  # of the faces' dimples
MIN_GAIN = 0.02  # of the faces, that a remedy must make good besides
NEARLY = 0.93  # of what one setup reaches: leaning otherwise hardly gains


@dataclass
class PatchQuality:
    """One patch. `quality` is simulation's, 0 to 1; `problem` is a sentence instead, if it cannot be made."""

    position: tuple  # of its middle dimple [mm]
    tilt: float  # of the face to the tool axis there [degrees]
    quality: float = 0.0
    array: str = ""
    seconds_per_dimple: float = 0.0
    holds: bool = True  # the phase, as the machine's model says
    problem: str = ""
    fraction: float = 1.0  # of the dimples that it stands for


@dataclass
class Assessment:
    """What a texture comes to. Fractions are of the faces' lattice points; where the lattice is projected on
    the faces, times the part of their area that it is seen on."""

    dimples: int
    milled_fraction: float
    counts: dict
    patches: list = field(default_factory=list)  # PatchQuality, from the least to the greatest tilt
    seconds: float = 0.0  # of milling, about
    away_fraction: float = 0.0  # looks away from where the texture is projected from, or is too steep
    whole: Optional[float] = None  # quality of the whole texture, borders included, where it was simulated
    whole_area: Optional[float] = None  # of its milled area, what is as planned there (advice.cells)
    touches: bool = False  # the tool, its shank or holder runs into the part (advice.room)

    @property
    def good_fraction(self):
        """Of the faces: milled, and of GOOD quality."""
        if not self.patches:
            return 0.0
        good = sum(patch.fraction for patch in self.patches if patch.quality >= GOOD)
        return self.milled_fraction * good / sum(patch.fraction for patch in self.patches)

    @property
    def worth(self):
        """good_fraction; where the borders are bad, what they leave of it; 0 where the tool touches."""
        if self.touches:
            return 0.0
        if self.borders_are_good:
            return self.good_fraction
        area = 1.0 if self.whole_area is None else self.whole_area
        return min(self.good_fraction, self.whole, self.milled_fraction * area)

    @property
    def quality(self):
        """Of the worst patch that was looked at."""
        return min((patch.quality for patch in self.patches), default=0.0)

    @property
    def good(self):
        """Whether enough of the faces is good, borders included where they were looked at."""
        return self.good_fraction >= GOOD_FRACTION - 1e-9 and self.borders_are_good and not self.touches

    @property
    def remains_good(self):
        """Whether enough of what is milled is good, borders included, however much is left out."""
        good = self.good_fraction >= GOOD_FRACTION * self.milled_fraction - 1e-9
        return bool(self.patches) and good and self.borders_are_good and not self.touches

    @property
    def borders_are_good(self):
        as_planned = self.whole_area is None or self.whole_area >= GOOD_FRACTION
        return self.whole is None or (self.whole >= GOOD and as_planned)

    @property
    def problem(self):
        """Why there is a patch that cannot be made, or ''."""
        return next((patch.problem for patch in self.patches if patch.problem), "")


def largest_good_run(patches, ends_anywhere):
    """(first, end) of the slice of PatchQuality, in order of tilt, that are all good and stand for most; None
    where none is good. It reaches to the steepest if not `ends_anywhere`."""
    count = len(patches)
    runs = [
        (first, end)
        for first in range(count)
        for end in (range(first + 1, count + 1) if ends_anywhere else (count,))
        if all(patch.quality >= GOOD for patch in patches[first:end])
    ]
    return max(runs, key=lambda run: sum(p.fraction for p in patches[slice(*run)]), default=None)


def is_enough(found, reached):
    """Whether an Assessment leaves nothing to be wished for that one setup reaches."""
    part = reached < GOOD_FRACTION  # of faces that are reached whole nothing need be left
    return found.good or (part and found.remains_good and found.good_fraction >= NEARLY * reached)


def is_better(found, now):
    """Whether an Assessment helps, or leaves only what is good, beside that of the texture as it is; None
    where that cannot be made."""
    return _helps(found, None if now is None else now.worth) or (now is not None and leaves_good(found, now))


def leaves_good(found, now):
    """Whether all that is milled is good, as it is not `now`, and no less of the faces than that is."""
    return found.remains_good and not now.remains_good and found.good_fraction > now.good_fraction - MIN_GAIN


def _helps(found, now):
    """Whether an Assessment is more than MIN_GAIN better than what is good `now`; beside nothing at all
    (None) a texture helps whatever its borders."""
    return found.good_fraction > MIN_GAIN if now is None else found.worth > now + MIN_GAIN

"""What was found out about a texture: quality of single patches, and of the whole.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import dataclass, field

GOOD = 0.95  # of quality: the texture as planned, to the eye and to a profilometer
GOOD_FRACTION = 0.95  # of the faces' dimples


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


@dataclass
class Assessment:
    """What a texture comes to. Fractions are of all lattice points on the faces."""

    dimples: int
    milled_fraction: float
    counts: dict
    patches: list = field(default_factory=list)  # PatchQuality, from the least to the greatest tilt
    seconds: float = 0.0  # of milling, about

    @property
    def good_fraction(self):
        """Of the faces: milled, and of GOOD quality."""
        if not self.patches:
            return 0.0
        good = sum(1 for patch in self.patches if patch.quality >= GOOD)
        return self.milled_fraction * good / len(self.patches)

    @property
    def quality(self):
        """Of the worst patch that was looked at."""
        return min((patch.quality for patch in self.patches), default=0.0)

    @property
    def good(self):
        return self.good_fraction >= GOOD_FRACTION

    @property
    def problem(self):
        """Why there is a patch that cannot be made, or ''."""
        return next((patch.problem for patch in self.patches if patch.problem), "")

"""How good a texture is in one word, and why it is no better: what the head of the panel is coloured by.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from patchmill.advice.found import GOOD_FRACTION

GOOD, DOUBTFUL, BAD = "good", "doubtful", "bad"
# Why
LOST = "the machine does not hold the phase"
TOUCHES = "the tool runs into the part"
NOT_SIMULATED = "not simulated"
ALL = "as planned"
PHASE_UNKNOWN = "as planned if the machine holds the phase"
BORDERS = "short along the borders of the faces"
AWAY = "good as far as one setup reaches"
SHORT = "short of the faces"
HALF = 0.5  # of the faces, up to which a texture that is short is BAD


def judge(found, phase):
    """(GOOD, DOUBTFUL or BAD; why, one of the above) of an Assessment and of what is known about the phase: a
    _patchmill.Verdict, or None where no machine was named."""
    if phase is not None and phase.holding not in ("holds", "unknown"):
        return BAD, LOST
    if found.touches:
        return BAD, TOUCHES
    if not found.patches:
        return DOUBTFUL, NOT_SIMULATED
    if found.good_fraction >= GOOD_FRACTION - 1e-9:
        if not found.borders_are_good:
            return DOUBTFUL, BORDERS
        return (DOUBTFUL, PHASE_UNKNOWN) if phase is None else (GOOD, ALL)
    if found.remains_good and found.good_fraction >= GOOD_FRACTION * (1.0 - found.away_fraction):
        return DOUBTFUL, AWAY
    if not found.borders_are_good and found.good_fraction > HALF:
        return DOUBTFUL, BORDERS
    return (DOUBTFUL if found.good_fraction > HALF else BAD), SHORT

"""Lattices that close on a cylinder so that all their dimples lie on one thread.

On the unrolled cylinder of circumference C the step along the thread is a_1 and the one to the next row is
a_2, of length f both. M steps along the thread lead one row up from where they began, so that

    M a_1 - a_2 = (C, 0),    C² = f² (M² - M + 1) for triangles, f² (M² + 1) for squares,

and the thread is the set of k (u, v), with v C the area of a cell and u² + v² = f²: a screw motion takes
each dimple to the next one, so that all have the same neighbours and there is no seam.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass

import numpy as np
from _patchmill import InputError

LEAST_ROUND = 3  # dimples, for a cylinder


@dataclass(frozen=True)
class ThreadLattice:
    """`spacing`: f [mm]; `steps`: M; `along` and `up`: u and v, what a dimple is from the one before it,
    round the cylinder and along its axis [mm]; `circumference` [mm]."""

    circumference: float
    spacing: float
    steps: int
    along: float
    up: float
    triangular: bool

    @property
    def round(self):
        """Dimples in one turn of the cylinder; no whole number."""
        return self.circumference / self.along

    @property
    def pitch(self):
        """By how much the thread rises in one turn [mm]."""
        return self.up * self.round

    @property
    def neighbours(self):
        """By how many numbers a dimple's neighbours are behind it: half of them, for the others are as far
        before it."""
        return (1, self.steps - 1, self.steps) if self.triangular else (1, self.steps)

    def with_lead(self, lead, teeth):
        """The lattice whose thread rises by `lead` [mm] in a turn of the spindle, of `teeth` dimples."""
        return ThreadLattice(
            self.circumference, self.spacing, self.steps, self.along, lead / teeth, self.triangular
        )


def closing(circumference, wanted, triangular):
    """The ThreadLattice whose spacing is nearest to `wanted` [mm]. Raises InputError naming Spacing if fewer
    than LEAST_ROUND dimples go round."""
    ratio = circumference / wanted
    if not ratio >= LEAST_ROUND:
        remedy = "only %.1f go round the cylinder: choose a smaller one." % ratio
        raise InputError("Spacing", "%g mm" % wanted, remedy)
    real = 0.5 + math.sqrt(ratio**2 - 0.75) if triangular else math.sqrt(ratio**2 - 1.0)
    found = [_of_steps(circumference, steps, triangular) for steps in (math.floor(real), math.ceil(real))]
    return min(found, key=lambda lattice: abs(lattice.spacing - wanted))


def _of_steps(circumference, steps, triangular):
    norm = steps**2 - steps + 1 if triangular else steps**2 + 1
    spacing = circumference / math.sqrt(norm)
    area = spacing**2 * (math.sqrt(0.75) if triangular else 1.0)
    up = area / circumference
    return ThreadLattice(
        circumference, spacing, steps, math.sqrt(spacing**2 - up**2), up, triangular
    )


def spread(lattice, positions):
    """Distances of neighbours in space over the spacing, and angles of the lattice, as
    _patchmill.spacing_spread has them; `nearest` beside them. `positions`: (n, 3) along the thread [mm]."""
    steps = [positions[k:] - positions[:-k] for k in lattice.neighbours if k < len(positions)]
    if not steps:
        return dict.fromkeys(("least", "greatest", "rms", "least_angle", "greatest_angle", "nearest"), 0.0)
    shares = np.concatenate([np.linalg.norm(s, axis=1) for s in steps]) / lattice.spacing
    last = steps[-1]  # to the row below, beside a step along the thread
    first = steps[0][: len(last)]
    cosine = np.einsum("ij,ij->i", first, last)
    cosine /= np.linalg.norm(first, axis=1) * np.linalg.norm(last, axis=1)
    angles = np.arccos(np.clip(cosine, -1.0, 1.0)) if len(steps) > 1 else np.zeros(1)
    return {
        "least": float(shares.min()),
        "greatest": float(shares.max()),
        "rms": float(np.sqrt(np.mean((shares - 1.0) ** 2))),
        "least_angle": float(angles.min()),
        "greatest_angle": float(angles.max()),
        "nearest": float(shares.min()),
    }

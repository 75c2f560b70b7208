"""A photograph of our own, a plate that is milled after it, and what is seen of that from above.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import numpy as np
from matplotlib import image

from parts import job_on, tilted_plate

SPACING = 0.4  # mm
SHALLOW, DEEP = 0.0005, 0.018  # mm, of dimples where the photograph is white and black
INCLINED = 25.0  # degrees, of the plate
SHINE = 12.0  # of the metal: brightness falls with cos(angle between normal and view) to this power
BALLS = ((-0.35, 0.05, 0.38), (0.33, -0.12, 0.30), (0.05, -0.52, 0.18), (0.62, -0.50, 0.14))  # x, y, radius
LAMP = np.array([-0.45, 0.55, 0.70])


def photograph(size):
    """(size, size) grey from 0 to 1, the top row first: balls on a table under a lamp, with soft shadows."""
    x, y = np.meshgrid((np.arange(size) + 0.5) / size * 2.0 - 1.0, 1.0 - (np.arange(size) + 0.5) / size * 2.0)
    lamp = LAMP / np.linalg.norm(LAMP)
    grey = 0.62 + 0.18 * y - 0.12 * (x - 0.2) ** 2
    for cx, cy, r in BALLS:
        shadow = np.hypot(x - cx - 0.55 * r, (y - cy + 0.75 * r) * 1.6)
        grey = grey * (1.0 - 0.55 / (1.0 + np.exp((shadow - 0.95 * r) / (0.12 * r))))
    for cx, cy, r in sorted(BALLS, key=lambda one: -one[1]):
        dx, dy = (x - cx) / r, (y - cy) / r
        inside = dx**2 + dy**2 < 1.0
        dz = np.sqrt(np.clip(1.0 - dx**2 - dy**2, 0.0, None))
        lit = np.clip(dx * lamp[0] + dy * lamp[1] + dz * lamp[2], 0.0, None)
        grey = np.where(inside, 0.08 + 0.70 * lit + 0.22 * lit**30, grey)
    return np.clip(grey, 0.0, 1.0)


def plate(picture, side, filename):
    """(document, operation) of an inclined plate with `side` dimples along each side, as deep as the picture,
    which is written to `filename`, is dark; for three axes, locked to the spindle."""
    image.imsave(filename, picture, cmap="gray", vmin=0.0, vmax=1.0)
    shape, face = tilted_plate(side * SPACING, INCLINED)
    document, op = job_on(shape, face)
    values = {
        "TextureKind": "Isolated",
        "Spacing": SPACING,
        "Depth": DEEP,
        "AutoDirection": True,
        "MaskUse": "Depth",
        "MaskImage": filename,
        "DepthAtBlack": DEEP,
        "DepthAtWhite": SHALLOW,
        "Machine": "linuxcnc-mill",
        "Strategy": "Spindle-locked",
        "Order": "Rows",
        "RowDirection": "Along X",
        "SameFlute": False,
        "ExtraTurns": 0.0,
        "Decimals": 4,
        "Margin": 0.45 * SPACING,
    }
    for name, value in values.items():
        setattr(op, name, value)
    op.ToolController.SpindleSpeed = 1000
    job = document.getObject("Job")
    job.PostProcessor, job.PostProcessorArgs = "patchmill_linuxcnc", "--precision=4"
    return document, op


def seen_from_above(result):
    """Grey of a simulated texture's cells, (rows, columns), under a lamp beside the eye: a mirror looks
    white, and the more a place is inclined the darker it is. The bottom row first."""
    by_row, by_column = np.gradient(np.asarray(result.heights, float), result.step)
    return (1.0 + by_row**2 + by_column**2) ** (-0.5 * SHINE)


def cells(grey, result, width, side):
    """The mean of `grey` in each of side x side cells of a plate of `width` [mm], the top row first: as from
    far away."""
    x, y = (result.origin[k] + result.step * np.arange(grey.shape[1 - k]) for k in (0, 1))
    rows, columns = ((c / width + 0.5) * side for c in (y, x))
    r, c = (np.clip(n.astype(int), 0, side - 1) for n in (rows, columns))
    known = np.isfinite(grey)
    place = (r[:, None] * side + c[None, :])[known]
    total = np.bincount(place, grey[known], side * side)
    many = np.bincount(place, minlength=side * side)
    with np.errstate(invalid="ignore"):
        return (total / many).reshape(side, side)[::-1]


def correlation(picture, seen):
    """Pearson's correlation of what is seen with the photograph, made as coarse as it."""
    side = len(seen)
    at = np.minimum((np.arange(len(picture)) * side) // len(picture), side - 1)
    total, many = np.zeros((side, side)), np.zeros((side, side))
    np.add.at(total, (at[:, None], at[None, :]), picture)
    np.add.at(many, (at[:, None], at[None, :]), 1.0)
    known = (many > 0) & np.isfinite(seen)
    return float(np.corrcoef(total[known] / many[known], seen[known])[0, 1])

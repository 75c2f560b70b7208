"""Outlines of patches as lines on the faces: what a display draws, not what is milled.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from math import radians

import _patchmill as core
import numpy as np

CUT = 0  # state of a sample that lies on a face


def outlines_on_faces(placed, steps=8):
    """The outlines of a PlacedTexture's patches, projected as its dimples are: a list of (k, 3) arrays [mm],
    closed, each side in `steps` pieces. Rows of NaN where an outline leaves the faces."""
    flat = [np.vstack([line, line[:1]]) for line in placed.outlines(steps)]
    if not flat:
        return []
    given = placed.input
    sampler = core.FaceSampler(given.breps, placed.plane, radians(given.steepest_slope))
    points = np.concatenate(flat)
    known = np.isfinite(points).all(axis=1)
    hits = sampler.sample(np.where(known[:, None], points, 0.0))
    lift = 0.2 * given.spacing  # above the host's own, coarser triangles of the face
    places = hits["positions"] + lift * hits["normals"]
    places[(hits["states"] != CUT) | ~known] = np.nan
    return np.split(places, np.cumsum([len(line) for line in flat])[:-1])

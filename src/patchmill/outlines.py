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
    corners = placed.division.outlines()
    if not corners:
        return []
    flat = [_subdivided(polygon, steps) for polygon in corners]
    given = placed.input
    sampler = core.FaceSampler(given.breps, placed.plane, radians(given.steepest_slope))
    hits = sampler.sample(np.concatenate(flat))
    lift = 0.2 * given.spacing  # above the host's own, coarser triangles of the face
    places = hits["positions"] + lift * hits["normals"]
    places[hits["states"] != CUT] = np.nan
    return np.split(places, np.cumsum([len(line) for line in flat])[:-1])


def _subdivided(polygon, steps):
    """A closed polyline through the corners (n, 2), with `steps` pieces to a side."""
    shares = np.arange(steps)[:, None, None] / steps
    nxt = np.roll(polygon, -1, axis=0)
    points = (1.0 - shares) * polygon[None] + shares * nxt[None]
    line = points.transpose(1, 0, 2).reshape(-1, 2)
    return np.vstack([line, line[:1]])

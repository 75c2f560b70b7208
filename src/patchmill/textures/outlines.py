"""Outlines of patches as lines on the faces: what a display draws, not what is milled.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import _patchmill as core
import numpy as np

from patchmill.geometry import faces_or_mesh


def outlines_on_faces(placed, pieces=8):
    """The outlines of a PlacedTexture's patches, projected as its dimples are: a list of (k, 3) arrays [mm],
    closed, each side in `pieces`. Rows of NaN where an outline leaves the faces."""
    flat = [np.vstack([line, line[:1]]) for line in placed.outlines(pieces)]
    if not flat:
        return []
    points = np.concatenate(flat)
    known = np.isfinite(points).all(axis=1)
    given = placed.input
    sampler = faces_or_mesh.sampler(given, placed.plane)
    hits = sampler.sample(points[known])
    lift = 0.2 * given.spacing  # above the host's own, coarser triangles of the face
    found = hits["positions"] + lift * hits["normals"]
    found[hits["states"] != core.DimpleState.CUT] = np.nan
    places = np.full((len(points), 3), np.nan)
    places[known] = found
    return np.split(places, np.cumsum([len(line) for line in flat])[:-1])


def in_pieces(corners, pieces):
    """The closed polygon through (n, 2) corners with each side in so many pieces."""
    share = np.arange(pieces)[:, None] / pieces
    sides = [a + share * (b - a) for a, b in zip(corners, np.roll(corners, -1, axis=0))]
    return np.concatenate(sides)

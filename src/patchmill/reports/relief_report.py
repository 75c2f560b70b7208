"""Pictures of a simulated texture for the report: all of it, a detail with what was found, a section.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os

import _patchmill as core
import numpy as np

from patchmill.reports import relief_pictures

DETAIL = 14  # spacings across the detail


def draw(simulated, folder):
    """Writes PNGs into `folder`; returns {key: (file name, caption)}."""
    plan, step = simulated.plan, simulated.step
    centre, tilt = _typical(simulated)
    low, high, heights, origin = _detail(simulated, centre)
    planned, found = _places(simulated, low, high)
    figures = {
        "relief": (
            relief_pictures.shaded_relief(simulated.heights, step, simulated.origin, exaggeration=3.0),
            "The whole texture as it would be cut, by %s: deviation from the faces as shaded relief, "
            "heights three times." % simulated.source,
        ),
        "detail": (
            relief_pictures.shaded_relief(heights, step, origin, exaggeration=1.5),
            "A detail, where the tilt of the tool is the median one, %.0f°." % tilt,
        ),
        "depth": (
            relief_pictures.depth_map(heights, step, origin, places=found, planned=planned),
            "The same detail: heights over the faces, dimples planned and dimples found.",
        ),
        "section": (
            relief_pictures.cross_section(
                heights, step, (low[0], centre[1]), (high[0], centre[1]), origin
            ),
            "Section along a row through the middle of the detail, with the height of every ridge; "
            "spacing %g mm, ball of %g mm radius." % (plan.input.spacing, plan.input.tool.radius),
        ),
    }
    names = {}
    for key, (figure, caption) in figures.items():
        name = os.path.join(folder, "marks-%s.png" % key)
        relief_pictures.save(figure, name)
        names[key] = (name, caption)
    return names


def draw_beside(textures, folder):
    """Writes a picture of several textures of one window of a face, pairs (what it is, SimulatedTexture),
    side by side; returns {key: (file name, caption)} as draw(). Raises InputError naming Window if they are
    not of one grid."""
    step, origin = textures[0][1].step, textures[0][1].origin
    shapes = {(each.heights.shape, each.step) for _, each in textures}
    if len(shapes) > 1:
        remedy = "simulate the same window of the same plane."
        raise core.InputError("Window", "%d grids" % len(shapes), remedy)
    titles = ["%s: quality %.2f, %s" % (what, t.quality, t.alignment["state"]) for what, t in textures]
    heights = [texture.heights for _, texture in textures]
    figure = relief_pictures.side_by_side(heights, titles, step, origin, exaggeration=1.5)
    name = os.path.join(folder, "two-textures.png")
    relief_pictures.save(figure, name)
    said = "; ".join("%s, %s" % (what, texture.source) for what, texture in textures)
    return {"beside": (name, "The same place of the same face. Left to right: %s." % said)}


def _typical(simulated):
    """Place of the dimple in the window whose tilt is the median one, and that tilt in degrees."""
    plan = simulated.plan
    number = simulated.found["dimple"]
    if plan.posture is None:
        tilts = np.degrees(core.tilts(plan.dimples, (0.0, 0.0, 1.0)))[number]
    else:
        cosine = np.einsum("ij,ij->i", plan.posture.postures.axes, plan.dimples.normals)[number]
        tilts = np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0)))
    middle = int(np.argsort(tilts)[len(tilts) // 2])
    return plan.places()[number[middle]], float(tilts[middle])


def _detail(simulated, centre):
    """Corners, heights and origin of the detail around a place, inside the window."""
    low, high = simulated.window
    half = 0.5 * np.minimum(DETAIL * simulated.plan.input.spacing, high - low)
    centre = np.clip(centre, low + half, high - half)
    origin, step = np.asarray(simulated.origin), simulated.step
    first = np.round((centre - half - origin) / step).astype(int)
    last = np.round((centre + half - origin) / step).astype(int) + 1
    heights = simulated.heights[first[1] : last[1], first[0] : last[0]]
    return centre - half, centre + half, heights, tuple(origin + step * first)


def _places(simulated, low, high):
    """Planned and found places inside a rectangle."""
    f = simulated.found
    planned = simulated.plan.places()[f["dimple"]]
    return [p[((p > low) & (p < high)).all(axis=1)] for p in (planned, f["places"])]

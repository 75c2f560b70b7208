"""Jobs with FreeCAD's own Profile and Pocket operations, for tests of the dressup.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import importlib

import FreeCAD
import numpy as np
import Part
import Path
from patchmill import DressupDCM, host

CONTACT = 0.001  # mm that a dressup may move the contact point
LOW, HIGH = 400.0 / 60.0, 800.0 / 60.0  # mm/s, its feeds at the product and at the skin


def native(name):
    """FreeCAD's own operation module: 'Profile' or 'PocketShape'."""
    if host.VERSION >= (0, 21):
        return importlib.import_module("Path.Op." + name)
    return importlib.import_module("PathScripts.Path" + name)


def pocket_part():
    """A block 60 x 40 x 20 mm with rounded upright edges and a round pocket 8 mm deep."""
    block = Part.makeBox(60, 40, 20)
    block = block.makeFillet(6, [e for e in block.Edges if abs(e.tangentAt(e.FirstParameter).z) > 0.9])
    return block.cut(Part.makeCylinder(12, 8, FreeCAD.Vector(30, 20, 12)))


def make_job(shape, name="milling", ball=False):
    """(document, job) over a shape, with the default end mill or a ball end mill of 6 mm."""
    document = FreeCAD.newDocument(name)
    part = document.addObject("Part::Feature", "Part")
    part.Shape = shape
    document.recompute()
    job = host.create_job("Job", [part])
    if ball:
        host.add_ball_end_controller(job, 6.0, 2, 400.0, 6000.0)
    else:
        controller = host.tool_controllers(job)[0]
        controller.SpindleSpeed = 6000.0
        controller.HorizFeed, controller.VertFeed = 10.0, 3.0
        controller.HorizRapid = controller.VertRapid = 100.0
    job.PostProcessor = "linuxcnc"
    job.PostProcessorArgs = "--no-header --no-show-editor --precision=5"
    return document, job


def add_profile(job):
    operation = native("Profile").Create("Profile", parentJob=job)
    operation.StepDown = 5.0
    job.Document.recompute()
    return operation


def add_pocket(job):
    """A pocket over the lowest upward face inside the part."""
    model = job.Model.Group[0]
    floor = [
        "Face%d" % n
        for n, f in enumerate(model.Shape.Faces, 1)
        if f.normalAt(0, 0).z > 0.9 and f.BoundBox.ZMax < model.Shape.BoundBox.ZMax - 1
    ]
    operation = native("PocketShape").Create("Pocket", parentJob=job)
    operation.Base = [(model, floor)]
    operation.StepDown = 3.0
    job.Document.recompute()
    return operation


def trace(commands, step=0.05):
    """The way of feed moves, sampled: arrays of points, unit tangents and feeds. Arcs as arcs."""
    points, tangents, feeds = [], [], []
    at, feed = [0.0, 0.0, 0.0], 0.0
    for c in commands:
        p = c.Parameters
        feed = p.get("F", feed)
        end = [p.get(k, v) for k, v in zip("XYZ", at)]
        if c.Name in ("G1", "G2", "G3"):
            piece = _line(at, end, step) if c.Name == "G1" else _arc(at, end, p, c.Name == "G2", step)
            points.append(piece[0])
            tangents.append(piece[1])
            feeds.append(np.full(len(piece[0]), feed))
        if c.Name in ("G0", "G1", "G2", "G3"):
            at = end
    return np.vstack(points), np.vstack(tangents), np.concatenate(feeds)


def _line(a, b, step):
    a, b = np.array(a), np.array(b)
    length = np.linalg.norm(b - a)
    n = max(2, int(length / step) + 2)
    t = np.linspace(0, 1, n)[:, None]
    tangent = (b - a) / length if length > 0 else np.zeros(3)
    return a + t * (b - a), np.repeat(tangent[None], n, axis=0)


def _arc(a, b, p, clockwise, step):
    c = np.array([a[0] + p.get("I", 0.0), a[1] + p.get("J", 0.0)])
    r = np.hypot(a[0] - c[0], a[1] - c[1])
    a0, a1 = np.arctan2(a[1] - c[1], a[0] - c[0]), np.arctan2(b[1] - c[1], b[0] - c[0])
    sweep = (a0 - a1 if clockwise else a1 - a0) % (2 * np.pi) or 2 * np.pi
    n = max(2, int(sweep * r / step) + 2)
    t = np.linspace(0, 1, n)
    angle = a0 + (-sweep if clockwise else sweep) * t
    points = np.column_stack([c[0] + r * np.cos(angle), c[1] + r * np.sin(angle), a[2] + t * (b[2] - a[2])])
    sense = -1.0 if clockwise else 1.0
    tangents = np.column_stack(
        [-sense * r * sweep * np.sin(angle), sense * r * sweep * np.cos(angle), np.full(n, b[2] - a[2])]
    )
    return points, tangents / np.linalg.norm(tangents, axis=1)[:, None]


def distance_off(points, way, tangents):
    """Greatest distance of `points` from the curve sampled in `way`, off the tangent at the nearest."""
    worst = 0.0
    for chunk in np.array_split(points, max(1, len(points) * len(way) // 4_000_000)):
        d2 = (
            (chunk**2).sum(1)[:, None] - 2 * chunk @ way.T + (way**2).sum(1)[None]
        )
        near = d2.argmin(1)
        d = chunk - way[near]
        along = (d * tangents[near]).sum(1)
        off = np.linalg.norm(d - along[:, None] * tangents[near], axis=1)
        worst = max(worst, float(off.max()))
    return worst


def distance_to_lines(points, corners):
    """Greatest distance of `points` from the polyline with these corners."""
    a, d = corners[:-1], np.diff(corners, axis=0)
    square = np.maximum((d**2).sum(1), 1e-30)
    worst = 0.0
    for chunk in np.array_split(points, max(1, len(points) * len(a) // 2_000_000)):
        v = chunk[:, None] - a[None]
        t = np.clip((v * d[None]).sum(2) / square, 0, 1)
        worst = max(worst, float(np.linalg.norm(v - t[..., None] * d[None], axis=2).min(1).max()))
    return worst


def dress(operation, **properties):
    """A DressupDCM with voxels of 1 mm and these properties, not yet recomputed."""
    dressup = DressupDCM.Create("DressupDCM", operation)
    dressup.VoxelSize = 1.0
    for name, value in properties.items():
        setattr(dressup, name, value)
    return dressup


__all__ = [
    "CONTACT",
    "HIGH",
    "LOW",
    "Path",
    "add_pocket",
    "add_profile",
    "distance_off",
    "distance_to_lines",
    "dress",
    "make_job",
    "pocket_part",
    "trace",
]

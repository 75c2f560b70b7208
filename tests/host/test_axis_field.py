"""A texture whose tool axes come from the voxel model: the axis at each dimple is the field's at its ball
centre, the phase holds, the timing stays the texture's own, and bad input is named.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import os
import pathlib
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.path.insert(0, str(HERE.parents[1] / "Resources" / "recipes" / "kobayashi2014"))

import _patchmill as core  # noqa: E402
import FreeCAD  # noqa: E402
import make_parts  # noqa: E402
import numpy as np  # noqa: E402
import patchmill  # noqa: E402
from patchmill import CopyMilling, CurvedTexture, DressupDCM, InputError  # noqa: E402
from test_copy_milling import job_with_stock  # noqa: E402

RADIUS, PITCH, SPEED = 3.0, 2.0, 1000.0
AIR, PART = 0, 1  # VoxelKind


def textured_job():
    """(job, texture): 2 x 1 patches on the flank of the paper's convex part, with its axes from the field."""
    document, job = job_with_stock(make_parts.convex_part(), 1.0)
    job.PostProcessor = "patchmill_linuxcnc"
    job.PostProcessorArgs = "--precision=4"
    patchmill.host.tool_controllers(job)[0].SpindleSpeed = SPEED
    op = CurvedTexture.Create("Texture", parentJob=job)
    top = max(range(1, 7), key=lambda n: job.Model.Group[0].Shape.Faces[n - 1].CenterOfMass.z)
    op.Base = [(job.Model.Group[0], ["Face%d" % top])]
    op.PatchSide, op.PatchesX, op.PatchesY, op.Decimals = 6, 2, 1, 4
    op.AutoOrigin, op.Origin = False, FreeCAD.Vector(14, 16, 0)
    op.Machine, op.ToolAxisMode, op.MinimumLead = "table-table-ac", "Field", 0.0
    op.PostUnheld = op.PostGouging = True
    return job, op


def add_dressup(job, **properties):
    copy = CopyMilling.Create("Copy", parentJob=job)
    copy.RadialDepth, copy.AxialDepth = 20.0, 20.0
    CopyMilling.recompute(copy)
    dressup = DressupDCM.Create("DressupDCM", copy)
    dressup.Controls, dressup.Machine = "Posture", "table-table-ac"
    for name, value in properties.items():
        setattr(dressup, name, value)
    return dressup


def angles_of_voxels(job, pitch):
    """(origin, kind, theta, phi) of all voxels as arrays [x, y, z], of a model that the texture knows nothing
    of; the angles are those of the axis' projections, t ~ (tan phi, -tan theta, 1)."""
    stock, part = (
        core.solid_of_brep(text, 0.05, "x") for text in patchmill.removal_model.job_shapes(job)
    )
    grid = core.voxelise(stock, part, pitch)
    posture = core.steady_posture(grid, part)
    kinds, axes = [], []
    for k in range(grid.cells[2]):
        layer = grid.section(2, grid.origin[2] + (k + 0.5) * pitch, posture=posture)
        kinds.append(layer["kind"].T)
        axes.append(np.swapaxes(layer["axis"], 0, 1))
    kind, axis = np.stack(kinds, 2), np.nan_to_num(np.stack(axes, 2))
    upright = kind <= PART
    axis[upright] = (0.0, 0.0, 1.0)
    return grid.origin, kind, np.arctan2(-axis[..., 1], axis[..., 2]), np.arctan2(axis[..., 0], axis[..., 2])


def read_slowly(voxels, pitch, point):
    """The axis at one point: the eight voxels around it, those of the part left out."""
    origin, kind, theta, phi = voxels
    at = (np.array(point) - origin) / pitch - 0.5
    low = np.floor(at).astype(int)
    total = sums = 0.0
    for corner in np.ndindex(2, 2, 2):
        cell = tuple(low + corner)
        weight = np.prod([s if c else 1.0 - s for s, c in zip(at - low, corner)])
        inside = all(0 <= i < n for i, n in zip(cell, kind.shape))
        if inside and kind[cell] == PART:
            continue
        total += weight
        sums = sums + weight * (np.array([theta[cell], phi[cell]]) if inside else np.zeros(2))
    t, p = sums / total
    axis = np.array([math.tan(p), -math.tan(t), 1.0])
    return axis / np.linalg.norm(axis)


def milled(plan):
    return np.flatnonzero(plan.dimples.states == 0)


class AxisField(unittest.TestCase):
    def tearDown(self):
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)

    def check_axes(self, job, plan, pitch):
        """Axes of the path at each dimple, against the slow reading; returns their tilts [degrees]."""
        voxels = angles_of_voxels(job, pitch)
        path = plan.path
        ends = np.flatnonzero(path.dimples >= 0)
        self.assertEqual(len(ends), plan.counts["cut"])
        self.assertGreater(len(ends), 60)
        posture = plan.posture.work.path
        numbers = path.dimples[ends]
        centres = plan.dimples.positions[numbers] + RADIUS * plan.dimples.normals[numbers]
        wanted = np.array([read_slowly(voxels, pitch, c) for c in centres])
        found = posture.axes[np.flatnonzero(posture.dimples >= 0)]
        self.assertLess(np.abs(found - wanted).max(), 4e-6)  # angles are on four decimals of a degree
        return np.degrees(np.arccos(wanted[:, 2]))

    def test_axes_are_the_fields_and_the_timing_is_the_textures(self):
        job, op = textured_job()
        plan = patchmill.recompute(op)
        tilts = self.check_axes(job, plan, PITCH)
        self.assertGreater(np.ptp(tilts), 3.0)
        print("axes from %.1f to %.1f degrees off Z" % (tilts.min(), tilts.max()))
        # the feed is the tool controller's, and each dimple's turns obey the texture's rule
        feed = op.ToolController.HorizFeed.Value
        self.assertAlmostEqual(plan.feed, feed, delta=0.01 * feed)
        self.assertLess(math.degrees(plan.phase_errors()["largest"]), 1.0)
        self.assertTrue(5.0 <= op.TurnsPerDimple <= 6.0, op.TurnsPerDimple)
        with tempfile.TemporaryDirectory() as folder:
            posted = patchmill.post(job, os.path.join(folder, "x.ngc"))[0]
        self.assertLess(math.degrees(posted.errors["largest"]), 1.0)
        ends = np.flatnonzero(posted.path.dimples >= 0)
        numbers = posted.path.dimples[ends]
        centres = posted.path.tips[ends] + RADIUS * posted.path.axes[ends]
        wanted = plan.dimples.positions[numbers] + RADIUS * plan.dimples.normals[numbers]
        self.assertLess(np.abs(centres - wanted).max(), 4e-4)

    def test_a_dressups_model_is_taken_and_followed(self):
        job, op = textured_job()
        dressup = add_dressup(job, VoxelSize=1.5)
        op.PostureField = dressup
        DressupDCM.recompute(dressup)
        plan = patchmill.recompute(op)
        self.assertIs(plan.input.posture_field.model, dressup.Proxy.model)  # one model for both
        self.check_axes(job, plan, 1.5)
        dressup.VoxelSize = 3.0
        job.Document.recompute()
        self.check_axes(job, patchmill.planned(op), 3.0)

    def test_spindle_locked_holds(self):
        job, op = textured_job()
        op.Strategy, op.SameFlute, op.ExtraTurns = "Spindle-locked", False, 0.0
        op.RowTolerance = 6.0
        plan = patchmill.recompute(op)
        print(op.Verdict)
        self.assertTrue(op.Verdict.lower().startswith("holds"), op.Verdict)
        cut = milled(plan)
        asked = plan.input.posture_field(plan.dimples.positions, plan.dimples.normals)[cut]
        cosine = np.einsum("ij,ij->i", plan.posture.postures.axes[cut], asked)
        self.assertLess(np.degrees(np.arccos(np.clip(cosine, -1, 1))).max(), 6.0 + 1e-3)

    def test_least_lead_keeps_the_tip_away(self):
        job, op = textured_job()
        op.MinimumLead = 12.0
        plan = patchmill.recompute(op)
        cut = milled(plan)
        cosine = np.einsum("ij,ij->i", plan.posture.postures.axes[cut], plan.dimples.normals[cut])
        self.assertGreater(np.degrees(np.arccos(cosine)).min(), 12.0 - 1e-3)

    def test_the_model_is_kept_beside_the_document(self):
        job, op = textured_job()
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "part.FCStd")
            job.Document.saveAs(name)
            count = patchmill.recompute(op).counts["cut"]
            self.assertTrue(os.path.exists(os.path.join(folder, "part-Texture.voxels")))
            job.Document.save()
            FreeCAD.closeDocument(job.Document.Name)
            del job, op
            op = FreeCAD.openDocument(name).getObject("Texture")
            plan = patchmill.recompute(op)
            self.assertEqual(plan.counts["cut"], count)
            self.assertTrue(plan.input.posture_field.model.loaded)
            FreeCAD.closeDocument(op.Document.Name)

    def refused(self, named, op, words=""):
        with self.assertRaises(InputError) as caught:
            patchmill.recompute(op)
        print(caught.exception)
        self.assertEqual(caught.exception.property, named, caught.exception)
        self.assertIn(words, str(caught.exception))
        self.assertEqual(len(op.Path.Commands), 0)

    def test_bad_input(self):
        job, op = textured_job()
        op.FieldVoxelSize = 0.0
        self.refused("FieldVoxelSize", op)
        op.FieldVoxelSize = 0.005
        self.refused("FieldVoxelSize", op)
        op.FieldVoxelSize = 2.0
        op.PostureField = job.Model.Group[0]
        self.refused("PostureField", op, "DCM modifier")
        dressup = add_dressup(job, VoxelSize=2.0)
        op.PostureField = dressup
        patchmill.recompute(op)
        dressup.VoxelSize = 0.0
        with self.assertRaises(InputError) as caught:
            patchmill.texture_operation.prepare(op.Proxy.texture_input(op))
        self.assertEqual(caught.exception.property, "PostureField")
        self.assertIn("VoxelSize", str(caught.exception))
        with self.assertRaises(InputError) as caught:  # FreeCAD computes nothing after what failed
            patchmill.recompute(op)
        self.assertEqual((caught.exception.property, caught.exception.value), ("PostureField", dressup.Label))
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaises(InputError):
                patchmill.post(job, os.path.join(folder, "x.ngc"))
            self.assertEqual(os.listdir(folder), [])
        dressup.VoxelSize = 2.0
        op.Machine = ""
        self.refused("Machine", op)
        op.Machine = "table-table-ac"
        job.Stock = job.Document.addObject("Part::Box", "Small")
        job.Document.recompute()
        self.refused("Model", op)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2, argv=["test"] + sys.argv[1:]).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)

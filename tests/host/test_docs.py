"""The Python blocks of docs/ and README.md, run as they stand, page by page in their order. What a page takes
for granted, a job, an operation, a file, is made before its first block, and anew before a block that does
not go on from the one before.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import contextlib
import importlib.util
import io
import os
import pathlib
import shutil
import sys
import tempfile
import unittest

import FreeCAD
import numpy as np
import Part

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import patchmill  # noqa: E402
from milling_jobs import add_profile, make_job, pocket_part  # noqa: E402
from patchmill.freecad import host  # noqa: E402
from recipe import STEP, small_job  # noqa: E402
from test_axis_field import add_dressup, textured_job  # noqa: E402
from test_copy_milling import job_with_stock  # noqa: E402
from test_strategies import locked_job  # noqa: E402
from test_ball import ball  # noqa: E402
from test_meshes import block_of, mesh_of, wavy_face, write_stl  # noqa: E402
from test_thread import roller  # noqa: E402

spec = importlib.util.spec_from_file_location("blocks", HERE.parent / "docs" / "blocks.py")
blocks = importlib.util.module_from_spec(spec)
spec.loader.exec_module(blocks)
V = FreeCAD.Vector


def tilted(kept, size=(5, 6, 7)):
    """A box whose faces of these numbers look up, by turning their mean normal to Z."""
    box = Part.makeBox(*size)
    mean = sum((box.Faces[k - 1].normalAt(0, 0) for k in kept), V())
    turn = FreeCAD.Rotation(mean, V(0.3, 0, 1))
    box.Placement = FreeCAD.Placement(V(), turn)
    return box


def mesh_file():
    """A block as an STL file in the working folder."""
    write_stl("block.stl", *block_of(*mesh_of(wavy_face(), 0.5)))
    return {}


def job_over(shape):
    """A job with a ball end mill of 2 mm over a shape."""
    document = FreeCAD.newDocument("docs")
    part = document.addObject("Part::Feature", "Part")
    part.Shape = shape
    document.recompute()
    job = host.create_job("Job", [part])
    host.add_ball_end_controller(job, 2.0, 2, 600.0, 1000.0)
    job.PostProcessor = "linuxcnc"
    job.PostProcessorArgs = "--no-header --no-show-editor --precision=3"
    return {"job": job, "model": job.Model.Group[0], "patchmill": patchmill, "FreeCAD": FreeCAD}


def texture(machine="", patches=2):
    """A texture, planned and posted as texture.ngc; its moves as a recording."""
    _, job, op = locked_job(machine) if machine else small_job()
    op.PatchesX = op.PatchesY = patches
    op.Origin = (-24, -24, 0) if patches == 2 else (-15, -10, 0)  # steep: the tip is outside of every mark
    path = patchmill.recompute(op).path
    patchmill.post(job, "texture.ngc")
    turns = np.nan_to_num(path.turns)
    timed = np.flatnonzero(turns > 0.0)
    turned = np.cumsum(turns)[timed]
    rows = np.column_stack([turned, path.tips[timed], -2.0 * np.pi * turned])
    return {"job": job, "op": op, "rows": rows, "patchmill": patchmill, "FreeCAD": FreeCAD}


def shaft():
    _, op = roller(6.0, 2.0)
    return {"op": op, "patchmill": patchmill}


def golf_ball():
    _, op = ball()
    return {"op": op, "patchmill": patchmill, "FreeCAD": FreeCAD}


def textured():
    return texture()


def locked():
    return texture("linuxcnc-mill", 4)


def turning():
    """A texture whose spindle turns so slowly that rotary axes follow."""
    made = texture()
    made["op"].ToolController.SpindleSpeed = 200.0
    return made


def measured():
    """Reliefs of a texture in files, as a measuring instrument writes them."""
    made = texture()
    result = patchmill.simulate(made["op"])
    for name in ("measured.x3p", "scan.x3p", "measured.sdf"):
        result.save(name)
    return made


def copying():
    _, job = job_with_stock(Part.makeBox(8, 8, 4), 3.0)
    return {"job": job, "patchmill": patchmill, "send": lambda line: None}


def modifying():
    """A profile to be modified, and a solid that may be another material."""
    document, job = make_job(pocket_part(), ball=True)
    insert = document.addObject("Part::Feature", "Insert")
    insert.Shape = Part.makeBox(4, 4, 4)
    return {"job": job, "operation": add_profile(job), "patchmill": patchmill}


def field():
    """A texture, and a modifier whose voxel model gives its axes."""
    job, op = textured_job()
    return {"texture": op, "dressup": add_dressup(job), "patchmill": patchmill}


def dressed():
    made = modifying()
    return dict(made, dressup=patchmill.DressupDCM.Create("DressupDCM", made["operation"]))


def a_file():
    shutil.copy(STEP, "block.step")
    return {}


# page: for each of its Python blocks, what is made before it (None: it goes on from the one before), and what
# must be so after it
PAGES = {
    "areal-parameters": [
        (measured, "surface is not None"),
        (None, "len(found.depths)"),
        (None, "measured.text()"),
    ],
    "measured-machine": [(measured, "late.unit in ('', 'degrees')")],
    "height-maps": [(measured, "os.path.getsize('texture.stl') > 1000 and measured is not None")],
    "dcm-fields": [
        (modifying, "result.seconds > 0.0"),
        (field, "plan.posture is not None"),
        (dressed, "patchmill.DressupDCM.recompute(dressup).seconds > 0.0"),
    ],
    "cutting-load": [(modifying, "load.force.max() < 1.1 * 300.0 and result.load is not None")],
    "README": [
        (lambda: job_over(tilted([2])), "os.path.getsize('texture.ngc') > 1000 < 50 * plan.counts['cut']"),
        (None, "op.Verdict.startswith('Holds')"),
        (textured, "result.data()['missing'] == 0 and check.outcome == 'clear'"),
        (turning, "patchmill.recompute(op).posture is not None"),
    ],
    "macros": [(a_file, "plan.counts['cut'] > 5000 and os.path.getsize('block.ngc') > 1000")],
    "checks": [(textured, "result.outcome == 'clear'")],
    "copy-milling": [(copying, "len(path) > 20"), (None, "session.done")],
    "cutter-marks": [(locked, "result.data()['missing'] == 0"), (None, "points.shape[:2] == heights.shape")],
    "five-axis": [(textured, "patchmill.recompute(op).posture is not None")],
    "matsuda-condition": [(lambda: {"patchmill": patchmill}, "p.feed > 0.0")],
    "patch-division": [(lambda: job_over(tilted([1, 4])), "op.DimpleCount > 20")],
    "balls": [(golf_ball, "result.extra == 0 and op.Verdict.startswith('Holds')")],
    "meshes": [(mesh_file, "made.check.clear and os.path.getsize('block.ngc') > 1000")],
    "thread": [(shaft, "result.missing == 0 and op.Verdict.startswith('Holds')")],
    "rows": [(locked, "patchmill.recompute(op).counts['cut'] > 50")],
}


class Pages(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        self.addCleanup(lambda: [FreeCAD.closeDocument(n) for n in list(FreeCAD.listDocuments())])

    def test_all_blocks_have_a_place_here(self):
        with_blocks = {p.stem: len(blocks.of_language(p, "python")) for p in blocks.pages()}
        self.assertEqual({k: n for k, n in with_blocks.items() if n}, {k: len(v) for k, v in PAGES.items()})


def runs(page):
    def test(self):
        file = next(p for p in blocks.pages() if p.stem == page)
        names = {}
        for (line, code), (make, so) in zip(blocks.of_language(file, "python"), PAGES[page]):
            names = names if make is None else make()
            with contextlib.redirect_stdout(io.StringIO()) as said:
                exec(compile("\n" * line + code, str(file), "exec"), names)
            self.assertTrue(eval(so, names, {"os": os}), "%s:%d: %s\n%s" % (file, line, so, said.getvalue()))

    return test


for name in PAGES:
    setattr(Pages, "test_" + name.replace("-", "_"), runs(name))


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)

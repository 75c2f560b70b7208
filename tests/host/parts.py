"""Parts with a texture operation, and tests that close their documents.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import unittest

import FreeCAD
import Part
import patchmill
from patchmill.freecad import host

V = FreeCAD.Vector


def job_on(shape, face, kind="CurvedTexture", diameter=2.0):
    """(document, operation) with a texture on one face of a shape."""
    document = FreeCAD.newDocument("texture")
    part = document.addObject("Part::Feature", "Part")
    part.Shape = shape
    document.recompute()
    job = host.create_job("Job", [part])
    host.add_ball_end_controller(job, diameter, 2, 600.0, 1000.0)
    operation = getattr(patchmill, kind).Create("Texture", parentJob=job)
    operation.Base = [(job.Model.Group[0], [face])]
    operation.PatchSide = 6
    return document, operation


def tilted_box(angle=30.0):
    """A box of 20 x 16 mm whose top, the highest face, is inclined about Y."""
    box = Part.makeBox(20, 16, 5, V(-10, -8, -5))
    box.rotate(V(0, 0, 0), V(0, 1, 0), angle)
    top = max(range(6), key=lambda k: box.Faces[k].normalAt(0, 0).z)
    return box, "Face%d" % (top + 1)


def tilted_plate(side, angle):
    """(shape, name of its top) of a square plate of `side` [mm], inclined by `angle` [degrees] about Y."""
    box = Part.makeBox(side, side, 5, V(-side / 2, -side / 2, -5))
    box.rotate(V(0, 0, 0), V(0, 1, 0), angle)
    top = max(range(6), key=lambda k: box.Faces[k].normalAt(0, 0).z)
    return box, "Face%d" % (top + 1)


def saved_and_reopened(document, name):
    """(document, job) of a document that was saved as `name`, closed and opened again."""
    document.saveAs(name)
    FreeCAD.closeDocument(document.Name)
    reopened = FreeCAD.openDocument(name)
    return reopened, next(o for o in reopened.Objects if o.Name.startswith("Job"))


class WithDocuments(unittest.TestCase):
    def tearDown(self):
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)

    def assert_refused(self, operation, name):
        with self.assertRaises(patchmill.InputError) as caught:
            patchmill.recompute(operation)
        self.assertEqual(caught.exception.property, name)

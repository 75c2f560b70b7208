"""Operations on thousands of faces: a shape is asked once for all of its faces, not once for each, and says
of them what looking each up says. The time that this takes is in tools/bench.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import collections
import pathlib
import sys
import unittest

import FreeCAD
import Part
import patchmill
from patchmill.freecad import host, made_from

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from parts import WithDocuments, job_on, tilted_box  # noqa: E402


class Counted:
    """A document object or a shape that counts what it is asked for."""

    def __init__(self, thing):
        self._thing, self.asked = thing, collections.Counter()

    def __getattr__(self, name):
        self.asked[name] += 1
        found = getattr(self._thing, name)
        return Counted(found) if name == "Shape" else found


class Lookup(WithDocuments):
    def setUp(self):
        self.document = FreeCAD.newDocument("many")
        self.part = self.document.addObject("Part::Feature", "Part")
        boxes = [Part.makeBox(1, 1, 1, FreeCAD.Vector(2 * i, 0, 0.1 * i)) for i in range(9)]
        self.part.Shape = Part.makeCompound(boxes)
        self.names = ["Face%d" % (i + 1) for i in range(54)]

    def test_faces_are_those_that_are_looked_up_one_by_one(self):
        chosen = self.names[::-3]
        for name, face in zip(chosen, made_from.faces_of(self.part, chosen, "")):
            self.assertTrue(face.isSame(self.part.Shape.getElement(name)))

    def test_the_shape_is_asked_once(self):
        for names in (self.names[:2], self.names):
            base = Counted(self.part)
            made_from.faces_of(base, names, "")
            self.assertEqual(base.asked["Shape"], 1)
            self.assertLessEqual(base.asked.total(), 2)  # and where it stands
            shape = Counted(self.part.Shape)
            self.assertIsNone(made_from.first_gone(shape, names + ["Edge1", "Edge7", "Vertex3"]))
            self.assertEqual(shape.asked.total(), 3)  # for faces, edges, vertices

    def test_what_is_gone_is_named(self):
        shape = self.part.Shape
        for gone in ("Face55", "Face0", "Edge1000", "Vertex0", "?Face3", "Face", "Solid"):
            self.assertEqual(made_from.first_gone(shape, ["Face1", gone]), gone)
        self.assertIsNone(made_from.first_gone(shape, ["", "Face54", "Edge1", "Vertex1"]))
        for gone in ("Face55", "Face0", "?Face3", "Edge1", ""):
            with self.assertRaises(patchmill.InputError) as caught:
                made_from.faces_of(self.part, ["Face1", gone], "choose.")
            self.assertEqual(caught.exception.property, "Base")

    def test_depths_are_freecads(self):
        for shape, face in (tilted_box(20.0), tilted_box(40.0)):
            document, operation = job_on(shape, face)
            proxy = operation.Proxy
            for stock in (1.0, 0.0):
                operation.Document.getObject("Stock").ExtZpos = stock
                document.recompute()
                proxy.updateDepths(operation)
                ours = self.depths(operation)
                operation.StartDepth = 0.0
                host.PathOp.ObjectOp.updateDepths(proxy, operation)
                self.assertEqual(self.depths(operation), ours)

    def depths(self, operation):
        names = ("StartDepth", "OpStockZMin", "OpStockZMax")
        return [round(getattr(operation, name).Value, 9) for name in names]


if __name__ == "__main__":
    result = unittest.main(exit=False).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)

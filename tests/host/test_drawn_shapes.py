"""What operations take of a document is taken where FreeCAD draws it, and only of the job's own model.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import FreeCAD  # noqa: E402
import Mesh  # noqa: E402
import numpy as np  # noqa: E402
import Part  # noqa: E402
import patchmill  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import InputError  # noqa: E402
from patchmill.advice import apply  # noqa: E402
from patchmill.freecad import host  # noqa: E402
from patchmill.geometry import shapes  # noqa: E402
from patchmill.voxels import materials  # noqa: E402

V = FreeCAD.Vector
PLACE = FreeCAD.Placement(V(5, 6, 7), FreeCAD.Rotation(V(0, 0, 1), 25))


def slope():
    box = Part.makeBox(16, 12, 4, V(-8, -6, -4))
    box.rotate(V(), V(0, 1, 0), 20)
    return box


def top(shape):
    faces = shape.Faces
    return "Face%d" % (1 + max(range(len(faces)), key=lambda k: faces[k].normalAt(0, 0).z))


class DrawnShapes(WithDocuments):
    def job(self):
        self.document = FreeCAD.newDocument("drawn")
        self.part = self.document.addObject("Part::Feature", "Part")
        self.part.Shape = slope()
        self.document.recompute()
        job = host.create_job("Job", [self.part])
        host.add_ball_end_controller(job, 2.0, 2, 600.0, 1000.0)
        return job

    def texture(self, job, base):
        op = patchmill.CurvedTexture.Create("Texture", parentJob=job)
        op.Base, op.PatchSide = [(base, [top(base.Shape)])], 4
        return op

    def in_holders(self, kind):
        """(object, what holds it) of a type in a body, a part, a part in a part, and behind a link."""
        add = self.document.addObject
        if kind == "Sketcher::SketchObject":
            body = add("PartDesign::Body", "Body")
            yield body.newObject(kind, "InBody"), body
        outer, inner = add("App::Part", "Outer"), add("App::Part", "Inner")
        outer.addObject(inner)
        for holder in (outer, inner):
            obj = add(kind, "InPart")
            holder.addObject(obj)
            yield obj, outer
        linked, holder, link = add(kind, "Linked"), add("App::Part", "Links"), add("App::Link", "Link")
        link.LinkedObject = linked
        holder.addObject(link)
        yield link, holder

    def test_in_moved_bodies_and_parts_and_behind_links(self):
        self.job()
        for kind in ("Sketcher::SketchObject", "Part::Box"):
            for obj, holder in self.in_holders(kind):
                target = getattr(obj, "LinkedObject", obj)
                if kind.startswith("Sketcher"):
                    target.addGeometry(Part.Circle(V(2, 1, 0), V(0, 0, 1), 3))
                holder.Placement = PLACE
                self.document.recompute()
                shape = shapes.drawn(obj)
                middle = V(2, 1, 0) if kind.startswith("Sketcher") else V(5, 5, 5)
                found = shape.BoundBox.Center if kind.startswith("Sketcher") else shape.CenterOfMass
                self.assertLess((PLACE.multVec(middle) - found).Length, 1e-3, (obj.Name, holder.Name))

    def test_a_material_is_where_its_solid_is_drawn(self):
        self.job()
        part, box = (self.document.addObject(kind, "Hard") for kind in ("App::Part", "Part::Box"))
        part.addObject(box)
        part.Placement = PLACE
        self.document.recompute()
        for name in (box.Name, part.Name):
            (material,) = materials.of_lines(["hard 0.5 " + name], self.document, "")
            shape = Part.Shape()
            shape.importBrepFromString(material.solid)
            self.assertLess((PLACE.multVec(V(5, 5, 5)) - shape.BoundBox.Center).Length, 1e-3)

    def test_a_mask_is_where_its_curve_is_drawn(self):
        job = self.job()
        part, sketch = (self.document.addObject(k, "Mask") for k in ("App::Part", "Sketcher::SketchObject"))
        sketch.addGeometry(Part.Circle(V(0, 0, 0), V(0, 0, 1), 2))
        part.addObject(sketch)
        part.Placement.Base = V(3, 2, 1)
        op = self.texture(job, job.Model.Group[0])
        op.MaskUse, op.MaskCurves = "Leave out", [sketch]
        dimples = patchmill.recompute(op).dimples
        places = dimples.positions[dimples.states == 0]
        self.assertLess(np.hypot(places[:, 0] - 3.0, places[:, 1] - 2.0).max(), 2.0)

    def nested(self, what):
        """An object in a part in a part, both moved and turned, and where that puts it."""
        outer, inner = (self.document.addObject("App::Part", name) for name in ("Outer", "Inner"))
        inner.addObject(what)
        outer.addObject(inner)
        outer.Placement = FreeCAD.Placement(V(4, -3, 2), FreeCAD.Rotation(V(0, 0, 1), 90))
        inner.Placement = FreeCAD.Placement(V(1, 2, -1), FreeCAD.Rotation(V(0, 0, 1), -60))
        self.document.recompute()
        return outer, outer.Placement.multiply(inner.Placement)

    def test_a_mask_and_a_base_in_moved_parts_in_parts(self):
        """The texture of a job of the outer part lies where that is drawn, inside the curve as it is drawn;
        of the box alone FreeCAD makes a model of the job that is not moved, and draws that."""
        self.document = FreeCAD.newDocument("drawn")
        self.part = self.document.addObject("Part::Feature", "Part")
        self.part.Shape = slope()
        outer, place = self.nested(self.part)
        mask = self.document.addObject("Sketcher::SketchObject", "Mask")
        mask.addGeometry(Part.Circle(V(2, 1, 0), V(0, 0, 1), 2))
        self.part.getParentGeoFeatureGroup().addObject(mask)
        self.document.recompute()
        for model, moved in ((outer, place), (self.part, FreeCAD.Placement())):
            job = host.create_job("Job", [model])
            host.add_ball_end_controller(job, 2.0, 2, 600.0, 1000.0)
            op = self.texture(job, job.Model.Group[0])
            op.MaskUse, op.MaskCurves = "Leave out", [mask]
            dimples = patchmill.recompute(op).dimples
            cut = dimples.positions[dimples.states == 0]
            drawn = self.part.Shape.copy()
            drawn.Placement = moved.multiply(drawn.Placement)
            face = drawn.getElement(top(drawn))
            self.assertGreater(len(cut), 20)
            self.assertLess(max(face.distToShape(Part.Vertex(V(*p)))[0] for p in cut), 1e-6)
            centre = place.multVec(V(2, 1, 0))
            radii = np.hypot(cut[:, 0] - centre.x, cut[:, 1] - centre.y)
            self.assertLess(radii.max(), 2.0)
            self.assertGreater(radii.max(), 1.0)

    def test_base_is_of_the_jobs_model(self):
        job = self.job()
        model = job.Model.Group[0]
        model.Placement.Base = V(3, 0, -10)
        self.document.recompute()
        of_model = patchmill.recompute(self.texture(job, model)).dimples.positions
        of_original = patchmill.recompute(self.texture(job, self.part)).dimples.positions
        self.assertTrue(np.array_equal(of_model, of_original))
        other = self.document.addObject("Part::Feature", "Other")
        other.Shape = slope()
        with self.assertRaises(InputError) as caught:
            patchmill.recompute(self.texture(job, other))
        self.assertEqual(caught.exception.property, "Base")

    def test_a_solid_that_is_inside_out(self):
        job = self.job()
        op = self.texture(job, job.Model.Group[0])
        self.part.Shape = slope().reversed()
        with self.assertRaises(InputError) as caught:
            patchmill.recompute(op)
        self.assertEqual(caught.exception.property, "Model")
        self.assertIn("inside out", str(caught.exception))

    def test_a_bit_with_a_shape_file_of_its_own(self):
        self.job()
        ball = Part.makeCylinder(1, 20, V(0, 0, 1)).fuse(Part.makeSphere(1, V(0, 0, 1)))
        for shape, kind in ((ball.removeSplitter(), "ballend"), (Part.makeCylinder(1, 20), "mine")):
            bit = self.document.addObject("Part::Feature", "Bit")
            bit.addProperty("App::PropertyString", "BitShape").BitShape = "/somewhere/Mine.fcstd"
            bit.addProperty("App::PropertyLength", "Diameter").Diameter = 2.0
            bit.Shape = shape
            self.assertEqual(host.tool_kind(bit), kind)
            bit.Diameter = 3.0
            self.assertEqual(host.tool_kind(bit), "mine")

    def test_a_sketch_or_a_mesh_among_the_models(self):
        job = self.job()
        op = self.texture(job, job.Model.Group[0])
        patchmill.recompute(op)
        sketch = self.document.addObject("Sketcher::SketchObject", "Sketch")
        sketch.addGeometry(Part.Circle(V(2, 1, 0), V(0, 0, 1), 3))
        mesh = self.document.addObject("Mesh::Feature", "Mesh")
        facets = Mesh.Mesh(Part.makeBox(2, 2, 2, V(20, 0, 0)).tessellate(0.1))
        mesh.Mesh = facets
        job.Model.Group = job.Model.Group + [sketch, mesh]
        self.document.recompute()
        self.assertTrue(patchmill.check(op).clear, patchmill.check(op).sentence)
        self.assertAlmostEqual(shapes.models(job)[-1].Volume, 8.0)
        facets.removeFacets([0])
        mesh.Mesh = facets
        with self.assertRaises(InputError) as caught:
            patchmill.check(op)
        self.assertEqual(caught.exception.property, "Model")

    def model_of(self, job):
        return [[model.Shape] for model in job.Model.Group]

    def test_a_shape_that_stays_is_written_and_measured_once(self):
        job = self.job()
        op = self.texture(job, job.Model.Group[0])
        self.document.recompute()
        texts, made = shapes.BrepTexts(), []
        written = texts.of(self.model_of(job), lambda parts: made.append(1) or parts[0])
        shapes._is_inside_out.cache_clear()
        for _ in range(3):
            again = texts.of(self.model_of(job), self.fail)
            self.assertEqual(again, written)
            first = op.Proxy.texture_input(op).breps
        self.assertEqual(len(made), 1)
        self.assertEqual(shapes._is_inside_out.cache_info().misses, 1)
        self.part.Shape = Part.makeBox(16, 12, 5, V(-8, -6, -4))
        op.Base = [(job.Model.Group[0], ["Face6"])]
        self.document.recompute()
        self.assertNotEqual(texts.of(self.model_of(job), lambda parts: parts[0]), written)
        self.assertNotEqual(op.Proxy.texture_input(op).breps, first)
        self.assertEqual(shapes._is_inside_out.cache_info().misses, 2)
        self.part.Shape = self.part.Shape.reversed()
        self.document.recompute()
        self.assertRaises(InputError, op.Proxy.texture_input, op)

    def test_the_model_of_a_job_with_a_mesh_is_what_has_a_shape(self):
        job = self.job()
        op = self.texture(job, job.Model.Group[0])
        mesh = self.document.addObject("Mesh::Feature", "Mesh")
        mesh.Mesh = Mesh.Mesh(Part.makeBox(2, 2, 2, V(20, 0, 0)).tessellate(0.1))
        job.Model.Group = job.Model.Group + [mesh]
        self.document.recompute()
        self.assertEqual(apply.model_of(op), [shapes.drawn(job.Model.Group[0]).exportBrepToString()])


if __name__ == "__main__":
    unittest.main()

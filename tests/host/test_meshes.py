"""Textures on triangle meshes: against the face that they were made from, regions, files, programs, refusals.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import os
import sys
import tempfile
import unittest
from dataclasses import replace

import FreeCAD
import Mesh
import Part
import _patchmill as core
import numpy as np
import patchmill
from patchmill.textures.outlines import outlines_on_faces
from patchmill.textures.plan import TextureInput, place_texture, plan_texture

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from meshes_made import block_of, height, mesh_of, wavy_face, write_stl  # noqa: E402

V = FreeCAD.Vector


def given_on(mesh=None, breps=(), **values):
    made = dict(spacing=0.5, patch_side=6, rotation=7.0, origin=(0.0, 0.0, 0.0))
    return TextureInput(
        breps=list(breps), mesh=mesh, tool=core.BallEndMill(1.0, 2), spindle=core.Spindle(1000 / 60, "M3"),
        feed=10.0, safe_height=4.0, clearance_height=6.0, **{**made, **values},
    )  # fmt: skip


def surface_of(vertices, triangles, crease=1.0):
    return core.MeshSurface(core.TriangleMesh(vertices, triangles), crease)


class BesideTheFace(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.face = wavy_face()
        cls.text = cls.face.exportBrepToString()
        cls.vertices, cls.triangles = mesh_of(cls.face)
        cls.surface = surface_of(cls.vertices, cls.triangles)

    def test_dimples_lie_within_the_chord(self):
        on_face, on_mesh = (
            place_texture(given).dimples for given in (given_on(breps=[self.text]), given_on(self.surface))
        )
        self.assertEqual(len(on_face), len(on_mesh))
        both = (on_face.states == core.DimpleState.CUT) & (on_mesh.states == core.DimpleState.CUT)
        self.assertGreater(both.sum(), 300)
        self.assertLess((on_face.states != on_mesh.states).sum(), 0.05 * len(on_face))  # at the border
        off = np.linalg.norm(on_face.positions - on_mesh.positions, axis=1)[both]
        self.assertLess(off.max(), self.surface.chord_height)
        self.assertLess(self.surface.chord_height, 0.002)
        turned = np.linalg.norm(on_face.normals - on_mesh.normals, axis=1)[both]
        self.assertLess(np.median(turned), 0.001)

    def test_a_finer_mesh_is_nearer_by_the_square(self):
        exact = place_texture(given_on(breps=[self.text])).dimples
        off = []
        for edge in (0.5, 0.25, 0.125):
            mesh = surface_of(*mesh_of(self.face, edge))
            found = place_texture(given_on(mesh)).dimples
            both = (exact.states == core.DimpleState.CUT) & (found.states == core.DimpleState.CUT)
            off.append(np.sqrt(((exact.positions - found.positions)[both] ** 2).sum(axis=1).mean()))
        self.assertLess(off[1], off[0] / 3.3)
        self.assertLess(off[2], off[1] / 3.3)

    def test_auto_direction_and_origin(self):
        made = [
            place_texture(replace(given, auto_direction=True, origin=None))
            for given in (given_on(breps=[self.text]), given_on(self.surface))
        ]
        axes = [np.asarray(one.plane.direction) for one in made]
        self.assertLess(np.linalg.norm(axes[0] - axes[1]), 0.01)
        self.assertLess(np.linalg.norm(made[0].plane.origin - made[1].plane.origin), 0.05)

    def test_margin_is_from_open_edges(self):
        margin = 1.5
        dimples = place_texture(given_on(self.surface, margin=margin)).dimples
        cut = dimples.positions[dimples.states == core.DimpleState.CUT]
        self.assertGreater(len(cut), 100)
        self.assertLess(np.abs(cut[:, :2]).max(), 6.0 - 0.9 * margin)
        near = dimples.positions[dimples.states == core.DimpleState.NEAR_EDGE]
        self.assertGreater(len(near), 100)

    def test_plan_is_simulated_on_the_mesh_as_on_the_face(self):
        window = ((-1.5, -1.5), (1.5, 1.5))
        quality = [
            patchmill.simulate(plan_texture(given), window=window).quality
            for given in (given_on(self.surface), given_on(breps=[self.text]))
        ]
        self.assertGreater(quality[0], 0.9)
        self.assertAlmostEqual(*quality, delta=0.01)

    def test_outlines_lie_on_the_mesh(self):
        placed = place_texture(given_on(self.surface))
        points = np.concatenate(outlines_on_faces(placed))
        points = points[np.isfinite(points).all(axis=1)]
        self.assertGreater(len(points), 50)
        self.assertLess(np.abs(points[:, 2] - height(points[:, 0], points[:, 1])).max(), 0.15)

    def refused(self, name, **values):
        with self.assertRaises(patchmill.InputError) as caught:
            place_texture(given_on(self.surface, **values))
        self.assertEqual(caught.exception.property, name)
        return caught.exception.remedy

    def test_what_only_faces_have_is_refused_and_the_remedy_helps(self):
        for mapping in ("On surface", "Ball"):
            self.assertIn("choose Projected", self.refused("Mapping", mapping=mapping))
        self.assertIn("choose Helix or Rows", self.refused("Order", order="Thread"))
        self.assertIn("a mesh or faces", self.refused("Mesh", breps=[self.text]))
        for values in ({"mapping": "Projected"}, {"order": "Helix"}, {"order": "Rows"}):
            counts = dict(place_texture(given_on(self.surface, **values)).dimples.counts())
            self.assertGreater(counts["cut"], 300)


class Regions(unittest.TestCase):
    def setUp(self):
        vertices, triangles = mesh_of(wavy_face(), 0.5)
        self.open_count = len(triangles)
        self.whole = core.TriangleMesh(*block_of(vertices, triangles))

    def test_top_of_a_block(self):
        region = patchmill.mesh_region(self.whole, nearest=(0, 0, 9), angle=45)
        self.assertEqual(region.triangle_count, self.open_count)

    def test_whole_and_by_number(self):
        self.assertEqual(patchmill.mesh_region(self.whole).triangle_count, len(self.whole))
        self.assertEqual(patchmill.mesh_region(self.whole, triangles=[3, 5, 7]).triangle_count, 3)

    def test_bad_choices_are_refused(self):
        bad = [
            ("Region", {"nearest": (0, 0, 0), "triangles": [1]}),
            ("Point", {"nearest": (0, 0)}),
            ("Point", {"nearest": "top"}),
            ("Point", {"nearest": (0, 0, math.nan)}),
            ("Angle", {"nearest": (0, 0, 0), "angle": 181}),
            ("Angle", {"nearest": (0, 0, 0), "angle": "30"}),
            ("Triangles", {"triangles": []}),
            ("Triangles", {"triangles": [0.5]}),
            ("Triangles", {"triangles": [len(self.whole)]}),
            ("Triangles", {"triangles": [-1]}),
            ("Triangles", {"triangles": 3}),
            ("Crease", {"crease": 91}),
        ]
        for name, values in bad:
            with self.assertRaises(patchmill.InputError, msg=values) as caught:
                patchmill.mesh_region(self.whole, **values)
            self.assertEqual(caught.exception.property, name)


class Sources(unittest.TestCase):
    def tearDown(self):
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = lambda name: os.path.join(folder.name, name)

    def test_files_and_objects_are_the_same_triangles(self):
        vertices, triangles = mesh_of(wavy_face(), 1.0)
        facets = Mesh.Mesh([[tuple(vertices[k]) for k in t] for t in triangles])
        whole = patchmill.mesh(facets)
        self.assertEqual((len(whole), len(whole.vertices)), (len(triangles), len(vertices)))
        for ending in (".stl", ".obj", ".ply"):
            facets.write(self.path("m" + ending))
            read = patchmill.mesh(self.path("m" + ending))
            self.assertEqual((len(read), len(read.vertices)), (len(triangles), len(vertices)), ending)
            self.assertLess(np.abs(_sorted(read.vertices) - _sorted(vertices)).max(), 1e-5)

    def test_an_object_lies_where_it_is_drawn(self):
        document = FreeCAD.newDocument("meshes")
        obj = document.addObject("Mesh::Feature", "Scan")
        obj.Mesh = Mesh.Mesh(Part.makeBox(2, 3, 4).tessellate(0.1))
        obj.Placement = FreeCAD.Placement(V(10, 0, 0), FreeCAD.Rotation(V(0, 0, 1), 90))
        group = document.addObject("App::Part", "Around")
        group.addObject(obj)
        group.Placement = FreeCAD.Placement(V(0, 0, 7), FreeCAD.Rotation())
        found = patchmill.mesh(obj).vertices
        self.assertLess(np.abs(found.min(axis=0) - (7, 0, 7)).max(), 1e-5)
        self.assertLess(np.abs(found.max(axis=0) - (10, 2, 11)).max(), 1e-5)

    def test_what_is_no_mesh_is_refused(self):
        with open(self.path("text.stl"), "w") as file:
            file.write("nothing of the kind")
        document = FreeCAD.newDocument("meshes")
        box = document.addObject("Part::Box", "Box")
        for part in (box, 3, self.path("none.stl"), self.path("text.stl"), self.path("x.step"), Mesh.Mesh()):
            with self.assertRaises(patchmill.InputError, msg=part) as caught:
                patchmill.mesh(part)
            self.assertEqual(caught.exception.property, "Mesh")


def _sorted(points):
    points = np.round(points, 4) + 0.0
    return points[np.lexsort(points.T)]


class Programs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = lambda name: os.path.join(folder.name, name)
        self.open = mesh_of(wavy_face())
        self.values = dict(nearest=(0, 0, 9), angle=45, spacing=0.5, patch_side=6, decimals=4, margin=1.2)

    def test_from_a_closed_file_to_a_checked_program(self):
        write_stl(self.path("part.stl"), *block_of(*self.open))
        made = patchmill.mesh_texture(self.path("part.stl"), self.path("part.ngc"), **self.values)
        self.assertTrue(made.check.clear, made.check.sentence)
        self.assertEqual(made.posted.match.found, made.plan.counts["cut"])
        self.assertIn("triangles", made.text())
        window = ((-1.5, -1.5), (1.5, 1.5))
        found = patchmill.simulate(made.plan, program=self.path("part.ngc"), window=window)
        self.assertGreater(found.quality, 0.9)

    def test_an_open_mesh_is_unknown_and_written_only_if_told(self):
        write_stl(self.path("scan.stl"), *self.open)
        with self.assertRaises(patchmill.InputError) as caught:
            patchmill.mesh_texture(self.path("scan.stl"), self.path("scan.ngc"), **self.values)
        self.assertEqual(caught.exception.property, "unchecked")
        self.assertFalse(os.path.exists(self.path("scan.ngc")))
        made = patchmill.mesh_texture(
            self.path("scan.stl"), self.path("scan.ngc"), unchecked=True, **self.values
        )
        self.assertEqual(made.check.outcome, "unknown")
        self.assertIn("unmatched edges", made.check.sentence)
        self.assertTrue(os.path.exists(self.path("scan.ngc")))

    def test_values_and_kinds_that_it_does_not_have_are_refused(self):
        write_stl(self.path("scan.stl"), *self.open)
        bad = ("colour", {"colour": 1}), ("breps", {"breps": []}), ("kind", {"kind": "Round"})
        for name, values in bad:
            with self.assertRaises(patchmill.InputError) as caught:
                patchmill.mesh_texture(self.path("scan.stl"), **values)
            self.assertEqual(caught.exception.property, name)

    def test_stops_when_it_is_told(self):
        write_stl(self.path("scan.stl"), *self.open)
        made = patchmill.mesh_texture(
            self.path("scan.stl"), self.path("x.ngc"), progress=lambda share: False, **self.values
        )
        self.assertIsNone(made)
        self.assertFalse(os.path.exists(self.path("x.ngc")))


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)

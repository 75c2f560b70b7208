"""What the compiled core hands over to be shown is read by FreeCAD's own Coin, and says what it was made
from.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import _patchmill as core  # noqa: E402
import numpy as np  # noqa: E402
from pivy import coin  # noqa: E402

if not coin.SoDB.isInitialized():  # nothing in FreeCADCmd needs it
    coin.SoDB.init()


def read(chunk):
    source = coin.SoInput()
    source.setBuffer(chunk)
    root = coin.SoDB.readAll(source)
    assert root is not None, "Coin cannot read it"
    root.ref()  # else it goes with the first path that leads to it
    return root


def found(root, kind):
    """All nodes of a kind, also in a level of detail that is not drawn now, and in a node kit."""
    nodes = _search(root, kind)
    for kit in _search(root, coin.SoWrapperKit):
        nodes += found(kit.getPart("contents", False), kind)
    return nodes


def _search(root, kind):
    search = coin.SoSearchAction()
    search.setType(kind.getClassTypeId())
    search.setInterest(coin.SoSearchAction.ALL)
    search.setSearchingAll(True)
    search.apply(root)
    paths = search.getPaths()
    return [paths[i].getTail() for i in range(paths.getLength())]


def vertices(shape):
    return np.array([p.getValue() for p in shape.vertexProperty.getValue().vertex.getValues(0)])


def colours(shape):
    return list(shape.vertexProperty.getValue().orderedRGBA.getValues(0))


class SceneFiles(unittest.TestCase):
    def test_lines_arrive_with_every_vertex_length_and_width(self):
        first = np.array([[0.0, 0.0, 0.0], [1.0, 2.0, 3.0], [-4.5, 5.25, 1e-6]])
        gap = np.full((1, 3), np.nan)
        second = np.array([[1e6, -1e-3, 7.0], [8.0, 9.0, 10.0]])
        display = core.outline_display([np.vstack([first, gap, second])])
        self.assertEqual(len(display), 1)
        root = read(display.chunk(0))
        (lines,) = found(root, coin.SoLineSet)
        np.testing.assert_array_equal(vertices(lines), np.vstack([first, second]).astype(np.float32))
        self.assertEqual(list(lines.numVertices.getValues(0)), [3, 2])
        self.assertEqual(colours(lines), [0x303030FF] * 5)
        self.assertEqual(found(root, coin.SoDrawStyle)[0].lineWidth.getValue(), 1.5)
        light = found(root, coin.SoLightModel)[0]
        self.assertEqual(light.model.getValue(), coin.SoLightModel.BASE_COLOR)

    def test_no_line_is_no_shape(self):
        root = read(core.outline_display([np.zeros((1, 3))]).chunk(0))
        self.assertEqual(found(root, coin.SoLineSet), [])

    def test_squares_arrive_with_corners_binding_and_offset(self):
        centres = np.array([[0.0, 0.0, 0.5], [2.0, 0.0, 0.5]])
        root = read(core.slice_display(centres, [0.0, 1.0], 2.0, 2, 0.0, 1.0).chunk(0))
        (faces,) = found(root, coin.SoIndexedFaceSet)
        self.assertEqual(len(vertices(faces)), 8)
        np.testing.assert_allclose(vertices(faces)[:4].mean(axis=0), centres[0], atol=1e-6)
        index = list(faces.coordIndex.getValues(0))
        self.assertEqual(index, [0, 1, 2, -1, 0, 2, 3, -1, 4, 5, 6, -1, 4, 6, 7, -1])
        property = faces.vertexProperty.getValue()
        self.assertEqual(property.materialBinding.getValue(), coin.SoVertexProperty.PER_VERTEX_INDEXED)
        low, high = (core.scale_colour(share) for share in (0.0, 1.0))
        seen = colours(faces)
        self.assertEqual([(c >> 24, c >> 16 & 255, c >> 8 & 255) for c in (seen[0], seen[4])], [low, high])
        offset = found(root, coin.SoPolygonOffset)[0]
        self.assertEqual((offset.factor.getValue(), offset.units.getValue()), (-1.0, -4.0))
        hints = found(root, coin.SoShapeHints)[0]
        self.assertEqual(hints.vertexOrdering.getValue(), coin.SoShapeHints.UNKNOWN_ORDERING)
        self.assertEqual(hints.faceType.getValue(), coin.SoShapeHints.CONVEX)

    def test_a_surface_arrives_at_four_resolutions_with_unit_normals(self):
        x, y = np.meshgrid(np.linspace(0.0, 3.0, 40), np.linspace(0.0, 2.0, 30))
        points = np.dstack([x, y, 0.5 * x])
        root = read(core.grid_display(points, points[:, :, 2], 0.0, 1.5).chunk(0))
        (detail,) = found(root, coin.SoLevelOfDetail)
        self.assertEqual(list(detail.screenArea.getValues(0)), [200000.0, 50000.0, 6000.0])
        copies = found(root, coin.SoIndexedFaceSet)
        self.assertEqual(len(copies), 4)
        np.testing.assert_array_equal(vertices(copies[0]), points.reshape(-1, 3).astype(np.float32))
        triangles = list(copies[0].coordIndex.getValues(0))
        self.assertEqual(len(triangles), 4 * 2 * 39 * 29)
        property = copies[0].vertexProperty.getValue()
        normals = np.array([n.getValue() for n in property.normal.getValues(0)])
        np.testing.assert_allclose(normals, np.tile([-0.5, 0.0, 1.0], (1200, 1)) / np.sqrt(1.25), atol=1e-6)
        self.assertEqual(property.normalBinding.getValue(), coin.SoVertexProperty.PER_VERTEX_INDEXED)
        material = found(root, coin.SoMaterial)[0]
        self.assertEqual(material.specularColor.getValues(0)[0].getValue(), (0.0, 0.0, 0.0))

    def test_dimples_arrive_as_discs_and_as_points(self):
        import bound_things as t

        root = read(core.dimple_display(t.dimples, 0.2).chunk(0))
        discs, (points, few) = found(root, coin.SoIndexedFaceSet), found(root, coin.SoPointSet)
        self.assertEqual(len(vertices(discs[0])), 6 * len(vertices(points)))
        self.assertEqual(len(vertices(few)), -(-len(vertices(points)) // 16))
        self.assertEqual(found(root, coin.SoDrawStyle)[0].pointSize.getValue(), 3.0)


class WithoutCoin(unittest.TestCase):
    def test_nothing_compiled_links_coin_or_an_x_library(self):
        needed = subprocess.run(["readelf", "-d", core.__file__], capture_output=True, text=True)
        self.assertEqual(needed.returncode, 0, needed.stderr)
        self.assertIn("NEEDED", needed.stdout)
        for library in ("Coin", "libX", "libGL", "libTKV3d", "libTKService"):
            self.assertNotIn(library, needed.stdout)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)

"""Height maps: what is written is read by others' programs with the same heights, and by ours; damaged files
are refused by name.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import random
import struct
import subprocess
import tempfile
import tracemalloc
import unittest
from pathlib import Path

import numpy as np
from patchmill import InputError
from patchmill.surface import files
from patchmill.surface.height_map import HeightMap

GRIDS = (".gsf", ".sdf", ".x3p", ".tif", ".exr", ".csv")
RESOLUTION = {".gsf": 1e-8, ".sdf": 1e-15, ".x3p": 1e-15, ".tif": 2e-6, ".exr": 1e-8, ".csv": 1e-9}  # mm


def sample(rows=40, columns=60, holes=True):
    """A relief that is not the same turned, mirrored or transposed."""
    x, y = np.meshgrid(np.arange(columns) / 5.0, np.arange(rows) / 7.0)
    heights = 0.05 * np.sin(x) * np.cos(y) + 0.002 * x - 0.004 * y
    if holes:
        heights[3, 4:9] = np.nan
        heights[-1, -1] = np.nan
    return HeightMap(heights, (0.02, 0.03), (1.5, -2.0), "A sample")


def gwyddion(name):
    """Arrays of the fields that Gwyddion finds in a file: numbers in m, the top row first."""
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "out.gwy")
        command = ["xvfb-run", "-a", "gwyddion", "--convert-to-gwy=" + out, name]
        subprocess.run(command, check=True, capture_output=True, timeout=120)
        content, at, found = Path(out).read_bytes(), 0, []
    while (at := content.find(b"data\0D", at)) >= 0:
        count = struct.unpack_from("<I", content, at + 6)[0]
        found.append(np.frombuffer(content, "<f8", count, at + 10))
        at += 10
    return found


class Slope:
    """A relief that is computed when it is asked for."""

    def __init__(self, rows):
        self.shape = (rows, 500)

    def points(self, first, end):
        x, y = np.meshgrid(np.arange(500.0), np.arange(float(first), float(end)))
        return np.dstack([x, y, x + y])


class HeightMaps(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def name(self, ending):
        return os.path.join(self.folder.name, "relief" + ending)

    def saved(self, ending, surface=None):
        files.save(self.name(ending), surface or sample())
        return self.name(ending)

    def assert_heights(self, read, wanted, within):
        self.assertEqual(read.shape, wanted.shape)
        np.testing.assert_array_equal(np.isnan(read), np.isnan(wanted))
        self.assertLessEqual(np.nanmax(abs(read - wanted)), within)

    def test_every_grid_is_read_back(self):
        for ending in GRIDS:
            with self.subTest(ending):
                read, wanted = files.load(self.saved(ending)), sample()
                self.assert_heights(read.heights, wanted.heights, RESOLUTION[ending])
                np.testing.assert_allclose(read.step, wanted.step, rtol=1e-12)
                if ending != ".sdf":  # it has no place for an origin
                    np.testing.assert_allclose(read.origin, wanted.origin, rtol=1e-12)

    def test_gwyddion_reads_the_same_heights(self):
        wanted = sample(holes=False)
        for ending, rows in ((".gsf", slice(None, None, -1)), (".sdf", slice(None)), (".x3p", slice(None))):
            with self.subTest(ending):
                (read,) = gwyddion(self.saved(ending, wanted))
                self.assert_heights(
                    1e3 * read.reshape(wanted.shape)[rows], wanted.heights, RESOLUTION[ending]
                )

    def test_tifffile_reads_the_same_heights(self):
        read = subprocess.run(
            ["/usr/bin/python3", "-c",
             "import sys, tifffile, json, numpy; f = tifffile.TiffFile(sys.argv[1]); p = f.pages[0]\n"
             "h = json.loads(p.description)['height_mm']; a = p.asarray().astype(float)\n"
             "numpy.save(sys.argv[2], numpy.where(a > 0, h['grey_1'] + (a - 1) * h['each_grey'], numpy.nan))",
             self.saved(".tif"), self.name(".npy")], capture_output=True, text=True, timeout=120,
        )  # fmt: skip
        self.assertEqual(read.returncode, 0, read.stderr)
        self.assert_heights(np.load(self.name(".npy"))[::-1], sample().heights, RESOLUTION[".tif"])

    def test_opencv_reads_the_same_heights_from_openexr(self):
        read = subprocess.run(
            ["/usr/bin/python3", "-c", "import sys, cv2, numpy\n"
             "numpy.save(sys.argv[2], cv2.imread(sys.argv[1], cv2.IMREAD_UNCHANGED))",
             self.saved(".exr"), self.name(".npy")], capture_output=True, text=True, timeout=120,
            env={**os.environ, "OPENCV_IO_ENABLE_OPENEXR": "1"},
        )  # fmt: skip
        self.assertEqual(read.returncode, 0, read.stderr)
        self.assert_heights(np.load(self.name(".npy"))[::-1], sample().heights, RESOLUTION[".exr"])

    def test_vtk_reads_the_same_heights(self):
        import vtk
        from vtk.util.numpy_support import vtk_to_numpy

        reader = vtk.vtkXMLImageDataReader()
        reader.SetFileName(self.saved(".vti"))
        reader.Update()
        image, wanted = reader.GetOutput(), sample()
        self.assertEqual(image.GetDimensions(), (60, 40, 1))
        self.assertEqual(image.GetSpacing()[:2], wanted.step)
        self.assertEqual(image.GetOrigin()[:2], wanted.origin)
        self.assert_heights(
            vtk_to_numpy(image.GetPointData().GetScalars()).reshape(40, 60), wanted.heights, 1e-15
        )

    def test_assimp_and_freecad_read_the_same_meshes(self):
        import Mesh

        wanted = sample()
        cells = wanted.known
        cells = cells[1:, 1:] & cells[1:, :-1] & cells[:-1, 1:] & cells[:-1, :-1]
        for ending in (".stl", ".ply"):
            with self.subTest(ending):
                name = self.saved(ending)
                read = Mesh.Mesh(name)
                self.assertEqual(read.CountFacets, 2 * cells.sum())
                self.assertAlmostEqual(read.BoundBox.ZMax, np.nanmax(wanted.heights), 6)
                self.assertTrue(all(facet.Normal.z > 0 for facet in read.Facets))
                told = subprocess.run(["assimp", "info", name], capture_output=True, text=True, timeout=60)
                faces = [line.split()[-1] for line in told.stdout.splitlines() if line.startswith("Faces:")]
                self.assertEqual(faces, [str(2 * cells.sum())])

    def test_a_scan_is_laid_on_a_grid(self):
        x, y = np.meshgrid(np.arange(60) * 0.02, np.arange(40) * 0.02)
        plane = HeightMap(0.3 * x - 0.2 * y, 0.02)
        for ending in (".stl", ".ply"):
            with self.subTest(ending):
                read = files.load(self.saved(ending, plane), step=0.02)
                self.assert_heights(read.heights, plane.heights, 1e-6)

    def test_a_mesh_takes_memory_for_a_block_only(self):
        most = []
        for rows in (500, 2500):
            tracemalloc.start()
            try:
                files.save(self.name(".stl"), None, Slope(rows))
                most.append(tracemalloc.get_traced_memory()[1])
            finally:
                tracemalloc.stop()
            self.assertEqual(os.path.getsize(self.name(".stl")), 84 + 50 * 2 * (rows - 1) * 499)
        self.assertLess(most[1], 1.1 * most[0])

    def test_damaged_files_are_refused_by_name(self):
        chance = random.Random(7)
        for ending in (*GRIDS, ".stl", ".ply"):
            good = Path(self.saved(ending, sample(6, 7))).read_bytes()
            for _ in range(300):
                content = bytearray(good)
                for _ in range(chance.randint(1, 6)):
                    content[chance.randrange(min(len(content), 700))] = chance.randrange(256)
                end = chance.choice([len(content), chance.randrange(900)])
                Path(self.name(ending)).write_bytes(content[:end])
                try:
                    self.assertIsInstance(files.load(self.name(ending), 0.02, 0.001), HeightMap)
                except InputError as error:
                    self.assertIn(error.property, ("Surface", "GridStep", "Origin", "Heights"))
                    self.assertTrue(error.remedy)

    def test_a_small_file_that_promises_much_is_refused(self):
        from patchmill.surface import gsf, sdf

        for module, content in (
            (gsf, gsf.MAGIC + b"XRes = 100000\nYRes = 100000\n" + b"\0" * 8),
            (sdf, sdf.HEADER.pack(b"bISO-1.0", b"", b"", b"", 60000, 60000, 1e-6, 1e-6, 1, -1, 0, 7, 0)),
        ):
            with self.assertRaises(InputError) as raised:
                module.read(content)
            self.assertEqual(raised.exception.property, "Surface")

    def test_a_pipe_or_device_is_refused_at_once(self):
        for make in (os.mkfifo, lambda name: os.symlink("/dev/zero", name)):
            for ending in (*GRIDS, ".stl", ".ply"):
                with self.subTest(ending):
                    name = self.name(ending)
                    make(name)
                    with self.assertRaises(InputError) as raised:
                        files.load(name, 0.02, 0.001)
                    self.assertEqual(raised.exception.property, "filename")
                    self.assertIn("a device or a pipe", raised.exception.remedy)
                    os.remove(name)

    def test_an_unknown_ending_is_refused(self):
        with self.assertRaises(InputError) as raised:
            files.save(self.name(".xyz"), sample())
        self.assertIn(".x3p", raised.exception.remedy)


if __name__ == "__main__":
    unittest.main()

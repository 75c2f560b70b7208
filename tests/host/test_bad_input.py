"""Bad input: a typed error that names the property, in FreeCADCmd exit status 1, and no G-code file.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import importlib
import pathlib
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

import _patchmill as core
import FreeCAD
import patchmill

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
from patchmill.freecad import host  # noqa: E402
from recipe import ROOT, small_job  # noqa: E402


def no_ball_end_mill(job, operation):
    operation.ToolController.Tool = host.append_controller(job).Tool


def no_face(job, operation):
    operation.Base = []


def edge_instead_of_face(job, operation):
    operation.Base = [(job.Model.Group[0], ["Edge1"])]


def spacing_zero(job, operation):
    operation.Spacing = 0.0


def spacing_nan(job, operation):
    operation.Spacing = float("nan")


def patch_larger_than_any(job, operation):
    operation.PatchSide = 20000


def speed_zero(job, operation):
    operation.ToolController.SpindleSpeed = 0.0


def feed_too_small(job, operation):
    operation.ToolController.HorizFeed = 20.0 / 60.0


def no_flutes(job, operation):
    operation.ToolController.Tool.Flutes = 0


def spindle_stands(job, operation):
    operation.ToolController.SpindleDir = "None"


def other_decimals_than_the_post(job, operation):
    job.PostProcessorArgs = "--no-header --no-show-editor --precision=4"


def inches(job, operation):
    job.PostProcessorArgs = "--no-header --no-show-editor --precision=3 --inches"


def low_safe_height(job, operation):
    operation.setExpression("SafeHeight", None)
    operation.SafeHeight = 5.0


CASES = {
    no_ball_end_mill: "ToolController",
    no_face: "Base",
    edge_instead_of_face: "Base",
    spacing_zero: "Spacing",
    spacing_nan: "Spacing",
    patch_larger_than_any: "PatchSide",
    speed_zero: "SpindleSpeed",
    feed_too_small: "Feed",
    no_flutes: "Flutes",
    spindle_stands: "SpindleDirection",
    other_decimals_than_the_post: "Decimals",
    inches: "PostProcessorArgs",
    low_safe_height: "SafeHeight",
}


def run_case(case, filename):
    """A user's macro with the mistake in it."""
    document, job, operation = small_job()
    case(job, operation)
    patchmill.recompute(operation)
    patchmill.post(job, filename)


class BadInput(unittest.TestCase):
    def tearDown(self):
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)

    def test_names_the_property_and_leaves_no_file(self):
        for case, name in CASES.items():
            with self.subTest(case.__name__), tempfile.TemporaryDirectory() as folder:
                with self.assertRaises(patchmill.InputError) as caught:
                    run_case(case, str(pathlib.Path(folder) / "x.ngc"))
                self.assertEqual(caught.exception.property, name)
                self.assertTrue(caught.exception.remedy)
                self.assertEqual(list(pathlib.Path(folder).iterdir()), [])
            self.tearDown()

    def test_an_operation_that_fails_keeps_no_old_path(self):
        document, job, operation = small_job()
        patchmill.recompute(operation)
        self.assertGreater(operation.Path.Size, 100)
        operation.Spacing = 0.0
        with self.assertRaises(patchmill.InputError):
            patchmill.recompute(operation)
        self.assertEqual(operation.Path.Size, 0)

    def test_an_existing_file_is_left_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "x.ngc"
            file.write_text("old")
            with self.assertRaises(patchmill.InputError):
                run_case(spacing_zero, str(file))
            self.assertEqual(file.read_text(), "old")


class Macros(unittest.TestCase):
    """What a macro may get wrong in its calls."""

    def setUp(self):
        self.document, self.job, self.operation = small_job()
        self.addCleanup(FreeCAD.closeDocument, self.document.Name)

    def refused(self, name, function, *arguments, **named):
        with self.subTest(name, arguments=repr(arguments), named=repr(named)):
            with self.assertRaises(patchmill.InputError) as caught:
                function(*arguments, **named)
            self.assertEqual(caught.exception.property, name)

    def test_places_that_cannot_be_written_are_refused_before_the_work(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("", folder, folder + "/missing/x.ngc", None, 5, 0.5, [folder]):
                self.refused("filename", patchmill.post, self.job, name)
                self.refused("filename", patchmill.post_files, self.job, name)

    def test_a_file_that_cannot_be_put_in_its_place_leaves_nothing(self):
        patchmill.recompute(self.operation)
        with tempfile.TemporaryDirectory() as folder:
            with mock.patch("os.replace", side_effect=OSError("the disk is full")):
                self.refused("filename", patchmill.post, self.job, folder + "/x.ngc")
            self.assertEqual(list(pathlib.Path(folder).iterdir()), [])

    def test_modules_that_the_documentation_names_are_there(self):
        for name in ("advisor", "dcm", "live", "removal_model", "tilted_path"):
            self.assertIs(patchmill.__getattr__(name), importlib.import_module("patchmill." + name))

    def test_things_that_are_no_operations_are_refused(self):
        for thing in (None, self.job):
            self.refused("Operation", patchmill.recompute, thing)
            for function in (patchmill.planned, patchmill.simulate, patchmill.check):
                self.refused("Operation", function, thing)
        self.refused("Operation", patchmill.live.start, self.operation, 1.0, 5.0, 10.0)
        self.refused("Machine", patchmill.simulate, self.operation, machine=5)

    def test_arguments_of_simulate_and_advise_are_refused_by_name(self):
        for window in ("all", ((0, 0), (float("inf"), 1)), ((1, 1), (0, 0))):
            self.refused("Window", patchmill.simulate, self.operation, window=window)
        self.refused("Samples", patchmill.simulate, self.operation, samples="none")
        wish = dict(diameter=2, flutes=2, speed=1000, side=14, spacing=0.5)
        for name, property_name in (("diameter", "Diameter"), ("speed", "SpindleSpeed")):
            self.refused(property_name, patchmill.advise, **dict(wish, **{name: -1.0}))

    def test_an_error_that_quotes_a_piece_of_a_character_is_a_sentence(self):
        for text in ("G21\nG0 X1 Ä2\n", "G0 X1\u200b\n", "G1 X1 €\n"):
            with self.assertRaises(patchmill.InputError) as caught:
                core.read_gcode(text, core.Tool(1.0, 2))
            self.assertIn("line", str(caught.exception))

    def test_a_check_that_looked_at_nothing_is_unknown(self):
        result = patchmill.check(self.operation, first_move=10**9)
        self.assertEqual(result.outcome, "unknown")
        self.assertIn("No move", result.sentence)


class ExitStatus(unittest.TestCase):
    """Each mistake in a FreeCADCmd of its own."""

    def run_alone(self, case_name, folder):
        program = str(pathlib.Path(folder) / "x.ngc")
        command = [str(ROOT / "tools" / "freecad"), __file__, "case", case_name, program]
        return subprocess.run(command, capture_output=True, text=True)

    def test_is_1_with_the_reason_and_no_file(self):
        for case, name in CASES.items():
            with self.subTest(case.__name__), tempfile.TemporaryDirectory() as folder:
                done = self.run_alone(case.__name__, folder)
                self.assertEqual(done.returncode, 1)
                self.assertIn(name + " = ", done.stdout + done.stderr)
                self.assertEqual(list(pathlib.Path(folder).iterdir()), [])

    def test_is_0_without_a_mistake(self):
        with tempfile.TemporaryDirectory() as folder:
            done = self.run_alone("nothing", folder)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertEqual([f.name for f in pathlib.Path(folder).iterdir()], ["x.ngc"])


def nothing(job, operation):
    pass


if __name__ == "__main__":
    if sys.argv[1:2] == ["case"]:
        run_case(globals()[sys.argv[2]], sys.argv[3])
        sys.exit(0)
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)

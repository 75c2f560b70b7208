"""Tool bits of FreeCAD as the core's tools, and a bull nose at work in copy milling and in its check.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import pathlib
import sys
import types
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.path.insert(0, str(HERE.parents[1] / "Resources" / "recipes" / "kobayashi2014"))

import _patchmill as core  # noqa: E402
import FreeCAD  # noqa: E402
import make_parts  # noqa: E402
from _patchmill import InputError  # noqa: E402
from milling_jobs import make_job  # noqa: E402
from patchmill import CopyMilling  # noqa: E402
from patchmill.freecad import host, tool_controller  # noqa: E402


def controller_with(kind, **said):
    bit = types.SimpleNamespace(ShapeName=kind, Label="A bit", Diameter=6.0, Flutes=3, **said)
    return types.SimpleNamespace(Tool=bit, Label="TC")


class Cutters(unittest.TestCase):
    def test_each_kind_of_bit(self):
        ball = tool_controller.cutter(controller_with("ballend"))
        self.assertEqual((ball.radius, ball.flutes, ball.is_ball), (3.0, 3, True))
        flat = tool_controller.cutter(controller_with("endmill"))
        self.assertEqual((flat.corner_radius, flat.name), (0.0, "flat end mill"))
        # FreeCAD 0.20's drawing of a bull nose says how wide its flat bottom is
        for said in ({"FlatRadius": 1.5}, {"CornerRadius": 1.5}):
            bull = tool_controller.cutter(controller_with("bullnose", **said))
            self.assertEqual((bull.corner_radius, bull.name), (1.5, "bull nose end mill"))
        tapered = tool_controller.cutter(controller_with("taperedballnose", TaperAngle=10.0))
        self.assertAlmostEqual(math.degrees(tapered.taper), 5.0)
        self.assertEqual(tapered.name, "tapered ball end mill")
        for kind in ("v-bit", "VBit", "chamfer"):  # of FreeCAD 0.20, of 1.1, and as both name it
            said = {"TipDiameter": 0.5, "CuttingEdgeAngle": 90.0, "CuttingEdgeHeight": 2.5}
            cone = tool_controller.cutter(controller_with(kind, **said))
            self.assertEqual((cone.radius, cone.corner_radius, cone.name), (0.25, 0.0, "conical end mill"))
            self.assertAlmostEqual(math.degrees(cone.taper), 45.0)
            self.assertEqual(cone.cutting_length, 2.5)

    def test_edges_shank_and_length(self):
        tool = tool_controller.cutter(controller_with("ballend"))  # of 6 mm: what its bit does not say
        self.assertEqual((tool.cutting_length, tool.shank_radius, tool.stick_out), (12.0, 3.0, 60.0))
        said = {"CuttingEdgeHeight": 10.0, "ShankDiameter": 8.0, "Length": 45.0}
        tool = tool_controller.cutter(controller_with("ballend", **said))
        self.assertEqual((tool.cutting_length, tool.shank_radius, tool.stick_out), (10.0, 4.0, 45.0))

    def test_what_is_no_end_mill_is_refused_by_its_kind(self):
        for controller, name in (
            (controller_with("drill"), "ToolController"),
            (controller_with("bullnose", FlatRadius=3.5), "FlatRadius"),
            (controller_with("v-bit", TipDiameter=0.0, CuttingEdgeAngle=60.0), "TipDiameter"),
            (controller_with("v-bit", TipDiameter=0.1, CuttingEdgeAngle=121.0), "CuttingEdgeAngle"),
            (controller_with("v-bit", TipDiameter=0.1, CuttingEdgeAngle=0.0), "CuttingEdgeAngle"),
        ):
            with self.assertRaises(InputError) as caught:
                tool_controller.cutter(controller)
            self.assertEqual(caught.exception.property, name)
        # of any other bit the tip is known: that is where a feed is read
        self.assertEqual(tool_controller.any_cutter(controller_with("drill")).corner_radius, 0.0)
        pointed = controller_with("v-bit", TipDiameter=0.0, CuttingEdgeAngle=60.0)
        self.assertFalse(tool_controller.is_known(pointed.Tool))
        self.assertEqual(tool_controller.any_cutter(pointed).taper, 0.0)

    def test_a_bull_nose_mills_a_copy_and_gouges_nothing(self):
        document, job = make_job(make_parts.convex_part(), "bull", ball=True)
        bit = host.tool_controllers(job)[0].Tool
        operation = CopyMilling.Create("CopyMilling", parentJob=job)
        operation.Mode, operation.RadialDepth, operation.AxialDepth = "Scanning", 5.0, 8.0
        bull = core.Tool(float(bit.Diameter) / 2.0, 2, 1.0)
        known, tool_controller.cutter = tool_controller.cutter, lambda *_: bull
        try:
            CopyMilling.recompute(operation)
        finally:
            tool_controller.cutter = known
        path = operation.Proxy.path
        self.assertEqual(path.tool, bull)
        # 1 mm of 5 mm between the lines is beside the flat bottom of 4 mm: 1 - cos(asin(0.5))
        self.assertAlmostEqual(operation.Scallop, 1.0 - math.sqrt(0.75), places=9)
        part = core.part_model([job.Model.Group[0].Shape.exportBrepToString()], 0.005)
        self.assertTrue(part.known, part.reason)
        found = core.check_clearance(path, part, 0.02, 0.1, resolution=0.005)
        self.assertEqual(found["outcome"], "clear", found["reason"])
        # a tool that is told to be lower by 0.1 mm is seen
        lower = path.tips - [0.0, 0.0, 0.1]
        sunk = core.make_path(
            path.tool, path.spindle, path.start, lower, None, list(path.kinds), list(path.turns)
        )
        found = core.check_clearance(sunk, part, 0.02, 0.1, resolution=0.005)
        self.assertEqual(found["outcome"], "violated")
        self.assertEqual(set(found["parts"]), {"cutting end"})
        FreeCAD.closeDocument(document.Name)


if __name__ == "__main__":
    result = unittest.main(exit=False).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)

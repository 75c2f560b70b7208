"""The cutting load of a DCM modifier: what it is along a path, and that its limits are kept.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import pathlib
import sys
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import _patchmill as core  # noqa: E402
import numpy as np  # noqa: E402
import patchmill  # noqa: E402
from milling_jobs import CONTACT, HIGH, add_pocket, add_profile, contact_off, dress  # noqa: E402
from milling_jobs import make_job, pocket_part  # noqa: E402
from parts import WithDocuments  # noqa: E402
from patchmill import DressupDCM, InputError  # noqa: E402
from patchmill.freecad import host  # noqa: E402
from patchmill.modifiers import cutting_load, dcm_input  # noqa: E402

FLUTES = 2


def pocket(**properties):
    """A DressupDCM on FreeCAD's own pocket, with flutes that are said."""
    document, job = make_job(pocket_part())
    operation = add_pocket(job)
    host.tool_controllers(job)[0].Tool.Flutes = FLUTES
    return operation, dress(operation, **properties)


class CuttingLoad(WithDocuments):
    def test_a_slot_as_known_in_closed_form(self):
        stock, part = core.Solid.box((0, 0, 0), (20, 20, 10)), core.Solid.box((0, 0, 0), (20, 20, 2))
        grid = core.voxelise(stock, part, 0.5)
        tool, spindle = core.Tool(3.0, FLUTES, 0.0), core.Spindle(100.0, "M3")
        tips, feed, depth = np.array([[12.0, 10.0, 6.0]]), 20.0, 4.0
        turns = [100.0 * 16.0 / feed]
        path = core.make_path(tool, spindle, (-4.0, 10.0, 6.0), tips, None, [core.MoveKind.CUT], turns)
        load = core.load_along(path, grid, 2000.0, 0.25, 0.3)
        deep = load["at"] > 0.7
        removal = 2.0 * 3.0 * depth * feed
        np.testing.assert_allclose(load["removal"][deep].mean(), removal, rtol=0.03)
        per_tooth = feed / 100.0 / FLUTES
        force = 2000.0 * per_tooth**0.75 * depth * np.hypot(1.0, 0.3)
        np.testing.assert_allclose(load["force"][deep].mean(), force, rtol=0.03)
        np.testing.assert_allclose(load["chip"][deep].mean(), per_tooth * 2.0 / np.pi, rtol=0.03)

    def test_off_it_changes_nothing_whatever_the_stock_resists(self):
        _, dressup = pocket()
        result = DressupDCM.recompute(dressup)
        self.assertIsNone(result.load)
        before = [c.toGCode() for c in dressup.Path.Commands]
        dressup.SpecificForce, dressup.ForceExponent, dressup.NormalForce = 5000.0, 0.1, 1.0
        DressupDCM.recompute(dressup)
        self.assertEqual([c.toGCode() for c in dressup.Path.Commands], before)
        self.assertEqual(dressup.LargestForce, 0.0)

    def check_limit(self, name, what, share):
        operation, dressup = pocket()
        DressupDCM.recompute(dressup)
        slow = DressupDCM.made(dressup).seconds
        free = patchmill.cutting_load(dressup)
        limit = share * getattr(free, what).max()
        setattr(dressup, name, limit)
        result = DressupDCM.recompute(dressup)
        kept = patchmill.cutting_load(dressup)
        print("%s: %.3g -> %.3g of %.3g, spread %.2f -> %.2f, %.1f -> %.1f s" % (
            name, getattr(free, what).max(), getattr(kept, what).max(), limit, free.spread(what),
            kept.spread(what), slow, result.seconds))
        self.assertLess(getattr(kept, what).max(), 1.1 * limit)
        self.assertLess(kept.spread(what), free.spread(what))
        self.assertGreater(result.seconds, slow)
        self.assertLess(contact_off(operation, dressup), CONTACT)
        feeds = [c.Parameters["F"] for c in dressup.Path.Commands if c.Name in ("G1", "G2", "G3")]
        self.assertLessEqual(max(feeds), HIGH * (1 + 1e-9))
        return dressup, result

    def test_the_force_is_kept(self):
        dressup, result = self.check_limit("ForceLimit", "force", 0.5)
        self.assertAlmostEqual(dressup.LargestForce, result.load.force.max())
        self.assertAlmostEqual(dressup.LargestPower, result.load.power.max())
        self.assertAlmostEqual(dressup.LargestChip, result.load.chip.max())

    def test_the_power_is_kept(self):
        dressup, _ = self.check_limit("PowerLimit", "power", 0.5)
        limits = cutting_load.limits_of(dressup)
        self.assertEqual(limits, cutting_load.Limits(math.inf, math.inf, dressup.PowerLimit))

    def test_the_chip_thickness_is_kept(self):
        self.check_limit("ChipLimit", "chip", 0.7)

    def test_the_machines_acceleration_is_kept_on_the_way(self):
        _, dressup = pocket(Machine="linuxcnc-mill", KeepPlunges=False)
        dressup.ForceLimit = 300.0  # with which a slow machine's acceleration is used
        limit = 30.0
        with mock.patch.object(dcm_input, "_limits", return_value={"acceleration": limit}):
            path = DressupDCM.recompute(dressup).path
        length = np.linalg.norm(np.diff(np.vstack([[path.start], path.tips]), axis=0), axis=1)
        speed = length * path.spindle.speed / path.turns
        timed = path.kinds[1:] * path.kinds[:-1] > 0
        change = np.abs(speed[1:] ** 2 - speed[:-1] ** 2) / (2.0 * np.fmax(length[1:], length[:-1]))
        self.assertLessEqual(change[timed & np.isfinite(change)].max(), limit * (1 + 1e-6))

    def test_bad_values_are_named(self):
        _, dressup = pocket()
        for name, bad, good in (
            ("ForceLimit", -1.0, 300.0),
            ("ForceLimit", 1e-300, 300.0),  # no feed at all
            ("PowerLimit", -1.0, 0.0),
            ("SpecificForce", 0.0, 2000.0),
            ("ForceExponent", 1.0, 0.25),
            ("NormalForce", -0.5, 0.3),
        ):
            setattr(dressup, name, bad)
            if name != "ForceLimit":
                self.assertEqual(dressup.ForceLimit, 300.0)
            with self.assertRaises(InputError) as caught:
                DressupDCM.recompute(dressup)
            self.assertEqual(caught.exception.property, name)
            setattr(dressup, name, good)
        DressupDCM.recompute(dressup)

    def test_a_tool_of_unsaid_flutes_is_named(self):
        document, job = make_job(pocket_part())
        dressup = dress(add_profile(job), ForceLimit=300.0)
        bit = host.tool_controllers(job)[0].Tool
        if getattr(bit, "Flutes", 0):
            bit.Flutes = 0
        with self.assertRaises(InputError) as caught:
            DressupDCM.recompute(dressup)
        self.assertEqual(caught.exception.property, "Flutes")
        if not hasattr(bit, "Flutes"):
            bit.addProperty("App::PropertyInteger", "Flutes")
        bit.Flutes = FLUTES  # the remedy
        self.assertGreater(DressupDCM.recompute(dressup).load.force.max(), 0.0)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)

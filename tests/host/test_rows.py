"""Rows as another order of the same dimples, and the best spindle speed, in FreeCADCmd.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import sys
import unittest
from dataclasses import replace

import numpy as np
import patchmill
from patchmill.textures.plan import plan_texture

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from test_strategies import WithMachines, locked_job  # noqa: E402


class Rows(WithMachines):
    def planned(self, **properties):
        _, self.job, operation = locked_job()
        for name, value in properties.items():
            setattr(operation, name, value)
        self.operation = operation
        return patchmill.recompute(operation)

    def test_have_the_helix_dimples_in_fewer_turns(self):
        helix = self.planned()
        rows = self.planned(Order="Rows")
        places = [
            {tuple(p) for p in np.round(plan.dimples.positions[plan.dimples.states == 0], 9)}
            for plan in (helix, rows)
        ]
        self.assertEqual(places[0], places[1])
        seconds = [plan.path.statistics()["timed_seconds"] for plan in (helix, rows)]
        self.assertLess(seconds[1], 0.8 * seconds[0])
        self.assertEqual(rows.pacing.verdict.holding, "holds")

    def test_run_along_the_direction_that_is_asked_for(self):
        for name, axis in (("Along X", 0), ("Along Y", 1)):
            with self.subTest(name):
                plan = self.planned(Order="Rows", RowDirection=name)
                steps = np.diff(plan.dimples.lattice[plan.dimples.states == 0][:, :2], axis=0)
                self.assertGreater((abs(steps[:, axis]) == 1).mean(), 0.9)
                self.assertEqual(set(abs(steps[:, 1 - axis])), {0, 1})

    def test_one_way_all_go_in_the_same_sense(self):
        plan = self.planned(Order="Rows", RowDirection="Along X", RowsOneWay=True)
        steps = np.diff(plan.dimples.lattice[plan.dimples.states == 0][:, 0])
        self.assertEqual((steps == 1).sum(), len(steps) - 11)

    def test_inside_each_patch_keep_the_patches(self):
        plan = self.planned(Order="Rows", RowExtent="Each patch")
        self.assertEqual(list(dict.fromkeys(plan.dimples.patches)), [0, 1, 2, 3])

    def test_least_time_is_not_slower_than_either_direction(self):
        found = {
            name: self.planned(Order="Rows", RowDirection=name).path.statistics()["timed_seconds"]
            for name in ("Least time", "Along X", "Along Y")
        }
        self.assertLessEqual(found["Least time"], min(found.values()) + 1e-9)

    def test_are_posted_and_read_back(self):
        self.planned(Order="Rows")
        posted = patchmill.post(self.job, self.path("x.ngc"))[0]
        self.assertTrue(posted.match.complete)

    def test_a_wrong_choice_is_refused_by_its_name(self):
        self.planned(Order="Rows")
        given = self.operation.Proxy.texture_input(self.operation)
        for name, wrong in (
            ("Order", {"order": "Spiral"}),
            ("RowExtent", {"row_extent": "Spiral"}),
            ("RowDirection", {"row_direction": "Spiral"}),
        ):
            self.assert_refused(name, plan_texture, replace(given, **wrong))


class BestSpeed(WithMachines):
    def test_is_the_least_time_of_those_that_hold(self):
        _, _, operation = locked_job()
        operation.Order = "Rows"
        patchmill.recompute(operation)
        before = operation.ToolController.SpindleSpeed
        found = patchmill.best_speed(operation, speeds=[300, 1000, 1500, 60000])
        self.assertEqual([point.rpm for point in found.curve], [300, 1000, 1500, 60000])
        self.assertFalse(found.curve[-1].holds)
        self.assertTrue(found.curve[-1].trouble)
        self.assertEqual(
            found.best.seconds, min(point.seconds for point in found.curve if point.holds)
        )
        self.assertLess(found.best.seconds, found.curve[0].seconds)
        self.assertEqual(operation.ToolController.SpindleSpeed, before)
        # it is a speed at which the operation itself holds
        operation.ToolController.SpindleSpeed = found.best.rpm
        self.assertEqual(patchmill.recompute(operation).pacing.verdict.holding, "holds")

    def test_what_the_verdict_refuses_is_not_proposed(self):
        """At 2900 rpm a tooth passes in ten servo periods, whatever the model says of the phase."""
        _, _, operation = locked_job()
        patchmill.recompute(operation)
        (point,) = patchmill.best_speed(operation, speeds=[2900]).curve
        self.assertFalse(point.holds)
        self.assertTrue(point.trouble)

    def test_orders_side_by_side(self):
        _, _, operation = locked_job()
        patchmill.recompute(operation)
        found = patchmill.best_speed(operation, speeds=[1000], orders=("Helix", "Rows"))
        helix, rows = found.curve
        self.assertEqual((helix.order, rows.order), ("Helix", "Rows"))
        self.assertEqual(found.best.order, "Rows")
        self.assertLess(rows.seconds, helix.seconds)
        operation.Order = "Rows"
        seconds = patchmill.recompute(operation).path.statistics()["timed_seconds"]
        self.assertAlmostEqual(rows.seconds, seconds, 6)
        self.assert_refused("Order", patchmill.best_speed, operation, [1000], ("Spiral",))
        self.assert_refused("ExtraTurns", patchmill.best_speed, operation, [1000], None, (5.0,))
        self.assert_refused("Feed", patchmill.best_speed, operation, [1000], None, None, (400.0,))

    def test_extra_turns_and_feed_of_polygons(self):
        _, _, operation = locked_job(strategy="Constant feed, fitted stops")
        operation.ExtraTurns = 5.0
        patchmill.recompute(operation)
        found = patchmill.best_speed(operation, speeds=[1000], extra_turns=(5.0, 6.0), feeds=(400.0, 434.413))
        self.assertEqual(
            [(point.extra_turns, point.feed) for point in found.curve],
            [(5.0, 400.0), (5.0, 434.413), (6.0, 400.0), (6.0, 434.413)],
        )
        self.assertLess(found.curve[0].turns, found.curve[2].turns)

    def test_needs_a_machine(self):
        _, _, operation = locked_job(machine="", strategy="Constant feed")
        operation.SameFlute, operation.ExtraTurns = True, 5.0
        patchmill.recompute(operation)
        self.assert_refused("Machine", patchmill.best_speed, operation)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)

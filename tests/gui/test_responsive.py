"""The event loop goes on while a large texture is previewed, planned and applied: 300 x 200 mm at 0.3 mm,
667,000 lattice points. What is asserted is that the loop's timer goes off all the while, at least once in
each tenth of the time; how long the longest pause is, `tools/bench gui` measures; load lengthens it.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import time
import unittest

import FreeCAD
import FreeCADGui
import driver
from PySide import QtCore

TENTHS = 10


class Pulse:
    """When a timer of the event loop goes off [s]."""

    def __init__(self):
        self.times = [time.monotonic()]
        self.timer = QtCore.QTimer()
        self.timer.timeout.connect(lambda: self.times.append(time.monotonic()))
        self.timer.start(5)

    def end(self):
        """In how many tenths of the time that has gone by the timer went off."""
        self.timer.stop()
        began, ended = self.times[0], time.monotonic()
        return len({int(TENTHS * (t - began) / (ended - began)) for t in self.times[1:]} - {TENTHS})


class Responsive(unittest.TestCase):
    def test_a_large_texture_never_blocks(self):
        document, part = driver.new_document(driver.wavy_block(300.0, 200.0))
        driver.select(part, driver.top_face(part.Shape))
        FreeCADGui.runCommand("PatchMill_CurvedTexture")
        operation = document.getObject("CurvedTexture")
        panel = driver.panel_of(operation)
        self.assertTrue(driver.ready(panel))
        panel.page.properties.rows["PatchSide"].editor.setValue(20)
        self.assertEqual(self.preview(panel, 0.3), TENTHS)
        planned = panel.ready.planned
        self.assertGreater(planned.counts["cut"], 600000)
        self.assign(panel, operation)
        FreeCAD.closeDocument(document.Name)

    def preview(self, panel, spacing):
        """In how many tenths of the time from a new spacing until all is shown the loop was free."""
        pulse = Pulse()
        driver.set_quantity(panel, "Spacing", spacing)
        driver.rest(0.1)
        self.assertTrue(driver.wait(lambda: panel.ready_now() and panel.scene.complete, 300))
        self.assertIsNone(panel.error)
        return pulse.end()

    def assign(self, panel, operation):
        panel.accept()
        self.assertTrue(driver.wait(lambda: not driver.panel_open(), 300))
        self.assertGreater(operation.Path.Size, 600000)


def main():
    return driver.run_tests(Responsive)

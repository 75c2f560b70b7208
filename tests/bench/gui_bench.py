"""How long the live preview, the relief's display and the longest pause of the GUI thread take, printed: a
measurement, not a test.

    tools/bench gui

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import resource
import time

import driver
import FreeCAD
import FreeCADGui
import numpy as np
import Part
from patchmill.textures.plan import place_texture
from patchmill_gui.views.texture_scene import placed_displays, relief_display
from PySide import QtCore


def gib():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20


class Pauses:
    """Longest time between two events of a timer of the event loop [ms]."""

    def __init__(self):
        self.longest, self.last = 0.0, time.monotonic()
        self.timer = QtCore.QTimer()
        self.timer.timeout.connect(self.tick)
        self.timer.start(5)

    def tick(self):
        now = time.monotonic()
        self.longest, self.last = max(self.longest, 1000.0 * (now - self.last)), now


def begun(shape):
    """(operation, its open panel) of a curved texture on a document's only part, as it is proposed."""
    _, part = driver.new_document(shape)
    return driver.begin_texture(part)


def pauses():
    """The longest pause while 667,000 lattice points on 300 x 200 mm are previewed and planned, and how long
    FreeCAD itself then takes to take the finished path over, which is not ours to move."""
    operation, panel = begun(driver.wavy_block(300.0, 200.0))
    panel.page.properties.rows["PatchSide"].editor.setValue(20)
    found = Pauses()
    driver.set_quantity(panel, "Spacing", 0.3)
    driver.rest(0.1)
    driver.wait(lambda: panel.ready_now() and panel.scene.complete, 300)
    print("longest pause of preview and planning: %.0f ms" % found.longest)
    found.timer.stop()
    began = time.monotonic()
    panel.accept()
    driver.wait(lambda: not driver.panel_open(), 300)
    took = time.monotonic() - began
    print("taking over %d commands took the host %.1f s" % (operation.Path.Size, took))
    print("most memory in use: %.1f GiB" % gib())


def previews():
    """From a changed value to dimples on the screen, around 10^5 dimples on 120 x 80 mm."""
    operation, panel = begun(driver.wavy_block(120.0, 80.0))
    for spacing in (0.31, 0.305, 0.31, 0.305):
        driver.wait(panel.ready_now)
        driver.rest(0.5)
        driver.set_quantity(panel, "Spacing", spacing)
        began = time.monotonic()
        driver.wait(lambda: panel.placing.busy)
        driver.wait(lambda: not panel.placing.busy)
        shown = time.monotonic() - began
        driver.wait(lambda: panel.scene.complete)
        whole = time.monotonic() - began
        print("dimples: first shown after %.0f ms, all after %.0f ms" % (1e3 * shown, 1e3 * whole))
    given = operation.Proxy.texture_input(operation)
    for _ in range(3):
        began = time.monotonic()
        placed = place_texture(given)
        middle = time.monotonic()
        placed_displays(placed)
        print(
            "%d lattice points: placed in %.0f ms, drawn in %.0f ms"
            % (len(placed.dimples), 1e3 * (middle - began), 1e3 * (time.monotonic() - middle))
        )
    panel.reject()
    driver.wait(lambda: not driver.panel_open())


def patch_relief():
    """From a changed value to the relief of the flattest patch on the screen, from the plan to that of the
    worst, and the longest pause of the GUI thread meanwhile, on 120 x 80 mm."""
    operation, panel = begun(driver.wavy_block(120.0, 80.0))
    for spacing in (0.6, 0.5, 0.6):
        driver.wait(lambda: panel.ready_now() and panel.scene.complete, 300)
        driver.wait(lambda: not panel.advising.assessing.busy, 300)
        panel.advising.helping.cancel()
        driver.rest(0.5)
        began, found, before = time.monotonic(), Pauses(), panel.advising.drawn
        driver.set_quantity(panel, "Spacing", spacing)
        driver.wait(lambda: panel.advising.looking.busy, 300)
        driver.wait(lambda: not panel.advising.looking.busy, 300)
        driver.wait(lambda: panel.scene.filled("relief") and panel.scene.complete, 300)
        first = time.monotonic() - began
        driver.wait(lambda: panel.advising.assessing.busy, 300)
        planned = time.monotonic()
        driver.wait(lambda: panel.advising.drawn is not before, 300)
        found.timer.stop()
        print(
            "relief of the flattest patch %.2f s after the value, of the worst %.2f s after the plan; "
            "longest pause %.0f ms" % (first, time.monotonic() - planned, found.longest)
        )
    panel.reject()
    driver.wait(lambda: not driver.panel_open())


def many_faces(holes=40):
    """A wavy block, and beside it a plate with `holes` x `holes` bores: what the tool is to keep off."""
    side = 10.0 * holes
    bores = [
        Part.makeCylinder(3.0, 20.0, FreeCAD.Vector(105.0 + 10.0 * i, 10.0 * j + 5.0, -5.0))
        for i in range(holes)
        for j in range(holes)
    ]
    plate = Part.makeBox(side, side, 5.0, FreeCAD.Vector(100.0, 0.0, 0.0)).cut(Part.makeCompound(bores))
    return Part.makeCompound([driver.wavy_block(), plate])


def of_a_part_with_many_faces():
    """The longest pause from a changed value until the texture is assessed, also against the part."""
    shape = many_faces()
    _, panel = begun(shape)
    panel.advising.following = False
    for spacing in (0.6, 0.5, 0.6):
        driver.wait(lambda: panel.ready_now() and not panel.advising.assessing.busy, 300)
        panel.advising.helping.cancel()
        driver.rest(0.5)
        found, before = Pauses(), panel.advising.drawn
        driver.set_quantity(panel, "Spacing", spacing)
        driver.wait(lambda: panel.advising.drawn is not before, 300)
        found.timer.stop()
        print("a part of %d faces: longest pause %.0f ms" % (len(shape.Faces), found.longest))
    panel.reject()
    driver.wait(lambda: not driver.panel_open())


def relief(side=3163):
    """A relief of 10^7 points: made, shown, and turned."""
    operation, panel = begun(driver.wavy_block())
    panel.accept()
    driver.wait(lambda: not driver.panel_open())
    x, y = np.meshgrid(np.linspace(0, 30, side), np.linspace(0, 20, side))
    z = 20.0 + 0.05 * np.cos(2 * np.pi * x / 0.5) * np.cos(2 * np.pi * y / 0.5)
    began = time.monotonic()
    displays, _, _ = relief_display(np.dstack([x, y, z]), 1e3 * (z - 20.0))
    made = time.monotonic() - began
    scene = operation.ViewObject.Proxy.scene
    scene.switch("relief", True)
    scene.show(displays)
    driver.wait(lambda: scene.complete, 120)
    print("%d points: made in %.1f s, on the screen after %.1f s" % (z.size, made, time.monotonic() - began))
    view = FreeCADGui.activeDocument().activeView()
    for height in (40.0, 10.0, 2.0):
        times = [_frame(view, height, k) for k in range(6)][2:]
        print("a frame of %.0f mm: %.0f ms" % (height, 1e3 * float(np.median(times))))
    print("most memory in use: %.1f GiB" % gib())


def _frame(view, height, k):
    from PySide import QtGui

    camera = view.getCameraNode()
    camera.height = height * (1.0 + 0.001 * k)
    began = time.monotonic()
    QtGui.QApplication.processEvents()
    return time.monotonic() - began


def main():
    pauses()
    previews()
    patch_relief()
    of_a_part_with_many_faces()
    relief()
    return 0

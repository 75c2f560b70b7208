"""The display of one texture in the 3-D view: dimples, milling order, patch outlines, tool path, tool axes
and relief, each a branch that can be switched. Arrays go from C++ to Coin as bytes, never as Python lists.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import time

import _patchmill as core
import numpy as np
from patchmill.textures.outlines import outlines_on_faces
from pivy import coin
from PySide import QtCore

PARTS = ("dimples", "outlines", "order", "axes", "path", "relief")
SLICE_SECONDS, PAUSE_MS = 0.02, 10
MOST_POINTS = 10**7  # of a relief


def read_nodes(chunk):
    """The Coin nodes of a chunk of a _patchmill.Display, in one separator. In the GUI's thread only."""
    source = coin.SoInput()
    source.setBuffer(chunk)
    return coin.SoDB.readAll(source)


class SceneParts:
    """Named parts of a display. `root` is to be added to a view provider's root node."""

    def __init__(self, parts):
        self.root = coin.SoSeparator()
        pick = coin.SoPickStyle()
        pick.style = coin.SoPickStyle.UNPICKABLE  # what is under the display stays selectable
        self.root.addChild(pick)
        self._switches = {}
        self._pending = []  # (part, display, number of its chunk)
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._feed)
        for part in parts:
            switch, group = coin.SoSwitch(), coin.SoSeparator()
            switch.addChild(group)
            switch.whichChild = coin.SO_SWITCH_NONE
            self.root.addChild(switch)
            self._switches[part] = (switch, group)

    def switch(self, part, on):
        self._switches[part][0].whichChild = coin.SO_SWITCH_ALL if on else coin.SO_SWITCH_NONE

    def shown(self, part):
        return self._switches[part][0].whichChild.getValue() != coin.SO_SWITCH_NONE

    def set_aside(self):
        """Takes all that is shown out of sight. Returns the function that brings it back as it was."""
        shown = [part for part in self._switches if self.shown(part)]
        for part in shown:
            self.switch(part, False)

        def bring_back():
            for part in shown:
                self.switch(part, True)

        return bring_back

    def filled(self, part):
        return self._switches[part][1].getNumChildren() > 0

    def clear(self):
        self._pending = []
        for _, group in self._switches.values():
            group.removeAllChildren()

    def empty(self, part):
        """Takes away what a part shows."""
        self._switches[part][1].removeAllChildren()
        self._pending = [job for job in self._pending if job[0] != part]

    def show(self, displays):
        """Shows displays, a dict of part: _patchmill.Display, in place of what the parts held. A first slice
        of them at once, the rest as the event loop has time."""
        for part, display in displays.items():
            self.empty(part)
            self._pending += [(part, display, number) for number in range(len(display))]
        self._feed()

    @property
    def complete(self):
        """Whether all that was to be shown is there."""
        return not self._pending

    def _feed(self):
        end = time.monotonic() + SLICE_SECONDS
        while self._pending and time.monotonic() < end:
            part, display, number = self._pending.pop(0)
            self._switches[part][1].addChild(read_nodes(display.chunk(number)))
        if self._pending:
            self._timer.start(PAUSE_MS)


class TextureScene(SceneParts):
    """The parts of a texture's display."""

    def __init__(self):
        super().__init__(PARTS)


def dimple_displays(placed):
    """The display of a PlacedTexture's dimples. For any thread."""
    return {"dimples": core.dimple_display(placed.dimples, 0.42 * placed.input.spacing)}


def line_displays(placed):
    """Displays of what goes with the dimples: outlines of patches, and the order. For any thread."""
    spacing = placed.input.spacing
    return {
        "outlines": core.outline_display(outlines_on_faces(placed)),
        "order": core.order_display(placed.dimples, spacing),
    }


def placed_displays(placed):
    """All displays of a PlacedTexture or PlannedTexture. For any thread."""
    return {**dimple_displays(placed), **line_displays(placed)}


def planned_displays(planned):
    """Displays of a PlannedTexture's path and tool axes. For any thread."""
    return {
        "path": core.path_display(planned.path),
        "axes": core.path_axis_display(planned.path, 2.0 * planned.input.tool.radius),
    }


def relief_display(points, values):
    """({"relief": Display}, low, high) of points (rows, columns, 3) [mm] coloured by values (rows, columns);
    low and high are the ends of the colour scale: all but the outermost 0.5 % at either end."""
    finite = values[np.isfinite(values)]
    low, high = np.percentile(finite, (0.5, 99.5)) if finite.size else (0.0, 1.0)
    return {"relief": core.grid_display(points, values, low, high)}, float(low), float(high)


def relief_of(result):
    """(displays, low, high in µm) of a SimulatedTexture, thinned to what a display can hold."""
    rows, columns = result.heights.shape
    stride = 1
    while (rows // stride) * (columns // stride) > MOST_POINTS:
        stride += 1
    points, heights = result.surface(stride=stride)
    return relief_display(points, 1000.0 * heights)

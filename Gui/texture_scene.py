"""The display of one texture in the 3-D view: dimples, milling order, patch outlines, tool path, tool axes
and relief, each a branch that can be switched. Arrays go from C++ to Coin without becoming Python lists.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import itertools

import _patchmill as core
import numpy as np
from pivy import coin

PARTS = ("dimples", "outlines", "order", "axes", "path", "relief")
_numbers = itertools.count(1)


class TextureScene:
    """`root` is to be added to a view provider's root node."""

    def __init__(self):
        self.root = coin.SoSeparator()
        pick = coin.SoPickStyle()
        pick.style = coin.SoPickStyle.UNPICKABLE  # what is under the display stays selectable
        self.root.addChild(pick)
        self._number = next(_numbers)
        self._switches = {}
        for part in PARTS:
            switch, group = coin.SoSwitch(), coin.SoSeparator()
            group.setName(self.name(part))
            switch.addChild(group)
            switch.whichChild = coin.SO_SWITCH_NONE
            self.root.addChild(switch)
            self._switches[part] = (switch, group)

    def name(self, part):
        """Name of the Coin group that C++ fills."""
        return "PatchMill%d_%s" % (self._number, part)

    def switch(self, part, on):
        self._switches[part][0].whichChild = coin.SO_SWITCH_ALL if on else coin.SO_SWITCH_NONE

    def shown(self, part):
        return self._switches[part][0].whichChild.getValue() != coin.SO_SWITCH_NONE

    def filled(self, part):
        return self._switches[part][1].getNumChildren() > 0

    def clear(self):
        for _, group in self._switches.values():
            group.removeAllChildren()

    def show_placed(self, placed, outlines):
        """A PlacedTexture or PlannedTexture; `outlines` as texture_plan.outlines_on_faces gives them."""
        spacing = placed.input.spacing
        core.show_dimples(self.name("dimples"), placed.dimples, 0.42 * spacing)
        core.show_order(self.name("order"), placed.dimples, spacing)
        core.show_outlines(self.name("outlines"), outlines)

    def show_planned(self, planned):
        """The path of a PlannedTexture, and its tool axes."""
        core.show_path(self.name("path"), planned.path)
        core.show_path_axes(self.name("axes"), planned.path, 2.0 * planned.input.tool.radius)

    def show_relief(self, points, values):
        """Points (rows, columns, 3) [mm] coloured by values (rows, columns); returns (low, high) of the
        colour scale: all but the outermost 0.5 % at either end."""
        finite = values[np.isfinite(values)]
        low, high = np.percentile(finite, (0.5, 99.5)) if finite.size else (0.0, 1.0)
        core.show_grid(self.name("relief"), points, values, low, high)
        return float(low), float(high)

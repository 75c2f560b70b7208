"""What is drawn while a path is played: the tool, its way over the last moves, the dimples cut so far and the
places that a check found.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import _patchmill as core
import numpy as np
from pivy import coin

from patchmill_gui.views.tool_node import ToolNode

TRAIL = 1500  # moves of the way that are drawn, the last ones
MOST_DIMPLES = 2 * 10**5  # that are drawn; of more, every second, third, ...
WAY_COLOUR, DIMPLE_COLOUR, FINDING_COLOUR = (0.90, 0.42, 0.05), (0.05, 0.35, 0.85), (0.85, 0.10, 0.10)


class PlayScene:
    """`root` is to be added to a view. Of a ToolPath: `tips` has its start before the ends of its moves."""

    def __init__(self, path, tips):
        self.tips, self.radius = tips, path.tool.radius
        self.root = coin.SoSeparator()
        pick = coin.SoPickStyle()
        pick.style = coin.SoPickStyle.UNPICKABLE
        self.root.addChild(pick)
        self.tool = ToolNode(self.radius, path.tool.flutes, path.tool.sections)
        self._way, self._way_points, self._line = coin.SoSeparator(), coin.SoCoordinate3(), coin.SoLineSet()
        _fill(self._way, WAY_COLOUR, self._way_points, self._line, line_width=2)
        self._marks, self._points = coin.SoSeparator(), coin.SoPointSet()
        self.dimple_moves = np.flatnonzero(path.dimples != core.NO_DIMPLE)
        self.dimple_moves = self.dimple_moves[:: max(1, -(-len(self.dimple_moves) // MOST_DIMPLES))]
        places = coin.SoCoordinate3()
        places.point.setValues(0, len(self.dimple_moves), tips[self.dimple_moves + 1].tolist())
        _fill(self._marks, DIMPLE_COLOUR, places, self._points, point_size=4)
        self._findings = coin.SoSeparator()
        for node in (self._way, self._marks, self._findings, self.tool.root):
            self.root.addChild(node)

    def show(self, tip, axis, angle, move):
        """The tool on its way to the end of move number `move`: at `tip` [mm], turned by `angle` [rad]."""
        self.tool.place(tip, axis, self.radius, angle)
        way = np.vstack([self.tips[max(0, move + 1 - TRAIL) : move + 1], tip])
        self._way_points.point.setNum(len(way))
        self._way_points.point.setValues(0, len(way), way.tolist())
        self._line.numVertices.setValue(len(way))
        self._points.numPoints = self.cut_before(move)

    def cut_before(self, move):
        """How many of the dimples that are drawn have been cut when a move begins."""
        return int(np.searchsorted(self.dimple_moves, move))

    def show_findings(self, findings):
        """Marks the places of Findings of a check, each by a ball as large as the tool's tenth."""
        self._findings.removeAllChildren()
        for finding in findings:
            self._findings.addChild(mark(finding.place, 0.1 * self.radius))


def mark(place, size):
    """A red ball of `size` [mm] at a place."""
    separator, move = coin.SoSeparator(), coin.SoTranslation()
    material, ball = coin.SoMaterial(), coin.SoSphere()
    move.translation.setValue(*place)
    material.diffuseColor = FINDING_COLOUR
    ball.radius = size
    for node in (move, material, ball):
        separator.addChild(node)
    return separator


def _fill(separator, colour, coordinates, shape, line_width=1, point_size=1):
    """A separator with lines or points of a colour, the same from all sides."""
    light, base, style = coin.SoLightModel(), coin.SoBaseColor(), coin.SoDrawStyle()
    light.model = coin.SoLightModel.BASE_COLOR
    base.rgb = colour
    style.lineWidth, style.pointSize = line_width, point_size
    for node in (light, base, style, coordinates, shape):
        separator.addChild(node)

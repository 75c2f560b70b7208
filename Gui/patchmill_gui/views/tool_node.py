"""The tool in the 3-D view: ball, shank and holder, with marks that show the spindle's angle.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math

from pivy import coin

FLUTE, SHANK, HOLDER = (0.55, 0.72, 0.90), (0.70, 0.73, 0.77), (0.38, 0.42, 0.47)
COLOURS = {"flute": FLUTE, "shank": SHANK, "holder": HOLDER}
EDGE = (0.88, 0.54, 0.12)


class ToolNode:
    """`root` is to be added to a view. `place` puts the tool somewhere."""

    def __init__(self, radius, flutes, sections):
        """`sections`: what is above the ball, as _patchmill.Tool.sections gives it."""
        self.root = coin.SoSeparator()
        self.pose = coin.SoTransform()
        self.spin = coin.SoRotationXYZ()
        self.spin.axis = coin.SoRotationXYZ.Z
        self.root.addChild(self.pose)
        self.root.addChild(self.spin)
        self.root.addChild(_coloured(FLUTE, _sphere(radius)))
        for part, low, high, wide, _ in sections:
            self.root.addChild(_cylinder(COLOURS[part], wide, low - radius, high - radius))
        for number in range(flutes):
            self.root.addChild(_edge(radius, 2.0 * math.pi * number / flutes))

    def place(self, tip, axis, radius, angle):
        """Tip [mm], unit axis from tip to holder, spindle angle about the axis [rad]."""
        centre = [t + radius * a for t, a in zip(tip, axis)]
        self.pose.translation.setValue(*centre)
        turn = coin.SbRotation(coin.SbVec3f(0, 0, 1), coin.SbVec3f(*(float(a) for a in axis)))
        self.pose.rotation.setValue(turn)
        self.spin.angle = angle


def _coloured(colour, node):
    separator = coin.SoSeparator()
    material = coin.SoMaterial()
    material.diffuseColor = colour
    material.specularColor = (0.4, 0.4, 0.4)
    material.transparency = 0.25
    separator.addChild(material)
    separator.addChild(node)
    return separator


def _sphere(radius):
    sphere = coin.SoSphere()
    sphere.radius = radius
    return sphere


def _cylinder(colour, radius, low, high):
    """Along z, from `low` to `high` above the ball's centre."""
    separator = coin.SoSeparator()
    move = coin.SoTranslation()
    move.translation.setValue(0, 0, 0.5 * (low + high))
    stand = coin.SoRotationXYZ()
    stand.axis = coin.SoRotationXYZ.X
    stand.angle = 0.5 * math.pi
    cylinder = coin.SoCylinder()
    cylinder.radius, cylinder.height = radius, high - low
    for node in (move, stand, cylinder):
        separator.addChild(node)
    return _coloured(colour, separator)


def _edge(radius, azimuth, steps=12):
    """A flute's edge, the meridian of the ball at `azimuth` and a line up the shank."""
    separator = coin.SoSeparator()
    light = coin.SoLightModel()
    light.model = coin.SoLightModel.BASE_COLOR
    colour = coin.SoBaseColor()
    colour.rgb = EDGE
    style = coin.SoDrawStyle()
    style.lineWidth = 3
    points = []
    for i in range(steps + 1):
        tilt = 0.5 * math.pi * i / steps  # from the tip to the equator
        reach = 1.02 * radius * math.sin(tilt)
        points.append(
            (reach * math.cos(azimuth), reach * math.sin(azimuth), -1.02 * radius * math.cos(tilt))
        )
    points.append((points[-1][0], points[-1][1], 3.0 * radius))
    coordinates, line = coin.SoCoordinate3(), coin.SoLineSet()
    coordinates.point.setValues(0, len(points), points)
    line.numVertices.setValue(len(points))
    for node in (light, colour, style, coordinates, line):
        separator.addChild(node)
    return separator

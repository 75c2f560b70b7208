"""A colour legend over the 3-D view: the scale of `_patchmill.scale_colour` with its values.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import _patchmill as core
from pivy import coin

from patchmill_gui.views.own_view import view_of

# In units of half the view's height: the bar's distance from the left, its low and high end, its width
MARGIN, LOW, HIGH, WIDTH = 0.08, -0.75, 0.15, 0.05
STEPS, LABELS = 24, 5


class Legend:
    """`root` is to be added to a view's scene graph. `title` says what and in which unit; `size` is the
    view's width and height in pixels; `labels`, 2 or more, how many values are named."""

    def __init__(self, title, low, high, digits, size, labels=LABELS):
        self.left = MARGIN - max(1.0, size[0] / size[1])
        self.root = coin.SoAnnotation()
        camera = coin.SoOrthographicCamera()
        camera.viewportMapping = coin.SoCamera.ADJUST_CAMERA
        camera.nearDistance, camera.farDistance = 0.0, 2.0
        camera.position = (0, 0, 1)
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        pick = coin.SoPickStyle()
        pick.style = coin.SoPickStyle.UNPICKABLE
        font = coin.SoFont()
        font.name, font.size = "sans", 14
        for node in (pick, camera, light, font, self._ground(), self._bar()):
            self.root.addChild(node)
        for i in range(labels):
            share = i / (labels - 1)
            text = "%.*f" % (digits, low + share * (high - low))
            self.root.addChild(_text(self.left + WIDTH + 0.03, LOW + share * (HIGH - LOW) - 0.012, text))
        self.root.addChild(_text(self.left, HIGH + 0.06, title))

    def _ground(self):
        """A dark sheet under the legend, so that its text is read over anything."""
        sheet = coin.SoSeparator()
        material, coordinates, face = coin.SoMaterial(), coin.SoCoordinate3(), coin.SoFaceSet()
        material.diffuseColor = (0.1, 0.1, 0.13)
        material.transparency = 0.35
        left, right, low, high = self.left - 0.04, self.left + 0.62, LOW - 0.06, HIGH + 0.14
        corners = [(left, low, -0.1), (right, low, -0.1), (right, high, -0.1), (left, high, -0.1)]
        coordinates.point.setValues(0, 4, corners)
        face.numVertices.setValue(4)
        for node in (material, coordinates, face):
            sheet.addChild(node)
        return sheet

    def _bar(self):
        bar = coin.SoSeparator()
        points, colours = [], []
        for i in range(STEPS + 1):
            y = LOW + (HIGH - LOW) * i / STEPS
            colour = [c / 255.0 for c in core.scale_colour(i / STEPS)]
            for x in (self.left, self.left + WIDTH):
                points.append((x, y, 0))
                colours.append(colour)
        coordinates, material = coin.SoCoordinate3(), coin.SoMaterial()
        coordinates.point.setValues(0, len(points), points)
        material.diffuseColor.setValues(0, len(colours), colours)
        binding = coin.SoMaterialBinding()
        binding.value = coin.SoMaterialBinding.PER_VERTEX
        strip = coin.SoTriangleStripSet()
        strip.numVertices.setValue(len(points))
        for node in (material, binding, coordinates, strip):
            bar.addChild(node)
        return bar


class LegendPlace:
    """Where a panel shows its legend, one at a time: over the view of the document object it is about."""

    def __init__(self, obj):
        self._obj = obj
        self._root = self._legend = None

    def show(self, title, low, high, digits=0, labels=LABELS):
        """A legend in the place of the last one; arguments as Legend's."""
        self.hide()
        view = view_of(self._obj)
        if view is None:
            return
        self._root = view.getSceneGraph()
        self._legend = Legend(title, low, high, digits, view.getSize(), labels)
        self._root.addChild(self._legend.root)

    def hide(self):
        if self._legend is not None:
            self._root.removeChild(self._legend.root)
            self._legend = None


def _text(x, y, string):
    separator = coin.SoSeparator()
    place, colour, text = coin.SoTranslation(), coin.SoBaseColor(), coin.SoText2()
    place.translation.setValue(x, y, 0)
    colour.rgb = (1, 1, 1)
    text.string = string
    for node in (place, colour, text):
        separator.addChild(node)
    return separator

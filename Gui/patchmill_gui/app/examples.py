"""The Examples menu: each entry opens a document with the part of one recipe, ready to be tried.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import runpy

import FreeCAD
import FreeCADGui
import Part
from patchmill.freecad.translate import QT_TRANSLATE_NOOP

from patchmill_gui.forms.resources import icon, path


def _matsuda(part):
    return runpy.run_path(path("recipes", "matsuda2008", "run.py"))[part]()[0]


def _kobayashi(part):
    return runpy.run_path(path("recipes", "kobayashi2014", "make_parts.py"))[part]()


# name, text, tip, shape
EXAMPLES = [
    (
        "Xu2016",
        QT_TRANSLATE_NOOP("PatchMill_Examples", "Free-form block: curved texture"),
        QT_TRANSLATE_NOOP("PatchMill_Examples", "The part of Xu and Sasahara 2016"),
        lambda: Part.read(path("recipes", "xu2016", "block.step")),
    ),
    (
        "Inclined",
        QT_TRANSLATE_NOOP("PatchMill_Examples", "Inclined plane: planar texture"),
        QT_TRANSLATE_NOOP("PatchMill_Examples", "After Matsuda, Sasahara and Tsutsumi 2008"),
        lambda: _matsuda("inclined_plane"),
    ),
    (
        "Cylinder",
        QT_TRANSLATE_NOOP("PatchMill_Examples", "Cylinder: planar patches on the surface"),
        QT_TRANSLATE_NOOP("PatchMill_Examples", "After Matsuda, Sasahara and Tsutsumi 2008"),
        lambda: _matsuda("cylinder"),
    ),
    (
        "Convex",
        QT_TRANSLATE_NOOP("PatchMill_Examples", "Smooth part: copy milling and DCM feed"),
        QT_TRANSLATE_NOOP("PatchMill_Examples", "After Kobayashi and Shirase 2014, feed"),
        lambda: _kobayashi("convex_part"),
    ),
    (
        "Overhang",
        QT_TRANSLATE_NOOP("PatchMill_Examples", "Overhanging part: DCM posture"),
        QT_TRANSLATE_NOOP("PatchMill_Examples", "After Kobayashi and Shirase 2014, posture"),
        lambda: _kobayashi("overhanging_part"),
    ),
]


class Example:
    """Command that opens one example."""

    def __init__(self, name, text, tip, shape):
        self.name, self.text, self.tip, self.shape = "PatchMill_Example" + name, text, tip, shape

    def GetResources(self):
        return {
            "Pixmap": icon("PatchMill_ExampleXu2016"),
            "MenuText": self.text,
            "ToolTip": self.tip,
        }

    def IsActive(self):
        return True

    def Activated(self, *_):
        document = FreeCAD.newDocument("Example")
        part = document.addObject("Part::Feature", "Part")
        part.Shape = self.shape()
        document.recompute()
        FreeCADGui.SendMsgToActiveView("ViewAxo")
        FreeCADGui.SendMsgToActiveView("ViewFit")


class Examples:
    """The commands above in one button with a menu."""

    def GetResources(self):
        return {
            "Pixmap": icon("PatchMill_Examples"),
            "MenuText": QT_TRANSLATE_NOOP("PatchMill_Examples", "Examples"),
            "ToolTip": QT_TRANSLATE_NOOP("PatchMill_Examples", "Parts that are ready to be tried"),
        }

    def GetCommands(self):
        return tuple(COMMANDS)

    def IsActive(self):
        return True


COMMANDS = ["PatchMill_Example" + row[0] for row in EXAMPLES]


def register():
    """Tells FreeCAD of the examples and their menu."""
    for row in EXAMPLES:
        example = Example(*row)
        FreeCADGui.addCommand(example.name, example)
    FreeCADGui.addCommand("PatchMill_Examples", Examples())

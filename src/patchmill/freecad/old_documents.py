"""Documents of FreeCAD 0.20 in 1.0 and later: they name the modules of the CAM workbench's objects as they
were called then, and FreeCAD makes nothing of them: a job without a proxy, to which no operation belongs, and
which is lost when the document is saved.

FreeCAD does the same for names that it has changed since. Init.py asks for what is found nowhere else.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from patchmill.old_names import OldNames

NEW_NAMES = {
    "PathJob": "Main.Job",
    "PathJobGui": "Main.Gui.Job",
    "PathStock": "Main.Stock",
    "PathSetupSheet": "Base.SetupSheet",
    "PathSetupSheetGui": "Base.Gui.SetupSheet",
    "PathIconViewProvider": "Base.Gui.IconViewProvider",
    "PathToolController": "Tool.Controller",
    "PathToolControllerGui": "Tool.Gui.Controller",
    "PathToolBit": "Tool.Bit",
    "PathToolBitGui": "Tool.Gui.Bit",
    "PathOp": "Op.Base",
    "PathOpGui": "Op.Gui.Base",
    "PathArray": "Op.Gui.Array",
    "PathComment": "Op.Gui.Comment",
    "PathCopy": "Op.Gui.Copy",
    "PathFixture": "Main.Gui.Fixture",
    "PathStop": "Op.Gui.Stop",
    "PathDressupAxisMap": "Dressup.Gui.AxisMap",
    "PathDressupDogbone": "Dressup.Gui.Dogbone",
    "PathDressupDragknife": "Dressup.Gui.Dragknife",
    "PathDressupHoldingTags": "Dressup.Tags",
    "PathDressupLeadInOut": "Dressup.Gui.LeadInOut",
    "PathDressupPathBoundary": "Dressup.Boundary",
    "PathDressupPathBoundaryGui": "Dressup.Gui.Boundary",
    "PathDressupRampEntry": "Dressup.Gui.RampEntry",
    "PathDressupTag": "Dressup.Tags",
    "PathDressupTagGui": "Dressup.Gui.Tags",
    "PathDressupZCorrect": "Dressup.Gui.ZCorrect",
}
_OPERATIONS = (
    "Adaptive",
    "Custom",
    "Deburr",
    "Drilling",
    "Engrave",
    "Helix",
    "MillFace",
    "Pocket",
    "PocketShape",
    "Probe",
    "Profile",
    "Slot",
    "Surface",
    "ThreadMilling",
    "Vcarve",
    "Waterline",
)
NEW_NAMES.update({"Path" + name: "Op." + name for name in _OPERATIONS})
NEW_NAMES.update({"Path%sGui" % name: "Op.Gui." + name for name in _OPERATIONS})


class OldDocuments(OldNames):
    """Finds FreeCAD 0.20's `PathScripts.PathX` under its new name."""

    def __init__(self):
        super().__init__("PathScripts", {})
        self.new_names = {"PathScripts." + o: "Path." + n for o, n in NEW_NAMES.items()}


FINDER = OldDocuments()

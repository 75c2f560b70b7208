"""The workbench's commands. Each is thin: what it does is a function of `patchmill` or a panel.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import importlib

import FreeCAD
import FreeCADGui
from FreeCAD import Qt
from _patchmill import InputError
from patchmill import host, quick_setup
from patchmill.texture_operation import ObjectTexture
from patchmill.translate import QT_TRANSLATE_NOOP
from PySide import QtGui

from patchmill_gui import tool_paths
from patchmill_gui.resources import icon


def translate(text):
    return Qt.translate("PatchMill", text)


def say(text):
    """A sentence that the user has to see."""
    QtGui.QMessageBox.information(FreeCADGui.getMainWindow(), "PatchMill", text)


def selected_faces():
    """(document object, names of its selected faces) of the first selected object that has any, or None.
    An object selected as a whole is its faces if it has one face only."""
    for selection in FreeCADGui.Selection.getSelectionEx():
        names = [name for name in selection.SubElementNames if name.startswith("Face")]
        shape = getattr(selection.Object, "Shape", None)
        if not names and not selection.SubElementNames and shape and len(shape.Faces) == 1:
            names = ["Face1"]
        if names:
            return selection.Object, names
    return None


def selected_texture():
    """The selected texture operation; the document's only one if none is selected; else None."""
    found = tool_paths.selected()
    return found if _is_texture(found) else None


def _is_texture(obj):
    return isinstance(getattr(obj, "Proxy", None), ObjectTexture)


class Command:
    """NAME, TEXT, TIP and ACCEL of a command; the icon is Resources/icons/NAME.svg."""

    NAME = TEXT = TIP = ACCEL = ""

    def GetResources(self):
        resources = {"Pixmap": icon(self.NAME), "MenuText": self.TEXT, "ToolTip": self.TIP}
        if self.ACCEL:
            resources["Accel"] = self.ACCEL
        return resources

    def IsActive(self):
        return FreeCAD.ActiveDocument is not None

    def Activated(self):
        sentence = None
        try:
            self.run()
        except InputError as error:
            sentence = str(error)
        if sentence is not None:
            say(sentence)

    def run(self):
        raise NotImplementedError


class TextureCommand(Command):
    """Makes a texture operation on the selected faces, with job and tool where missing, and edits it."""

    MODULE = OPERATION = ""

    def run(self):
        found = selected_faces()
        if found is None:
            raise InputError(
                translate("Selection"), translate("no face"), translate("select faces to texture.")
            )
        module = importlib.import_module(self.MODULE)
        # Inside a command FreeCAD lets no other transaction take the place of this one, not those of its
        # own job, tool bit and panel: all that is made is one step of undo. The last call keeps it open
        # until the panel is closed.
        FreeCAD.setActiveTransaction(self.TEXT)
        operation = quick_setup.texture(module, self.OPERATION, *found)
        FreeCADGui.Selection.clearSelection()
        operation.ViewObject.Document.setEdit(operation.ViewObject, 0)
        return operation


class PlanarTexture(TextureCommand):
    NAME, OPERATION, MODULE = "PatchMill_PlanarTexture", "PlanarTexture", "patchmill.planar_texture"
    TEXT = QT_TRANSLATE_NOOP("PatchMill_PlanarTexture", "Planar texture")
    TIP = QT_TRANSLATE_NOOP(
        "PatchMill_PlanarTexture", "Dimples in flat patches on the selected faces (Matsuda 2008)"
    )


class PyramidTexture(TextureCommand):
    NAME, OPERATION, MODULE = "PatchMill_PyramidTexture", "PyramidTexture", "patchmill.pyramid_texture"
    TEXT = QT_TRANSLATE_NOOP("PatchMill_PyramidTexture", "Pyramid texture")
    TIP = QT_TRANSLATE_NOOP(
        "PatchMill_PyramidTexture", "Dimples in faceted patches on the selected faces"
    )


class CurvedTexture(TextureCommand):
    NAME, OPERATION, MODULE = "PatchMill_CurvedTexture", "CurvedTexture", "patchmill.curved_texture"
    TEXT = QT_TRANSLATE_NOOP("PatchMill_CurvedTexture", "Curved texture")
    TIP = QT_TRANSLATE_NOOP(
        "PatchMill_CurvedTexture", "Dimples that lie on the selected faces (Xu and Sasahara 2016)"
    )


class CalibrationPatch(TextureCommand):
    NAME, OPERATION = "PatchMill_CalibrationPatch", "CalibrationPatch"
    MODULE = "patchmill.calibration_patch"
    TEXT = QT_TRANSLATE_NOOP("PatchMill_CalibrationPatch", "Calibration patch")
    TIP = QT_TRANSLATE_NOOP(
        "PatchMill_CalibrationPatch", "One patch whose best dimple tells the machine's start phase"
    )


class CopyMilling(Command):
    NAME = "PatchMill_CopyMilling"
    TEXT = QT_TRANSLATE_NOOP("PatchMill_CopyMilling", "Copy milling")
    TIP = QT_TRANSLATE_NOOP(
        "PatchMill_CopyMilling", "Lines over the selected faces or the whole part, layer by layer"
    )

    def run(self):
        found = FreeCADGui.Selection.getSelection()
        if not found:
            raise InputError(
                translate("Selection"), translate("nothing"), translate("select a part or its faces.")
            )
        part, faces = selected_faces() or (found[0], [])
        FreeCAD.setActiveTransaction(self.TEXT)  # see TextureCommand
        operation = quick_setup.copy_milling("CopyMilling", part, faces)
        FreeCADGui.Selection.clearSelection()
        operation.ViewObject.Document.setEdit(operation.ViewObject, 0)


class DressupDcm(Command):
    NAME = "PatchMill_DressupDcm"
    TEXT = QT_TRANSLATE_NOOP("PatchMill_DressupDcm", "DCM modifier")
    TIP = QT_TRANSLATE_NOOP(
        "PatchMill_DressupDcm", "Feed and tool posture of the selected operation from a voxel model"
    )

    def run(self):
        from patchmill import dressup_dcm

        found = [o for o in FreeCADGui.Selection.getSelection() if o.isDerivedFrom("Path::Feature")]
        if len(found) != 1:
            raise InputError(
                translate("Selection"),
                translate("{} operations").format(len(found)),
                translate("select one operation of a job."),
            )
        FreeCAD.setActiveTransaction(self.TEXT)
        dressup = dressup_dcm.Create("DressupDCM", found[0])
        found[0].ViewObject.Visibility = False
        FreeCADGui.Selection.clearSelection()
        dressup.ViewObject.Document.setEdit(dressup.ViewObject, 0)


class Play(Command):
    NAME = "PatchMill_Play"
    TEXT = QT_TRANSLATE_NOOP("PatchMill_Play", "Play the path")
    TIP = QT_TRANSLATE_NOOP("PatchMill_Play", "Moves the tool along a path, with its spindle turning")

    def IsActive(self):
        return tool_paths.selected() is not None and not FreeCADGui.Control.activeDialog()

    def run(self):
        from patchmill_gui.player import PlayerPanel

        operation = tool_paths.selected()
        FreeCADGui.Control.showDialog(PlayerPanel(operation, tool_paths.fresh_path(operation)))


class Simulate(Command):
    NAME = "PatchMill_Simulate"
    TEXT = QT_TRANSLATE_NOOP("PatchMill_Simulate", "Simulate marks")
    TIP = QT_TRANSLATE_NOOP("PatchMill_Simulate", "Shows the relief that the tool will leave")

    def IsActive(self):
        return selected_texture() is not None and not FreeCADGui.Control.activeDialog()

    def run(self):
        from patchmill_gui.simulate_panel import SimulatePanel

        texture = selected_texture()
        FreeCADGui.Selection.clearSelection()  # FreeCAD would tint the relief with its selection's colour
        FreeCADGui.Control.showDialog(SimulatePanel(texture))


class Check(Command):
    NAME = "PatchMill_Check"
    TEXT = QT_TRANSLATE_NOOP("PatchMill_Check", "Check")
    TIP = QT_TRANSLATE_NOOP(
        "PatchMill_Check", "Looks for gouges and collisions of ball, shank and holder with the part"
    )

    def IsActive(self):
        return selected_texture() is not None and not FreeCADGui.Control.activeDialog()

    def run(self):
        from patchmill_gui.check_panel import CheckPanel

        FreeCADGui.Control.showDialog(CheckPanel(selected_texture()))


class Report(Command):
    NAME = "PatchMill_Report"
    TEXT = QT_TRANSLATE_NOOP("PatchMill_Report", "Report")
    TIP = QT_TRANSLATE_NOOP("PatchMill_Report", "Posts the job, and writes pictures and figures")

    def IsActive(self):
        return selected_texture() is not None and not FreeCADGui.Control.activeDialog()

    def run(self):
        texture = selected_texture()
        folder = QtGui.QFileDialog.getExistingDirectory(
            FreeCADGui.getMainWindow(), translate("Folder for the report")
        )
        if folder:
            from patchmill_gui.report_panel import ReportPanel

            FreeCADGui.Control.showDialog(ReportPanel(texture, folder))


class Post(Command):
    NAME = "PatchMill_Post"
    TEXT = QT_TRANSLATE_NOOP("PatchMill_Post", "Post and check")
    TIP = QT_TRANSLATE_NOOP(
        "PatchMill_Post", "Writes the program, if what is read back from its text holds the plan"
    )

    def IsActive(self):
        return bool(FreeCAD.ActiveDocument and host.jobs())

    def run(self):
        import patchmill

        jobs = host.jobs()
        job = jobs[0] if len(jobs) == 1 else host.PathUtils.UserInput.chooseJob(jobs)
        if job is None:
            return
        name, _ = QtGui.QFileDialog.getSaveFileName(
            FreeCADGui.getMainWindow(), translate("Program"), job.Label + ".ngc", "*.ngc *.nc *.h *.mpf"
        )
        if name:
            patchmill.post(job, name)
            say(translate("{} was written, read back and holds the plan.").format(name))


TEXTURES = (PlanarTexture, PyramidTexture, CurvedTexture)
COMMANDS = TEXTURES + (
    CalibrationPatch,
    CopyMilling,
    DressupDcm,
    Play,
    Simulate,
    Check,
    Report,
    Post,
)


def register():
    """Tells FreeCAD of all commands."""
    for command in COMMANDS:
        FreeCADGui.addCommand(command.NAME, command())

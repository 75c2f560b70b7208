"""The workbench's commands. Each is thin: what it does is a function of `patchmill` or a panel.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import importlib

import FreeCAD
import FreeCADGui
from _patchmill import InputError
from patchmill.freecad import host, kinds
from patchmill.freecad.translate import QT_TRANSLATE_NOOP
from patchmill.geometry import shapes
from patchmill.operations import quick_setup
from PySide import QtGui

from patchmill_gui.app import tool_paths
from patchmill_gui.app.command_base import Command, MakingCommand, PanelCommand, selected_faces
from patchmill_gui.forms.widgets import translate


class TextureCommand(MakingCommand):
    """Makes a texture operation on the selected faces."""

    MODULE = OPERATION = ""

    def make(self):
        found = selected_faces()
        if found is None:
            _refuse_meshes()
            raise InputError(
                translate("PatchMill", "Selection"),
                translate("PatchMill", "no face"),
                translate("PatchMill", "select faces to texture."),
            )
        module = importlib.import_module(self.MODULE)
        self.begin()
        operation = quick_setup.texture(module, self.OPERATION, *found)
        operation.ViewObject.Proxy.fresh = True
        return operation


def _refuse_meshes():
    """Raises InputError naming the selection if a mesh is in it: a job's operations are made on faces."""
    for obj in FreeCADGui.Selection.getSelection():
        if shapes.is_mesh(obj):
            raise InputError(
                translate("PatchMill", "Selection"),
                translate("PatchMill", "the mesh {}").format(obj.Label),
                translate(
                    "PatchMill",
                    "it has no faces for a job. In FreeCAD's Python console patchmill.mesh_texture makes a "
                    "program for it.",
                ),
            )


class PlanarTexture(TextureCommand):
    NAME, OPERATION = "PatchMill_PlanarTexture", "PlanarTexture"
    MODULE = "patchmill.operations.planar_texture"
    TEXT = QT_TRANSLATE_NOOP("PatchMill_PlanarTexture", "Planar texture")
    TIP = QT_TRANSLATE_NOOP(
        "PatchMill_PlanarTexture", "Dimples in flat patches on the selected faces (Matsuda 2008)"
    )


class PyramidTexture(TextureCommand):
    NAME, OPERATION = "PatchMill_PyramidTexture", "PyramidTexture"
    MODULE = "patchmill.operations.pyramid_texture"
    TEXT = QT_TRANSLATE_NOOP("PatchMill_PyramidTexture", "Pyramid texture")
    TIP = QT_TRANSLATE_NOOP("PatchMill_PyramidTexture", "Dimples in faceted patches on the selected faces")


class CurvedTexture(TextureCommand):
    NAME, OPERATION = "PatchMill_CurvedTexture", "CurvedTexture"
    MODULE = "patchmill.operations.curved_texture"
    TEXT = QT_TRANSLATE_NOOP("PatchMill_CurvedTexture", "Curved texture")
    TIP = QT_TRANSLATE_NOOP(
        "PatchMill_CurvedTexture", "Dimples that lie on the selected faces (Xu and Sasahara 2016)"
    )


class CalibrationPatch(TextureCommand):
    NAME, OPERATION = "PatchMill_CalibrationPatch", "CalibrationPatch"
    MODULE = "patchmill.operations.calibration_patch"
    TEXT = QT_TRANSLATE_NOOP("PatchMill_CalibrationPatch", "Calibration patch")
    TIP = QT_TRANSLATE_NOOP(
        "PatchMill_CalibrationPatch", "One patch whose best dimple tells the machine's start phase"
    )


class CopyMilling(MakingCommand):
    NAME = "PatchMill_CopyMilling"
    TEXT = QT_TRANSLATE_NOOP("PatchMill_CopyMilling", "Copy milling")
    TIP = QT_TRANSLATE_NOOP(
        "PatchMill_CopyMilling", "Lines over the selected faces or the whole part, layer by layer"
    )

    def make(self):
        found = FreeCADGui.Selection.getSelection()
        if not found:
            raise InputError(
                translate("PatchMill", "Selection"),
                translate("PatchMill", "nothing"),
                translate("PatchMill", "select a part or its faces."),
            )
        part, faces = selected_faces() or (found[0], [])
        self.begin()
        return quick_setup.copy_milling("CopyMilling", part, faces)


class DressupDcm(MakingCommand):
    NAME = "PatchMill_DressupDcm"
    TEXT = QT_TRANSLATE_NOOP("PatchMill_DressupDcm", "DCM modifier")
    TIP = QT_TRANSLATE_NOOP(
        "PatchMill_DressupDcm", "Feed and tool posture of the selected operation from a voxel model"
    )

    def make(self):
        found = [o for o in FreeCADGui.Selection.getSelection() if o.isDerivedFrom("Path::Feature")]
        if len(found) != 1:
            raise InputError(
                translate("PatchMill", "Selection"),
                translate("PatchMill", "{} operations").format(len(found)),
                translate("PatchMill", "select one operation of a job."),
            )
        self.begin()
        dressup = quick_setup.dcm_modifier("DressupDCM", found[0])
        found[0].ViewObject.Visibility = False
        return dressup


class Play(PanelCommand):
    NAME = "PatchMill_Play"
    TEXT = QT_TRANSLATE_NOOP("PatchMill_Play", "Play the path")
    TIP = QT_TRANSLATE_NOOP("PatchMill_Play", "Moves the tool along a path, with its spindle turning")

    def target(self):
        return tool_paths.selected()

    def panel(self, operation):
        from patchmill_gui.panels.player import PlayerPanel

        return PlayerPanel(operation, tool_paths.fresh_path(operation))


class Simulate(PanelCommand):
    NAME = "PatchMill_Simulate"
    TEXT = QT_TRANSLATE_NOOP("PatchMill_Simulate", "Simulate marks")
    TIP = QT_TRANSLATE_NOOP("PatchMill_Simulate", "Shows the relief that the tool will leave")

    def target(self):
        return tool_paths.selected()

    def panel(self, operation):
        from patchmill_gui.views.milled_panel import MilledPanel
        from patchmill_gui.panels.simulate_panel import SimulatePanel

        if kinds.kind_of(operation) != kinds.TEXTURE:
            tool_paths.fresh_path(operation)
            return MilledPanel(operation)
        FreeCADGui.Selection.clearSelection()  # FreeCAD would tint the relief with its selection's colour
        return SimulatePanel(operation)


class Check(PanelCommand):
    NAME = "PatchMill_Check"
    TEXT = QT_TRANSLATE_NOOP("PatchMill_Check", "Check")
    TIP = QT_TRANSLATE_NOOP(
        "PatchMill_Check", "Looks for gouges and collisions of ball, shank and holder with the part"
    )

    def target(self):
        return tool_paths.selected()

    def panel(self, operation):
        from patchmill_gui.panels.check_panel import CheckPanel

        tool_paths.fresh_path(operation)
        return CheckPanel(operation)


class Report(PanelCommand):
    NAME = "PatchMill_Report"
    TEXT = QT_TRANSLATE_NOOP("PatchMill_Report", "Report")
    TIP = QT_TRANSLATE_NOOP("PatchMill_Report", "Posts the job, and writes pictures and figures")

    def panel(self, operation):
        from patchmill_gui.panels.report_panel import ReportPanel

        folder = QtGui.QFileDialog.getExistingDirectory(
            FreeCADGui.getMainWindow(), translate("PatchMill", "Folder for the report")
        )
        return ReportPanel(operation, folder) if folder else None


class Post(Command):
    NAME = "PatchMill_Post"
    TEXT = QT_TRANSLATE_NOOP("PatchMill_Post", "Post and check")
    TIP = QT_TRANSLATE_NOOP(
        "PatchMill_Post", "Writes the program, if what is read back from its text holds the plan"
    )

    def IsActive(self):
        return bool(FreeCAD.ActiveDocument and host.jobs())

    def run(self):
        from patchmill_gui.forms import post_dialog

        jobs = host.jobs()
        job = jobs[0] if len(jobs) == 1 else host.PathUtils.UserInput.chooseJob(jobs)
        if job is not None:
            post_dialog.show(job)


class Machines(Command):
    NAME = "PatchMill_Machines"
    TEXT = QT_TRANSLATE_NOOP("PatchMill_Machines", "Machines …")
    TIP = QT_TRANSLATE_NOOP("PatchMill_Machines", "Limits, rotary axes and controller of your machines")

    def IsActive(self):
        return True

    def run(self):
        from patchmill_gui.forms import machine_editor

        machine_editor.show()


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
    Machines,
)


def register():
    """Tells FreeCAD of all commands."""
    for command in COMMANDS:
        FreeCADGui.addCommand(command.NAME, command())

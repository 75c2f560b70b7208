"""What the workbench's commands are made of: what they find selected, and two kinds of them, those that
make an operation and those that open a panel for one.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCAD
import FreeCADGui
from _patchmill import InputError
from patchmill.operations.texture_operation import ObjectTexture
from PySide import QtGui

from patchmill_gui.app import tool_paths
from patchmill_gui.fields.sentences import error_text
from patchmill_gui.forms.resources import icon
from patchmill_gui.fields.deleted_widgets import made_for_user


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
    return found if isinstance(getattr(found, "Proxy", None), ObjectTexture) else None


class Command:
    """NAME, TEXT, TIP and ACCEL of a command; the icon is Resources/icons/NAME.svg. An InputError of `run` is
    told to the user."""

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
            sentence = error_text(error)
        if sentence is not None:
            say(sentence)

    def run(self):
        raise NotImplementedError


class MakingCommand(Command):
    """Makes an operation, with job and tool where missing, and edits it. Not while another panel is open:
    what FreeCAD takes back as it closes that one would be what this command has just made."""

    def IsActive(self):
        return super().IsActive() and not FreeCADGui.Control.activeDialog()

    def make(self):
        """The new document object. Raises InputError where the selection does not fit."""
        raise NotImplementedError

    def run(self):
        operation = self.make()
        FreeCADGui.Selection.clearSelection()
        operation.ViewObject.Document.setEdit(operation.ViewObject, 0)

    def begin(self):
        """Inside a command FreeCAD lets no other transaction take the place of this one, not those of its
        own job, tool bit and panel: all that is made is one step of undo. It stays open until the panel is
        closed."""
        FreeCAD.setActiveTransaction(self.TEXT)


class PanelCommand(Command):
    """Opens a panel for an operation, unless another panel is open."""

    def target(self):
        """The operation that is meant, by default a texture, or None."""
        return selected_texture()

    def panel(self, operation):
        """The task panel for `operation`, or None if the user thought better of it."""
        raise NotImplementedError

    def IsActive(self):
        return self.target() is not None and not FreeCADGui.Control.activeDialog()

    def run(self):
        panel = made_for_user(lambda: self.panel(self.target()))
        if panel is not None:
            FreeCADGui.Control.showDialog(panel)

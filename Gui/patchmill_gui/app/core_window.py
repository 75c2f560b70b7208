"""What the workbench is without its compiled core: one window that says what is missing, for which FreeCAD,
and installs it. No task panel: where no document is open, FreeCAD 1.1 hides those, and 26.3 shows none.
Imports nothing that needs the core or FreeCAD's Path module.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import shlex
import sys

import FreeCAD
import FreeCADGui
from patchmill.install import core_loader, wheels
from patchmill.freecad.translate import QT_TRANSLATE_NOOP
from PySide import QtCore, QtGui

from patchmill_gui.forms.widgets import translate

NAME = "PatchMill_InstallCore"


def host_words():
    """The FreeCAD that runs, as a bug report wants it."""
    version = ".".join(FreeCAD.Version()[:3]).split(" ")[0]
    return "FreeCAD %s, Python %d.%d, %s" % (version, *sys.version_info[:2], sys.platform)


class CoreWindow(QtGui.QDialog):
    """`said` is a label with what came of it."""

    def __init__(self):
        super().__init__(FreeCADGui.getMainWindow())
        self.setObjectName("PatchMillCoreWindow")
        self.setWindowTitle(translate("PatchMill", "PatchMill's compiled core"))
        layout = QtGui.QVBoxLayout(self)
        reason = core_loader.why_absent()
        text = "%s.\n\n%s" % (reason[:1].upper() + reason[1:], host_words())
        self.reason = self._label(layout, text)
        keep = translate(
            "PatchMill", "Documents with PatchMill's operations can be opened and saved; nothing is lost."
        )
        self._label(layout, keep)
        self.buttons = {}
        for name, text, action in (
            ("install", translate("PatchMill", "Install"), self.install),
            ("choose", translate("PatchMill", "Install from a wheel file …"), self.choose),
            ("copy", translate("PatchMill", "Copy the command for a terminal"), self.copy),
        ):
            button = QtGui.QPushButton(text)
            button.setAutoDefault(False)
            button.clicked.connect(action)
            layout.addWidget(button)
            self.buttons[name] = button
        self.said = self._label(layout, "")
        layout.addStretch(1)
        close = QtGui.QDialogButtonBox(QtGui.QDialogButtonBox.Close)
        close.rejected.connect(self.reject)
        layout.addWidget(close)

    @staticmethod
    def _label(layout, text):
        label = QtGui.QLabel(text)
        label.setWordWrap(True)
        label.setMinimumWidth(360)  # pixels; a sentence in three lines or so
        label.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        layout.addWidget(label)
        return label

    def install(self):
        """A wheel that lies near is taken; else pip fetches one."""
        found = wheels.at_hand()
        self._do(lambda: wheels.install(found[0]) if found else wheels.fetch())

    def choose(self):
        title = translate("PatchMill", "A wheel of PatchMill's core")
        name = QtGui.QFileDialog.getOpenFileName(self, title, "", "patchmill_core-*.whl")[0]
        if name:
            self._do(lambda: wheels.install(name))

    def copy(self):
        QtGui.QApplication.clipboard().setText(shlex.join(wheels.command()))
        self.said.setText(translate("PatchMill", "Copied. Start FreeCAD again when it has run."))

    def _do(self, work):
        QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
        try:
            work()
            reason = core_loader.reload()
        except wheels.InstallError as error:
            reason = str(error)
        finally:
            QtGui.QApplication.restoreOverrideCursor()
        if reason:
            self.said.setText(reason[:1].upper() + reason[1:])
            return
        self.said.setText(translate("PatchMill", "Installed. Start FreeCAD again to use it."))
        for button in self.buttons.values():
            button.setEnabled(False)


class InstallCore:
    """Shows the window."""

    def GetResources(self):
        icon = os.path.join(core_loader.module_root(), "Resources", "icons", "PatchMill.svg")
        text = QT_TRANSLATE_NOOP("PatchMill_InstallCore", "Install PatchMill's core …")
        tip = QT_TRANSLATE_NOOP("PatchMill_InstallCore", "What is missing here, and how to get it")
        return {"Pixmap": icon, "MenuText": text, "ToolTip": tip}

    def IsActive(self):
        return True

    def Activated(self):
        show()


_window: list = []  # the last one that was made


def show():
    """Shows the window, a new one unless one is there."""
    if not (_window and _window[0].isVisible()):
        _window[:] = [CoreWindow()]
        _window[0].show()
    _window[0].raise_()
    _window[0].activateWindow()


def start():
    """Registers the command; returns its name."""
    FreeCADGui.addCommand(NAME, InstallCore())
    return NAME


def show_if_idle():
    """Shows the window with the workbench, unless something else is being done."""
    if core_loader.why_absent() and not FreeCADGui.Control.activeDialog():
        show()

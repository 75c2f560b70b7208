# PatchMill's workbench. Runs when FreeCAD starts with a GUI; __file__ is undefined here.
# SPDX-License-Identifier: LGPL-2.1-or-later
class PatchMillWorkbench(Workbench):  # noqa: F821  FreeCAD gives it
    """Regular dimple textures with a ball end mill. Without its compiled core: what installs it."""

    MenuText = "PatchMill"
    ToolTip = "Regular dimple textures with a ball end mill"

    def __init__(self):
        import os

        from patchmill.install import core_loader

        icons = os.path.join(core_loader.module_root(), "Resources", "icons")
        self.__class__.Icon = os.path.join(icons, "PatchMill.svg")

    def Initialize(self):
        from patchmill.install import core_loader

        if core_loader.why_absent():
            from patchmill_gui.app import core_window

            commands = [core_window.start()]
            self.appendToolbar("PatchMill", commands)
            self.appendMenu("&PatchMill", commands)
            return
        from patchmill_gui.app import workbench

        workbench.start()
        self.appendToolbar("PatchMill", workbench.toolbar())
        self.appendMenu("&PatchMill", workbench.menu())

    def Activated(self):
        from patchmill.install import core_loader

        if core_loader.why_absent():
            from patchmill_gui.app import core_window
            from PySide import QtCore

            QtCore.QTimer.singleShot(0, core_window.show_if_idle)

    def GetClassName(self):
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(PatchMillWorkbench())  # noqa: F821
__import__("patchmill_gui.app.startup").app.startup.install()

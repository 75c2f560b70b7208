# PatchMill's workbench. Runs when FreeCAD starts with a GUI; __file__ is undefined here.
# SPDX-License-Identifier: LGPL-2.1-or-later
class PatchMillWorkbench(Workbench):  # noqa: F821  FreeCAD gives it
    """Regular dimple textures with a ball end mill."""

    MenuText = "PatchMill"
    ToolTip = "Regular dimple textures with a ball end mill"

    def __init__(self):
        import os

        import patchmill

        root = os.path.dirname(os.path.dirname(patchmill.__file__))
        self.__class__.Icon = os.path.join(root, "Resources", "icons", "PatchMill.svg")

    def Initialize(self):
        from patchmill_gui.app import workbench

        workbench.start()
        self.appendToolbar("PatchMill", workbench.toolbar())
        self.appendMenu("&PatchMill", workbench.menu())

    def GetClassName(self):
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(PatchMillWorkbench())  # noqa: F821
__import__("patchmill_gui.app.startup").app.startup.install()

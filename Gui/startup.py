"""What PatchMill does when FreeCAD starts, before any workbench is shown: as little as can be.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCADGui
from patchmill import hooks
from PySide import QtCore


def install():
    """View providers for what macros make, our commands in FreeCAD's CAM menu, the user's thread limit."""
    hooks.CREATED.append(attach_view)
    QtCore.QTimer.singleShot(0, add_to_native_menu)


def attach_view(obj):
    """A view provider for a document object that PatchMill made, if FreeCAD shows it at all."""
    if obj.ViewObject is None:
        return
    from patchmill_gui import workbench
    from patchmill_gui.operation_views import attach_to
    from patchmill_gui.resources import native

    workbench.start()
    if hasattr(obj, "PostProcessor"):  # a job
        obj.ViewObject.Proxy = native("job").ViewProvider(obj.ViewObject)
        obj.ViewObject.addExtension("Gui::ViewProviderGroupExtensionPython")
    else:
        attach_to(obj)


def add_to_native_menu():
    """Our commands in the CAM workbench's menu. FreeCAD 0.20 knows no way for this but the workbench's own
    methods, which work once it has been shown."""
    from patchmill import host

    done = []

    def shown(name):
        if name != host.NATIVE_WORKBENCH or done:
            return
        done.append(name)
        from patchmill_gui import workbench

        workbench.start()
        bench = FreeCADGui.getWorkbench(name)
        bench.appendMenu("PatchMill", [c for c in workbench.menu() if c.startswith("PatchMill")])
        QtCore.QTimer.singleShot(0, bench.reloadActive)

    FreeCADGui.getMainWindow().workbenchActivated.connect(shown)

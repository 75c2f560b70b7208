"""What PatchMill does when FreeCAD starts, before any workbench is shown: as little as can be.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCAD
import FreeCADGui
from patchmill.freecad import hooks
from patchmill_gui.app import native_post
from PySide import QtCore


def install():
    """View providers for what macros make, our commands in FreeCAD's CAM menu, the user's thread limit."""
    hooks.CREATED.append(attach_view)
    hooks.RESTORED.append(_attach_later)
    native_post.watch()
    QtCore.QTimer.singleShot(0, add_to_native_menu)


def _attach_later(obj):
    """FreeCAD restores the views of a document after its objects. One that was made without a GUI has none:
    then its operations, and their job, get theirs now."""
    place = (obj.Document.Name, obj.Name)
    QtCore.QTimer.singleShot(0, lambda: _attach_missing(*place))


def _attach_missing(document, name):
    from patchmill.freecad import host

    document = FreeCAD.listDocuments().get(document)
    obj = document.getObject(name) if document else None
    if obj is None:
        return
    for each in (host.PathUtils.findParentJob(obj), obj):
        # FreeCAD gives 1 where a view has no proxy
        view = each.ViewObject if each is not None else None
        if view is not None and view.Proxy in (None, 0, 1):
            attach_view(each)
            proxy = view.Proxy
            about = getattr(proxy, "Object", getattr(proxy, "obj", None))
            if about is None or getattr(proxy, "vobj", None) is None:
                proxy.attach(view)  # FreeCAD does so for the first proxy of a view only


def attach_view(obj):
    """A view provider for a document object that PatchMill made, if FreeCAD shows it at all. The prototypes
    that the job's dialog makes for its setup sheet are no document objects and have no view."""
    if getattr(obj, "ViewObject", None) is None:
        return
    from patchmill_gui.app import workbench
    from patchmill_gui.app.operation_views import attach_to
    from patchmill_gui.forms.resources import native

    workbench.start()
    if hasattr(obj, "PostProcessor"):  # a job
        obj.ViewObject.Proxy = native("job").ViewProvider(obj.ViewObject)
        obj.ViewObject.Proxy.deleteOnReject = False  # Cancel of its dialog would take away all that is in it
        obj.ViewObject.addExtension("Gui::ViewProviderGroupExtensionPython")
    else:
        attach_to(obj)


def add_to_native_menu():
    """Our commands in the CAM workbench's menu. FreeCAD 0.20 knows no way for this but the workbench's own
    methods, which work once it has been shown."""
    from patchmill.freecad import host

    done: list = []

    def shown(name):
        if name != host.NATIVE_WORKBENCH or done:
            return
        done.append(name)
        from patchmill_gui.app import workbench

        workbench.start()
        bench = FreeCADGui.getWorkbench(name)
        bench.appendMenu("PatchMill", [c for c in workbench.menu() if c.startswith("PatchMill")])
        QtCore.QTimer.singleShot(0, bench.reloadActive)

    FreeCADGui.getMainWindow().workbenchActivated.connect(shown)

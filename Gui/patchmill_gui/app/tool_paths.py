"""The ToolPath behind a document object of ours, whichever operation it is.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCAD
import FreeCADGui
from _patchmill import InputError


def path_of(obj):
    """The ToolPath of a texture, copy milling or DCM object, or None if it has none now."""
    proxy = getattr(obj, "Proxy", None)
    if getattr(proxy, "planned", None) is not None:
        return proxy.planned.path
    if getattr(proxy, "result", None) is not None:
        return proxy.result.path
    path = getattr(proxy, "path", None)
    return path if hasattr(path, "statistics") else None


def is_ours(obj):
    """Whether an object's proxy is an operation or dressup of PatchMill."""
    return type(getattr(obj, "Proxy", None)).__module__.startswith("patchmill.")


def fresh_path(obj):
    """As path_of, after a recompute if the document was just opened. Raises InputError if there is none."""
    if path_of(obj) is None:
        obj.touch()
        obj.Document.recompute()
    path = path_of(obj)
    if path is None:
        error = getattr(obj.Proxy, "error", None)
        raise error or InputError(obj.Label, "no path", "repair the operation first.")
    return path


def selected():
    """The selected object of ours; the document's only operation if nothing is selected; else None."""
    found = [o for o in FreeCADGui.Selection.getSelection() if is_ours(o)]
    if not found and FreeCAD.ActiveDocument:
        found = [o for o in FreeCAD.ActiveDocument.Objects if is_ours(o) and hasattr(o, "Path")]
    return found[0] if len(found) == 1 else None

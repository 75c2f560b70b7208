"""What operations and dressups of PatchMill have made, or why they have not.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from _patchmill import InputError

from patchmill.freecad import host
from patchmill.freecad.kinds import TEXTURE, kind_of
from patchmill.install import core_loader


def recompute(obj):
    """Recomputes one operation or dressup and returns what it made: a PlannedTexture, copy milling's
    ToolPath, or a dcm.Result. Raises InputError with the reason if there is nothing; FreeCAD itself would
    only mark the object."""
    if not hasattr(getattr(obj, "Proxy", None), "forget"):
        label = getattr(obj, "Label", repr(obj))
        raise InputError("Operation", label, "give an operation of PatchMill.")
    obj.Proxy.forget()
    obj.touch()
    obj.Document.recompute()
    return made(obj)


def made(obj):
    """What the last execute of an operation made. Raises InputError with the reason if there is nothing."""
    if obj.Proxy.error is not None:
        raise obj.Proxy.error
    result = getattr(obj.Proxy, obj.Proxy.RESULT)
    if result is None:
        raise not_computed(obj)
    return result


def planned(obj):
    """The PlannedTexture of an operation, recomputing it if the document was just opened.
    Raises InputError with the reason if there is none, or if it is no texture."""
    if kind_of(obj) != TEXTURE:
        raise InputError("Operation", getattr(obj, "Label", repr(obj)), "choose a texture operation.")
    if obj.Proxy.planned is None and obj.Proxy.error is None:
        return recompute(obj)
    return made(obj)


def not_computed(obj):
    """The InputError for an operation or dressup that has no result, though it has no error of its own."""
    if core_loader.why_absent():
        return core_loader.absent_error(core_loader.why_absent())
    if not host.is_active(obj):
        operation = obj
        while hasattr(getattr(operation, "Base", None), "Path"):  # a dressup is as active as that
            operation = operation.Base
        return InputError("Active", "false", "%s is switched off: switch it on." % operation.Label)
    for name in obj.PropertiesList:
        other = getattr(obj, name)
        error = getattr(getattr(other, "Proxy", None), "error", None)
        if error is not None and name == "Base":
            return error
        if "Invalid" in _state_of(other):
            remedy = "it has an error, so that nothing after it is computed: mend it."
            return InputError(name, other.Label, remedy)
        if name == "Base" and "Touched" in _state_of(other):  # because of what is before it
            return not_computed(other)
    controller = getattr(obj, "ToolController", None)
    if controller is not None and controller.ToolNumber == 0:
        remedy = "FreeCAD takes a tool controller of number 0 for none: give %s another." % controller.Label
        return InputError("ToolNumber", "0", remedy)
    if "Invalid" in obj.State:
        return InputError(obj.Label, "not computed", "it failed in a way that FreeCAD's report view tells.")
    return InputError(
        obj.Label, "not computed", "FreeCAD refused it: check its job, base faces and tool."
    )


def _state_of(value):
    """What FreeCAD says of a linked object; nothing for other values."""
    return value.State if hasattr(value, "TypeId") and hasattr(value, "State") else []

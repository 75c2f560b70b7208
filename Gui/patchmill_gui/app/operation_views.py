"""Which view provider an operation or dressup of ours gets.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from patchmill.modifiers.dressup_dcm import DressupDCM
from patchmill.operations.copy_milling import ObjectCopyMilling
from patchmill.operations.texture_operation import ObjectTexture

from patchmill_gui.forms.resources import icon, native
from patchmill_gui.panels import copy_panel, dcm_panel, texture_view
from patchmill_gui.panels.texture_panel import TexturePage


def attach_to(obj):
    """Gives a document object of ours its view provider, if it has none."""
    vobj, proxy = obj.ViewObject, obj.Proxy
    ours = (texture_view.ViewProvider, copy_panel.CopyView, dcm_panel.DcmView)
    if vobj is None or isinstance(vobj.Proxy, ours):
        return
    if isinstance(proxy, ObjectTexture):
        texture_view.ViewProvider(vobj, _resources(proxy, TexturePage))
    elif isinstance(proxy, ObjectCopyMilling):
        copy_panel.CopyView(vobj, _resources(proxy, copy_panel.CopyPage))
    elif isinstance(proxy, DressupDCM):
        dcm_panel.DcmView(vobj)


def _resources(proxy, page):
    """FreeCAD's CommandResources for an operation's proxy: what its own view provider is made from."""
    name = type(proxy).__name__.replace("Object", "", 1)
    return native("operation").CommandResources(
        name, None, page, icon("PatchMill_" + name), name, None, name
    )

"""New widgets that PySide takes for deleted ones: how they are known, and made again.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import gc
import sys
import traceback

from PySide import QtCore


def forget_closed_panels():
    """To be called before a panel is made. PySide gives a new widget the Python object of one that had its
    address, even of one that is deleted, as long as anything refers to that; what is left of closed panels
    refers to itself in circles, until Python collects it; and the traceback of an error that Python keeps
    refers to all that was at work then."""
    traceback.clear_frames(getattr(sys, "last_traceback", None))
    gc.collect()


def require_alive(widget):
    """Raises a RuntimeError if PySide takes a widget, or a part of it, for a deleted one, maybe of another
    class: also one that an attribute of `widget` names, as FreeCAD's forms do with all their parts."""
    named = [part for part in vars(widget).values() if isinstance(part, QtCore.QObject)]
    for each in [widget, *named, *widget.findChildren(QtCore.QObject)]:
        try:
            names = _class_names(each.metaObject())
        except AttributeError:  # the class itself is taken for a deleted widget
            names = []
        if type(each).__name__ not in names:
            raise RuntimeError("%r: taken for one that is %s" % (each, DELETED))


def _class_names(meta):
    """Of a QMetaObject's class and of all that it is derived from."""
    names = []
    while meta is not None:
        names.append(meta.className())
        meta = meta.superClass()
    return names


def living(make):
    """A widget by `make()` that Python can use, with its parts. Where forget_closed_panels() is not enough,
    PySide takes the new widget for the deleted one of its address: that address is then left taken, and
    another widget is made."""
    for _ in range(MOST_TAKEN):
        widget = make()
        try:
            require_alive(widget)
        except RuntimeError:
            _taken.append(widget)
            continue
        return widget
    raise RuntimeError("PySide takes each of %d new widgets for a deleted one" % MOST_TAKEN)


def made_alive(make):
    """What `make()` returns, made again where it fails for a widget that PySide takes for a deleted one, as
    in FreeCAD's own pages: what was made until then is kept, so that its addresses are left taken."""
    for _ in range(MOST_TAKEN):
        try:
            return make()
        except RuntimeError as error:
            if DELETED not in str(error):
                raise
            _taken.append(error)  # with the frames of its traceback, and all that they made
    return make()


def made_for_user(make):
    """A panel or window by `make()`, which begins anew where PySide takes a widget of it for a deleted one:
    every panel and window that is not FreeCAD's own is made by this."""
    forget_closed_panels()
    return made_alive(make)


DELETED = "already deleted"  # PySide's words
MOST_TAKEN = 50
_taken: list = []

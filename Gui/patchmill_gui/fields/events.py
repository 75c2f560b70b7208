"""What Python asks where PySide may take an event or a widget for a deleted one of its address, whose Python
object is still there; and how widgets are found so that theirs do not stay.

FreeCAD's main window, its docks and its task panel last as long as the program. PySide keeps the Python
objects of what `findChildren` and `parentWidget` give, also of widgets that are deleted, as long as that of
the parent: below() and around() are for what is in a lasting one.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from functools import partial

from PySide import QtCore, QtGui

from patchmill_gui.fields.deleted_widgets import DELETED


def kind_of(event):
    """Type of a QEvent; None where PySide takes it for a widget that FreeCAD deleted at its address, whose
    Python object is still there."""
    return event.type() if isinstance(event, QtCore.QEvent) else None


def unless_deleted(ask, otherwise):
    """What `ask()` gives; `otherwise` where a widget that it asks is taken for a deleted one."""
    try:
        return ask()
    except RuntimeError as gone:
        if DELETED not in str(gone):
            raise
        return otherwise


def below(holder, kinds):
    """The widgets of a class, or of one of a tuple of classes, that are in `holder`, in no order."""
    return [each for each in _all(kinds) if is_in(each, holder)]


def around(widget, kinds):
    """The widgets of a class, or of one of a tuple of classes, that hold `widget`, from without inwards."""
    found = [each for each in _all(kinds) if is_in(widget, each)]
    return sorted(found, key=lambda each: sum(is_in(each, other) for other in found))


def is_in(widget, holder):
    """Whether a widget is part of another one, in the same window; of itself it is none."""
    return widget is not holder and unless_deleted(partial(holder.isAncestorOf, widget), False)


def _all(kinds):
    return [each for each in QtGui.QApplication.allWidgets() if isinstance(each, kinds)]

"""What the task panels share that have no OK: a form with a Close button, and work in the background whose
progress, result or error it shows.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from patchmill_gui.fields.object_watch import ObjectWatch
from patchmill_gui.fields.sentences import error_text
from patchmill_gui.forms.resources import icon
from patchmill_gui.forms.widgets import ERROR_COLOUR, ProgressBar, WrappingLabel, button_number, noticed
from patchmill_gui.work.background import Background
from patchmill_gui.work.room import make_room_soon


class ClosePanel:
    """Task panel with a Close button, about the document object `operation`, with which it closes. `form` is
    what FreeCAD shows; a subclass names its ICON, fills `layout`, and takes back in `leave` what only the
    panel showed in the view, without its widgets, which may be gone by then."""

    ICON = "PatchMill"

    def __init__(self, title, operation):
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(title)
        self.form.setWindowIcon(QtGui.QIcon(icon(self.ICON)))
        self.layout = QtGui.QVBoxLayout(self.form)
        self.opened = self.ended = False
        self.form.destroyed.connect(self._end)  # FreeCAD asks nothing where something else is edited
        self.watch = ObjectWatch(operation, self._gone)
        FreeCAD.addDocumentObserver(self.watch)

    def getStandardButtons(self):
        """FreeCAD asks when it shows the panel."""
        self.opened = True
        make_room_soon()
        return button_number(QtGui.QDialogButtonBox.Close)

    def leave(self):
        """Called when the panel closes."""

    def reject(self):
        self._end()
        FreeCADGui.Control.closeDialog()
        return True

    def _end(self, *_):
        if not self.ended:
            self.ended = True
            FreeCAD.removeDocumentObserver(self.watch)
            self.leave()

    def _gone(self):
        """The object is being deleted, maybe with its document: the panel goes when that is done."""
        self._end()
        if self._is_open():
            QtCore.QTimer.singleShot(0, lambda: self._is_open() and FreeCADGui.Control.closeDialog())

    def _is_open(self):
        """Whether FreeCAD shows it, be it behind another tab: it takes the form away when it closes it."""
        return self.opened and self.form is not None

    def accept(self):
        return self.reject()


class WorkPanel(ClosePanel):
    """With `work`, a Background, whose result comes to the subclass's `show_result(result)` and whose error
    is shown in `text`. What is still running when the panel closes is given up."""

    def __init__(self, title, operation):
        super().__init__(title, operation)
        self.result = self.error = None
        self.bar, self.text = ProgressBar(), WrappingLabel()
        self.text.setSizePolicy(QtGui.QSizePolicy.Ignored, QtGui.QSizePolicy.Preferred)
        self.work = Background()
        self.work.finished.connect(self.show_result)
        self.work.failed.connect(self.show_error)
        self.work.progressed.connect(self.bar.show_share)

    def add_progress(self):
        """Bar and text at the end of the layout."""
        self.layout.addWidget(self.bar)
        self.layout.addWidget(self.text)
        self.layout.addStretch()

    def show_result(self, result):
        raise NotImplementedError

    def show_error(self, error):
        self.error = error
        self.bar.hide()
        self.text.setText(noticed(error_text(error), ERROR_COLOUR))

    def leave(self):
        self.work.cancel()

"""What the task panels share that have no OK: a form with a Close button, and work in the background whose
progress, result or error it shows.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCADGui

from PySide import QtGui

from patchmill_gui.forms.widgets import ERROR_COLOUR, ProgressBar, button_number, noticed, wrapping_label
from patchmill_gui.work.background import Background


class ClosePanel:
    """Task panel with a Close button. `form` is what FreeCAD shows; a subclass fills `layout`, and takes back
    in `leave` what only the panel showed in the view."""

    def __init__(self, title):
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(title)
        self.layout = QtGui.QVBoxLayout(self.form)

    def getStandardButtons(self):
        return button_number(QtGui.QDialogButtonBox.Close)

    def leave(self):
        """Called when the panel closes."""

    def reject(self):
        self.leave()
        FreeCADGui.Control.closeDialog()
        return True

    def accept(self):
        return self.reject()


class WorkPanel(ClosePanel):
    """With `work`, a Background, whose result comes to the subclass's `show_result(result)` and whose error
    is shown in `text`. What is still running when the panel closes is given up."""

    def __init__(self, title):
        super().__init__(title)
        self.result = self.error = None
        self.bar, self.text = ProgressBar(), wrapping_label()
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
        self.text.setText(noticed(str(error), ERROR_COLOUR))

    def leave(self):
        self.work.cancel()

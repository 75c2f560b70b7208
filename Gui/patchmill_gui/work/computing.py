"""What panels share that compute in the background when the user says OK or Preview: a box with progress and
messages, and an OK that closes the panel only when the result is there.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import typing

import FreeCAD
from _patchmill import InputError
from PySide import QtCore, QtGui

from patchmill_gui.forms.widgets import Notice, ProgressBar, WrappingLabel, translate
from patchmill_gui.work.background import Background


class ComputingBox(QtGui.QGroupBox):
    """Preview button, progress bar with the time left, what was found, and what is wrong."""

    def __init__(self):
        super().__init__(translate("PatchMill", "Result"))
        layout = QtGui.QVBoxLayout(self)
        self.button = QtGui.QPushButton(translate("PatchMill", "Preview"))
        self.button.setObjectName("Preview")
        self.bar, self.text, self.message = ProgressBar(), WrappingLabel(), Notice()
        self.text.setSizePolicy(QtGui.QSizePolicy.Ignored, QtGui.QSizePolicy.Preferred)
        for widget in (self.button, self.bar, self.text, self.message):
            layout.addWidget(widget)


class Computing:
    """Mixin. The panel has `box` (a ComputingBox), `form_rows` (a PropertyForm) and gives
    `gather()`: in the GUI thread, the function of (progress) that computes; may raise InputError;
    `show_result(result)`: displays it; `finish(result)`: puts it in the document and closes."""

    box: ComputingBox
    form_rows: typing.Any
    gather: typing.Callable
    show_result: typing.Callable
    finish: typing.Callable

    def start_computing(self):
        self.result = self.error = None
        self.closing = False
        self.work = Background()
        self.work.finished.connect(self._computed)
        self.work.failed.connect(self._failed)
        self.work.progressed.connect(self.box.bar.show_share)
        self.box.button.clicked.connect(lambda: self.compute(False))
        self.form_rows.changed.connect(self._outdate)

    def _outdate(self):
        self.result = None

    def compute(self, closing):
        """Computes what the properties ask for, unless it is there; then closes if `closing`."""
        if self.work.busy and not closing:
            self.cancel()
            return
        self.closing = closing
        if self.result is not None:
            self._computed(self.result)
            return
        self._show_error(None)
        try:
            work = self.gather()
        except InputError as error:
            self._failed(error)
            return
        self.box.button.setText(translate("PatchMill", "Cancel"))
        self.box.bar.begin(known=False)
        self.work.start(work)

    def cancel(self):
        """Stops what is running; returns whether anything was."""
        busy = self.work.busy
        self.give_up()
        self._idle()
        return busy

    def give_up(self):
        """The same of a panel that closes, whose widgets may be deleted."""
        self.closing = False
        self.work.cancel()

    def stop_waiting(self):
        """What Cancel does first: stops the work. Returns whether OK was waiting for it, so that this is all
        that Cancel means."""
        waiting = self.closing
        return self.cancel() and waiting

    def _idle(self):
        self.box.button.setText(translate("PatchMill", "Preview"))
        self.box.bar.hide()

    def _computed(self, result):
        self._idle()
        self.result = result
        self.show_result(result)
        if self.closing:
            QtCore.QTimer.singleShot(0, lambda: self.finish(result))

    def _failed(self, error):
        self._idle()
        self.closing = False
        if not isinstance(error, InputError):
            FreeCAD.Console.PrintError("PatchMill: %r\n" % error)
        self._show_error(error)

    def _show_error(self, error):
        self.error = error
        self.box.message.setText(self.form_rows.show_error(error))

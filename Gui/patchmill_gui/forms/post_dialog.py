"""Window that posts a job: machine, post-processor, work offset, what the plan says, time and file. *Post*
writes the program and shows what was read back from its text.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os

import FreeCAD
import FreeCADGui
import patchmill
from _patchmill import InputError
from patchmill.freecad import preferences
from patchmill.machine.machining_time import in_words
from patchmill.posting import proposal
from PySide import QtCore, QtGui

from patchmill_gui.fields.known_sentences import translated_error
from patchmill_gui.fields.object_watch import ObjectWatch
from patchmill_gui.fields.deleted_widgets import made_for_user
from patchmill_gui.forms.widgets import (
    ERROR_COLOUR,
    GOOD_COLOUR,
    busy_cursor,
    guard_editors,
    plain_label,
    translate,
)

OFFSETS = ["G54", "G55", "G56", "G57", "G58", "G59"]


def show(job):
    """Shows the window for a job; returns it. Raises InputError if an operation cannot be planned."""
    with busy_cursor():
        proposed = proposal.of(job)
        window = made_for_user(lambda: PostDialog(job, proposed))
    window.show()
    window.raise_()
    window.activateWindow()
    return window


class PostDialog(QtGui.QDialog):
    """`proposed`: a proposal.Proposal for the document object `job`."""

    def __init__(self, job, proposed):
        super().__init__(FreeCADGui.getMainWindow())
        self.setObjectName("PostDialog")
        self.setWindowTitle(translate("PatchMill", "Post and check {}").format(job.Label))
        self.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        self.job, self.proposed = job, proposed
        self.posted = None
        self._build()
        guard_editors(self)
        self.watch = ObjectWatch(job, self._gone)
        FreeCAD.addDocumentObserver(self.watch)
        self.watched = True
        self.finished.connect(self._unwatch)

    def _gone(self):
        """The job is being deleted, by an undo maybe, or its document is closed: the window goes when that is
        done."""
        self._unwatch()
        QtCore.QTimer.singleShot(0, self.reject)

    def _unwatch(self, *_):
        if self.watched:
            self.watched = False
            FreeCAD.removeDocumentObserver(self.watch)

    def _build(self):
        layout = QtGui.QVBoxLayout(self)
        rows = QtGui.QFormLayout()
        rows.addRow(translate("PatchMill", "Machine"), plain_label(self._machine()))
        self.post = QtGui.QComboBox()
        self.post.addItems(self._posts())
        self.post.setCurrentText(self.proposed.post)
        self.offset = QtGui.QComboBox()
        own = ", ".join(self.job.Fixtures)
        self.offset.addItems([own] + [name for name in OFFSETS if name != own])
        rows.addRow(translate("PatchMill", "Post-&processor"), self.post)
        rows.addRow(translate("PatchMill", "&Work offset"), self.offset)
        rows.addRow(translate("PatchMill", "Phase"), plain_label(self._verdict()))
        rows.addRow(translate("PatchMill", "Time"), plain_label(self._time()))
        label, row = QtGui.QLabel(translate("PatchMill", "&File")), self._file_row()
        label.setBuddy(self.file)
        rows.addRow(label, row)
        layout.addLayout(rows)
        self.message = plain_label()
        self.message.setMinimumWidth(420)
        layout.addWidget(self.message)
        self.buttons = QtGui.QDialogButtonBox()
        self.ok = self.buttons.addButton(translate("PatchMill", "Post"), QtGui.QDialogButtonBox.AcceptRole)
        self.buttons.addButton(QtGui.QDialogButtonBox.Close)
        self.buttons.accepted.connect(self.write)
        self.buttons.rejected.connect(self.reject)
        layout.addWidget(self.buttons)

    def _posts(self):
        known = self.job.getEnumerationsOfProperty("PostProcessor") or []
        return sorted({self.proposed.post, self.job.PostProcessor, *known} - {""})

    def _machine(self):
        machine = self.proposed.machine
        if machine is None:
            return translate("PatchMill", "none is named")
        return "%s (%s)" % (machine.data["name"], machine.key)

    def _verdict(self):
        verdicts = [plan.pacing.verdict for plan in self.proposed.plans]
        said = [
            translate("PatchMill", "not judged: no machine is named") if v is None else v.sentence
            for v in verdicts
        ]
        return "\n".join(said) or translate("PatchMill", "no texture")

    def _time(self):
        seconds = self.proposed.seconds
        if not seconds:
            return "-"
        return translate("PatchMill", "{} for PatchMill's operations").format(in_words(seconds))

    def _file_row(self):
        row = QtGui.QHBoxLayout()
        self.file = QtGui.QLineEdit(self.proposed.filename)
        self.file.setMinimumWidth(260)
        more = QtGui.QToolButton()
        more.setText("…")
        more.setToolTip(translate("PatchMill", "Choose the program's file"))
        more.clicked.connect(self._ask)
        row.addWidget(self.file)
        row.addWidget(more)
        return row

    def _ask(self):
        name, _ = QtGui.QFileDialog.getSaveFileName(
            self, translate("PatchMill", "Program"), self.file.text(), "*.ngc *.nc *.h *.mpf"
        )
        if name:
            self.file.setText(name)

    def write(self):
        """Posts. What is chosen is kept by the job, in one step of undo. A job that was taken back meanwhile
        is left alone: the next step of undo would destroy it while it is changed."""
        if not self.watch.is_there():
            return self.reject()
        name, document = self.file.text().strip(), self.job.Document
        document.openTransaction(translate("PatchMill", "Post"))
        try:
            with busy_cursor():  # FreeCAD's post-processors work in the GUI thread
                self._keep()
                self.posted = patchmill.post(self.job, name, self.post.currentText(), self.proposed.arguments)
        except InputError as error:
            document.abortTransaction()
            return self._say(translated_error(error), ERROR_COLOUR)
        document.commitTransaction()
        preferences.remember(ProgramFolder=os.path.dirname(os.path.abspath(name)))
        self._say(what_was_written(name, self.posted), GOOD_COLOUR)

    def _keep(self):
        post = self.post.currentText()
        if self.offset.currentIndex() > 0:
            self.job.Fixtures = [self.offset.currentText()]
        if post in (self.job.getEnumerationsOfProperty("PostProcessor") or []):
            self.job.PostProcessor = post
        self.job.PostProcessorArgs = self.proposed.arguments

    def _say(self, text, colour):
        self.message.setStyleSheet("color: white; background: %s; padding: 4px; border-radius: 3px" % colour)
        self.message.setText(text)
        self.adjustSize()


def what_was_written(name, posted):
    """A sentence about what patchmill.post returned."""
    unread = ["%s: %s" % (one.operation.Label, one.unknown) for one in posted if getattr(one, "unknown", "")]
    if unread:
        return translate("PatchMill", "{} was written. Not compared with the path: {}.").format(
            name, "; ".join(unread)
        )
    return translate("PatchMill", "{} was written, read back and holds the plan.").format(name)

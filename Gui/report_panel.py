"""Panel that writes the report of a texture: posts the job, which FreeCAD does in the GUI thread, and then
simulates, draws and writes in the background.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os

import FreeCADGui
import patchmill
from _patchmill import InputError
from FreeCAD import Qt
from patchmill import host
from patchmill.texture_operation import planned
from PySide import QtCore, QtGui

from patchmill_gui.background import Background


def translate(text):
    return Qt.translate("PatchMill", text)


def report_work(operation, folder):
    """Posts the operation's job into `folder`; returns the function of (progress) that writes the report and
    gives the names of all files, or None if it was stopped. Raises InputError."""
    plan = planned(operation)
    job = host.PathUtils.findParentJob(operation)
    gcode = os.path.join(folder, operation.Name + ".ngc")
    (posted,) = [p for p in patchmill.post(job, gcode) if p.operation is operation]

    def work(progress):
        simulated = patchmill.simulate(plan, path=posted.path, progress=progress)
        if simulated is None:
            return None
        return [gcode] + patchmill.write_report(posted, plan, gcode, folder, simulated)

    return work


class ReportPanel:
    """Task panel; starts at once."""

    def __init__(self, operation, folder):
        self.files = self.error = None
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(translate("Report"))
        layout = QtGui.QVBoxLayout(self.form)
        self.bar, self.text = QtGui.QProgressBar(), QtGui.QLabel(translate("Posting …"))
        self.bar.setRange(0, 1000)
        self.text.setWordWrap(True)
        self.text.setSizePolicy(QtGui.QSizePolicy.Ignored, QtGui.QSizePolicy.Preferred)
        self.text.setOpenExternalLinks(True)
        layout.addWidget(self.bar)
        layout.addWidget(self.text)
        layout.addStretch()
        self.work = Background()
        self.work.finished.connect(self._finished)
        self.work.failed.connect(self._failed)
        self.work.progressed.connect(self._progressed)
        try:
            work = report_work(operation, folder)
        except InputError as error:
            self._failed(error)
        else:
            self.text.setText(translate("Simulating and drawing …"))
            self.work.start(work)

    def _progressed(self, share, seconds):
        self.bar.setValue(int(1000 * share))
        self.bar.setFormat(translate("%p % · {:.0f} s left").format(seconds))

    def _finished(self, files):
        self.files = files
        self.bar.hide()
        (page,) = [name for name in files if name.endswith(".html")]
        url = QtCore.QUrl.fromLocalFile(page).toString()
        link = '<a href="%s">%s</a>' % (url, translate("Open the report"))
        rest = "<br>".join(os.path.basename(name) for name in files)
        self.text.setText("%s<br>%s" % (link, rest))

    def _failed(self, error):
        self.error = error
        self.bar.hide()
        self.text.setText('<span style="color:#c0392b">%s</span>' % error)

    def getStandardButtons(self):
        return int(QtGui.QDialogButtonBox.Close)

    def reject(self):
        """Closes; what is still being written is given up."""
        self.work.cancel()
        FreeCADGui.Control.closeDialog()
        return True

    accept = reject

"""Panel that checks a texture's path for gouges and collisions, and shows where the worst is.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCADGui
from FreeCAD import Qt
from pivy import coin
from PySide import QtGui

from patchmill import checks
from patchmill_gui.background import Background

MARKS = 200  # findings that are shown in the view


def translate(text):
    return Qt.translate("PatchMill", text)


class CheckPanel:
    """Task panel for a texture operation; the check starts at once."""

    def __init__(self, operation):
        self.result = self.error = None
        self.root = FreeCADGui.ActiveDocument.ActiveView.getSceneGraph()
        self.marks = coin.SoSeparator()
        self.root.addChild(self.marks)
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(translate("Check {}").format(operation.Label))
        layout = QtGui.QVBoxLayout(self.form)
        self.bar, self.text = QtGui.QProgressBar(), QtGui.QLabel(translate("Checking …"))
        self.bar.setRange(0, 1000)
        self.text.setWordWrap(True)
        self.text.setSizePolicy(QtGui.QSizePolicy.Ignored, QtGui.QSizePolicy.Preferred)
        layout.addWidget(self.bar)
        layout.addWidget(self.text)
        layout.addStretch()
        self.work = Background()
        self.work.finished.connect(self._finished)
        self.work.failed.connect(self._failed)
        self.work.progressed.connect(lambda share, left: self.bar.setValue(int(1000 * share)))
        given = checks.check_input(operation)
        self.work.start(lambda progress: checks.run_check(given, progress=progress))

    def _finished(self, result):
        self.result = result
        self.bar.setValue(1000)
        colour = {checks.CLEAR: "#2e7d32", checks.UNKNOWN: "#b26a00"}.get(result.outcome, "#c0392b")
        self.text.setText('<b style="color:%s">%s</b>' % (colour, result.sentence))
        for finding in sorted(result.findings, key=lambda f: -f.depth)[:MARKS]:
            self.marks.addChild(_mark(finding.place, 0.5 if finding is not result.worst else 1.0))

    def _failed(self, error):
        self.error = error
        self.bar.hide()
        self.text.setText('<span style="color:#c0392b">%s</span>' % error)

    def getStandardButtons(self):
        return int(QtGui.QDialogButtonBox.Close)

    def reject(self):
        self.work.cancel()
        self.root.removeChild(self.marks)
        FreeCADGui.Control.closeDialog()
        return True

    accept = reject


def _mark(place, size):
    separator = coin.SoSeparator()
    move, material, ball = coin.SoTranslation(), coin.SoMaterial(), coin.SoSphere()
    move.translation.setValue(*place)
    material.diffuseColor = (0.85, 0.1, 0.1)
    ball.radius = size
    for node in (move, material, ball):
        separator.addChild(node)
    return separator

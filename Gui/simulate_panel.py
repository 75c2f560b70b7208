"""Panel that simulates the marks of a texture and shows the relief on the part, with a legend and a table.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCADGui
import patchmill
from FreeCAD import Qt
from _patchmill import InputError
from patchmill import machines
from patchmill.texture_operation import planned
from PySide import QtCore, QtGui

from patchmill_gui.background import Background
from patchmill_gui.legend import Legend
from patchmill_gui.property_form import let_shrink
from patchmill_gui.texture_scene import relief_display
from patchmill_gui.texture_view import RELIEF

MOST_POINTS = 10**7


def translate(text):
    return Qt.translate("PatchMill", text)


def relief_of(result):
    """(displays, low, high in µm) of a SimulatedTexture, thinned to what a display can hold."""
    rows, columns = result.heights.shape
    stride = 1
    while (rows // stride) * (columns // stride) > MOST_POINTS:
        stride += 1
    points, heights = result.surface(stride=stride)
    return relief_display(points, 1000.0 * heights)


class SimulatePanel:
    """Task panel for a texture operation."""

    def __init__(self, operation):
        self.operation = operation
        self.plan = planned(operation)
        self.scene = operation.ViewObject.Proxy.scene
        self.result = self.error = self.legend = None
        self.work = Background()
        self.work.finished.connect(self._finished)
        self.work.failed.connect(self._failed)
        self.work.progressed.connect(self._progressed)
        self.form = self._form()

    def _form(self):
        form = QtGui.QWidget()
        form.setWindowTitle(translate("Simulate marks"))
        layout = QtGui.QVBoxLayout(form)
        rows = QtGui.QFormLayout()
        self.size = QtGui.QDoubleSpinBox()
        self.size.setRange(0.0, 1e4)
        self.size.setSuffix(" mm")
        self.size.setSpecialValueText(translate("whole texture"))
        self.size.setValue(round(20.0 * self.plan.input.spacing, 2))
        self.size.setObjectName("WindowSize")
        self.machine = QtGui.QComboBox()
        self.machine.addItem(translate("as planned"), None)
        for name in machines.names():
            self.machine.addItem(translate("as {} would run it").format(name), name)
        self.runout = QtGui.QDoubleSpinBox()
        self.runout.setSuffix(" µm")
        self.runout.setToolTip(translate("How far the first flute stands out"))
        rows.addRow(translate("Window"), self.size)
        rows.addRow(translate("Motion"), self.machine)
        rows.addRow(translate("Runout"), self.runout)
        for editor in (self.size, self.machine, self.runout):
            let_shrink(editor)
        layout.addLayout(rows)
        self.button = QtGui.QPushButton(translate("Simulate"))
        self.button.setObjectName("Simulate")
        self.button.clicked.connect(self.simulate)
        self.bar = QtGui.QProgressBar()
        self.bar.setRange(0, 1000)
        self.bar.hide()
        self.text = QtGui.QLabel()
        self.text.setWordWrap(True)
        self.text.setTextFormat(QtCore.Qt.RichText)
        self.text.setSizePolicy(QtGui.QSizePolicy.Ignored, QtGui.QSizePolicy.Preferred)
        for widget in (self.button, self.bar, self.text):
            layout.addWidget(widget)
        layout.addStretch()
        return form

    def window(self):
        """((x, y) least, (x, y) greatest) around the milled dimple nearest to the middle; None for all."""
        size = self.size.value()
        if size == 0.0:
            return None
        places = self.plan.places()[self.plan.dimples.states == 0]
        middle = 0.5 * (places.min(axis=0) + places.max(axis=0))
        centre = places[((places - middle) ** 2).sum(axis=1).argmin()]
        return tuple(centre - 0.5 * size), tuple(centre + 0.5 * size)

    def simulate(self):
        """Starts, or stops what is running."""
        if self.work.busy:
            self.work.cancel()
            self._idle()
            return
        window, machine = self.window(), self.machine.currentData()
        runout = [1e-3 * self.runout.value()] + [0.0] * (self.plan.input.tool.flutes - 1)
        plan = self.plan

        def run(progress):
            result = patchmill.simulate(
                plan, machine=machine, window=window, runout=runout, progress=progress
            )
            return result and (result, relief_of(result))

        self.button.setText(translate("Cancel"))
        self.text.clear()
        self.bar.setValue(0)
        self.bar.show()
        self.work.start(run)

    def _idle(self):
        self.button.setText(translate("Simulate"))
        self.bar.hide()

    def _progressed(self, share, seconds):
        self.bar.setValue(int(1000 * share))
        self.bar.setFormat(translate("%p % · {:.0f} s left").format(seconds))

    def _failed(self, error):
        self._idle()
        self.error = error
        self.text.setText('<span style="color:#c0392b">%s</span>' % error)
        if not isinstance(error, InputError):
            raise error

    def _finished(self, made):
        self._idle()
        if made is None:
            return
        self.result, (displays, low, high) = made
        self.scene.show(displays)
        self.operation.ViewObject.Show = RELIEF
        self._show_legend(low, high)
        cells = "".join(
            "<tr><td>%s </td><td><b>%s</b></td></tr>" % row for row in self.result.rows()
        )
        self.text.setText("<table>%s</table>" % cells)

    def _show_legend(self, low, high):
        self._hide_legend()
        view = FreeCADGui.ActiveDocument.ActiveView
        title = translate("height over the faces [µm]")
        self.legend = Legend(title, low, high, 0, view.getSize())
        view.getSceneGraph().addChild(self.legend.root)

    def _hide_legend(self):
        if self.legend is not None:
            FreeCADGui.ActiveDocument.ActiveView.getSceneGraph().removeChild(self.legend.root)
            self.legend = None

    def getStandardButtons(self):
        return int(QtGui.QDialogButtonBox.Close)

    def reject(self):
        """Closes; the relief stays displayed."""
        self.work.cancel()
        self._hide_legend()
        FreeCADGui.Control.closeDialog()
        return True

    accept = reject

"""Panel that simulates the marks of a texture and shows the relief on the part, with a legend and a table.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCADGui
import patchmill
from _patchmill import DimpleState, InputError
from patchmill.operations.texture_operation import planned
from PySide import QtCore, QtGui

from patchmill_gui.fields import unit_text
from patchmill_gui.fields.number_box import NumberBox
from patchmill_gui.forms.choice_rows import MachineBox
from patchmill_gui.forms.texture_summary import table_of
from patchmill_gui.forms.widgets import busy_cursor, guard_editors, let_shrink, translate
from patchmill_gui.views.legend import LegendPlace
from patchmill_gui.views.texture_scene import relief_of
from patchmill_gui.work.work_panel import WorkPanel


class SimulatePanel(WorkPanel):
    """Task panel for a texture operation. The relief stays displayed when it closes."""

    ICON = "PatchMill_Simulate"

    def __init__(self, operation):
        super().__init__(translate("PatchMill", "Simulate marks"), operation)
        self.operation = operation
        self.plan = planned(operation)
        self.scene = operation.ViewObject.Proxy.scene
        self.legend = LegendPlace(operation)
        self.layout.addLayout(self._rows())
        self.button = QtGui.QPushButton(translate("PatchMill", "Simulate"))
        self.button.setObjectName("Simulate")
        self.button.clicked.connect(self.simulate)
        self.layout.addWidget(self.button)
        self.saving = QtGui.QPushButton(translate("PatchMill", "Save relief …"))
        self.saving.setObjectName("SaveRelief")
        self.saving.setToolTip(translate("PatchMill", "As a height map or a mesh, or the dimples as a table"))
        self.saving.setEnabled(False)
        self.saving.clicked.connect(self.save)
        self.layout.addWidget(self.saving)
        self.text.setTextFormat(QtCore.Qt.RichText)
        self.add_progress()

    def _rows(self):
        rows = QtGui.QFormLayout()
        self.size = NumberBox()
        unit, self.millimetres = unit_text.user_unit("mm")
        self.size.setRange(0.0, 1e4)
        self.size.setDecimals(2 if unit == "mm" else 4)
        self.size.setSuffix(" " + unit)
        self.size.setSpecialValueText(translate("PatchMill", "whole texture"))
        self.size.setValue(round(20.0 * self.plan.input.spacing / self.millimetres, self.size.decimals()))
        self.size.setObjectName("WindowSize")
        self.machine = MachineBox(
            (translate("PatchMill", "as planned"), None), translate("PatchMill", "as {} would run it").format
        )
        self.runout = NumberBox()
        unit, self.micrometres, decimals = unit_text.of_micrometre()
        self.runout.setDecimals(decimals)
        self.runout.setSuffix(" " + unit)
        self.runout.setToolTip(translate("PatchMill", "How far the first flute stands out"))
        rows.addRow(translate("PatchMill", "Window"), self.size)
        rows.addRow(translate("PatchMill", "Motion"), self.machine)
        rows.addRow(translate("PatchMill", "Runout"), self.runout)
        for editor in (self.size, self.machine, self.runout):
            let_shrink(editor)
            guard_editors(editor)
        return rows

    def window(self):
        """((x, y) least, (x, y) greatest) around the milled dimple nearest to the middle; None for all."""
        size = self.size.value() * self.millimetres
        if size == 0.0:
            return None
        places = self.plan.places()[self.plan.dimples.states == DimpleState.CUT]
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
        runout = [1e-3 * self.micrometres * self.runout.value()] + [0.0] * (self.plan.input.tool.flutes - 1)
        plan = self.plan

        def run(progress):
            result = patchmill.simulate(
                plan, machine=machine, window=window, runout=runout, progress=progress
            )
            return result and (result, relief_of(result))

        self.button.setText(translate("PatchMill", "Cancel"))
        self.saving.setEnabled(False)
        self.text.clear()
        self.bar.begin()
        self.work.start(run)

    def _idle(self):
        self.button.setText(translate("PatchMill", "Simulate"))
        self.bar.hide()

    def show_error(self, error):
        self._idle()
        super().show_error(error)
        if not isinstance(error, InputError):
            raise error

    def show_result(self, made):
        self._idle()
        if made is None:
            return
        self.result, (displays, low, high) = made
        self.operation.ViewObject.Proxy.show_simulated(displays)
        unit, *scale = unit_text.of_micrometres(low, high)
        self.legend.show(translate("PatchMill", "height over the faces [{}]").format(unit), *scale)
        self.text.setText(table_of(self.result.rows()))
        self.saving.setEnabled(True)

    def save(self):
        """Asks for a file and writes the relief shown last, or its table of dimples."""
        kinds = (
            translate("PatchMill", "Height map") + " (*.x3p *.sdf *.gsf *.tif *.exr *.csv *.vti)",
            translate("PatchMill", "Mesh") + " (*.stl *.ply)",
            translate("PatchMill", "Table of dimples") + " (*.dimples.csv)",
        )
        name, _ = QtGui.QFileDialog.getSaveFileName(
            FreeCADGui.getMainWindow(),
            translate("PatchMill", "Relief"),
            self.operation.Label + ".x3p",
            ";;".join(kinds),
        )
        if not name:
            return
        try:
            with busy_cursor():
                self.result.save(name)
        except InputError as error:
            self.show_error(error)

    def leave(self):
        super().leave()
        self.legend.hide()

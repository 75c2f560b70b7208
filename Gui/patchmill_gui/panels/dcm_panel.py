"""Task panel and view of DressupDCM: the voxel model's feed or posture in a slice, posture as arrows.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import _patchmill as core
import FreeCAD
import FreeCADGui
from patchmill.freecad import preferences
from patchmill.machine.machining_time import in_words
from patchmill.modifiers import cutting_load, dcm, dcm_input, dressup_dcm
from patchmill.voxels import removal_model, voxel_slices
from PySide import QtCore, QtGui

from patchmill_gui.forms.idle_properties import idle_dcm_properties
from patchmill_gui.forms.property_form import PropertyForm
from patchmill_gui.forms.property_rows import QuantityRow
from patchmill_gui.forms.resources import icon
from patchmill_gui.forms.texture_summary import grouped
from patchmill_gui.fields.deleted_widgets import made_for_user
from patchmill_gui.forms.widgets import button_number, guard_editors, let_shrink, translate
from patchmill_gui.views.dcm_colours import LOADS, load_on_path, load_text, slice_of
from patchmill_gui.views.legend import LegendPlace
from patchmill_gui.views.path_view import PathScene, settle_native_lines
from patchmill_gui.work.computing import Computing, ComputingBox
from patchmill_gui.work.room import make_room_soon

AXES = ("X", "Y", "Z")
ARROWS_PER_AXIS = 24  # about so many along the longest side
SLIDER_STEPS = 200
BUTTONS = 42  # pixels in a number's editor, with FreeCAD's mark of an expression


class DcmPanel(Computing):
    """Task panel. `self.form` is what FreeCAD shows."""

    def __init__(self, obj):
        self.obj = obj
        self.view = obj.ViewObject.Proxy  # kept: Cancel may take the object away
        self.scene = self.view.scene
        self.view_document = obj.ViewObject.Document
        self.legend = LegendPlace(obj)
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(translate("PatchMill", "DCM modifier"))
        self.form.setWindowIcon(QtGui.QIcon(icon("PatchMill_DressupDcm")))
        layout = QtGui.QVBoxLayout(self.form)
        self.form_rows = PropertyForm(dressup_dcm.PROPERTIES, obj, closed=("Load", "Limits"))
        for row in self.form_rows.rows.values():
            if isinstance(row, QuantityRow):  # a number that is cut off is another number
                text = row.editor.fontMetrics().boundingRect("000.00 mm/s").width()
                row.editor.setMinimumWidth(text + BUTTONS)
        self.form_rows.show()
        self.form_rows.changed.connect(self._store)
        for group in self.form_rows.groups.values():
            layout.addWidget(group)
        self.box = ComputingBox()
        layout.addWidget(self.box)
        layout.addWidget(self._slice_box())
        layout.addStretch()
        self.start_computing()
        self._store()

    def _store(self):
        """Editors to properties; those that mean something now are shown."""
        self.form_rows.store()
        self.form_rows.show_only(set(self.form_rows.rows) - idle_dcm_properties(self.obj))

    def _slice_box(self):
        box = QtGui.QGroupBox(translate("PatchMill", "Slice through the voxels"))
        rows = QtGui.QFormLayout(box)
        self.axis, self.what = QtGui.QComboBox(), QtGui.QComboBox()
        self.axis.addItems([translate("PatchMill", "across {}").format(a) for a in AXES])
        self.axis.setCurrentIndex(1)
        for key, name in (
            ("feed", translate("PatchMill", "Feed")),
            ("tilt", translate("PatchMill", "Posture")),
            ("distance", translate("PatchMill", "Distance to the product")),
            ("material", translate("PatchMill", "Material")),
            ("force", translate("PatchMill", "Force along the path")),
            ("power", translate("PatchMill", "Power along the path")),
            ("chip", translate("PatchMill", "Chip thickness along the path")),
            ("none", translate("PatchMill", "None")),
        ):
            self.what.addItem(name, key)
        self.what.setObjectName("SliceOf")
        self.place = QtGui.QSlider(QtCore.Qt.Horizontal)
        self.place.setRange(0, SLIDER_STEPS)
        self.place.setValue(SLIDER_STEPS // 2)
        self.arrows = QtGui.QCheckBox(translate("PatchMill", "Posture as arrows"))
        for editor in (self.axis, self.what):
            let_shrink(editor)
            guard_editors(editor)
            editor.currentIndexChanged.connect(lambda _: self.show_slice())
        self.place.valueChanged.connect(lambda _: self.show_slice())
        self.arrows.toggled.connect(lambda _: self.show_arrows())
        rows.addRow(translate("PatchMill", "Colour"), self.what)
        rows.addRow(translate("PatchMill", "Slice"), self.axis)
        rows.addRow(translate("PatchMill", "At"), self.place)
        rows.addRow(self.arrows)
        return box

    def gather(self):
        self.form_rows.store()
        given = dcm.input_of(self.obj)
        file = removal_model.file_beside(self.obj.Document, self.obj.Name)
        stock = self._resistance() if self.what.currentData() in LOADS else None

        def work(progress):
            made = dressup_dcm.compute(given, file, progress)
            if made is None:
                return None
            model, result = made
            feed = model.feed(given.low, given.high)
            load = result.load
            if load is None and stock:
                load = cutting_load.along(result.path, model.grid, stock)
            return model, result, feed, core.path_display(result.path), (given.low, given.high), load

        return work

    def _resistance(self):
        """Of the stock, for the load of a path that has no limits of it. Raises InputError."""
        dcm_input.require_known_load(self.obj, self.obj.ToolController)
        return cutting_load.resistance_of(self.obj)

    def show_result(self, result):
        _, made, _, display, _, load = result
        self.scene.show(display)
        said = translate("PatchMill", "{} moves, {} of milling instead of {}").format(
            grouped(made.steps["moves"]), in_words(made.seconds), in_words(made.base_seconds)
        )
        self.box.text.setText(said if load is None else said + "\n" + load_text(load))
        self.show_slice()
        self.show_arrows()

    def show_slice(self):
        """The coloured voxels of the slice that is chosen, from the last result."""
        if self.result is None:
            return
        model, _, feed, _, limits, load = self.result
        axis, what = self.axis.currentIndex(), self.what.currentData()
        if what in LOADS:
            self._show_load(what, load, model.grid.pitch)
            return
        shown = what != "none" and (what != "tilt" or model.posture is not None)
        self.scene.parts.switch("slice", shown)
        self.legend.hide()
        if not shown:
            return
        least, most = voxel_slices.slice_range(model, axis)
        place = least + (most - least) * self.place.value() / SLIDER_STEPS
        legend, (centres, values) = slice_of(what, model, feed, limits, axis, place)
        low, high = legend[1:3]
        display = core.slice_display(centres, list(values), model.grid.pitch, axis, low, high)
        self.scene.parts.show({"slice": display})
        self.legend.show(*legend)

    def _show_load(self, what, load, pitch):
        """Coloured squares along the path, from above. What was not computed is computed now."""
        if load is None:
            self.result = None
            self.compute(False)
            return
        legend, display = load_on_path(what, load, pitch)
        self.scene.parts.show({"slice": display})
        self.scene.parts.switch("slice", True)
        self.legend.show(*legend)

    def show_arrows(self):
        on = self.arrows.isChecked() and self.result is not None
        on = on and self.result[0].posture is not None
        self.scene.parts.switch("arrows", on)
        if not on:
            return
        model = self.result[0]
        longest = max(model.stock.bounds[1] - model.stock.bounds[0])
        stride = max(1, int(round(longest / model.grid.pitch / ARROWS_PER_AXIS)))
        places, axes = model.grid.arrows(model.posture, stride)
        tilt = voxel_slices.tilt_of(axes)
        size = 0.9 * stride * model.grid.pitch
        display = core.arrow_display(places, axes, size, list(tilt), 0.0, 90.0)
        self.scene.parts.show({"arrows": display})

    def getStandardButtons(self):
        make_room_soon()
        return button_number(QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Cancel)

    def accept(self):
        self.compute(True)
        return False  # finish closes the dialog

    def finish(self, result):
        preferences.remember_machine(self.obj.Machine)
        self.obj.Proxy.ready = result[:2]
        self.obj.touch()
        self.obj.Document.recompute()
        self.obj.Document.commitTransaction()
        self._close()

    def reject(self):
        if self.stop_waiting():
            return False
        document = self.obj.Document  # which need not be the one in front
        document.abortTransaction()
        self._close()
        document.recompute()
        return True

    def leave(self):
        """Gives up what runs for the panel, and what only the panel showed; its widgets may be gone."""
        self.work.cancel()
        self.legend.hide()
        for part in ("slice", "arrows"):
            self.scene.parts.switch(part, False)

    def _close(self):
        self.view.panel = None
        self.leave()
        FreeCADGui.Control.closeDialog()
        self.view_document.resetEdit()


class DcmView:
    """View provider of a DressupDCM."""

    __module__ = "patchmill_gui.dcm_panel"  # what documents save

    panel = None  # while it is open

    def __init__(self, vobj):
        self.scene = None
        vobj.Proxy = self

    def attach(self, vobj):
        self.vobj, self.obj = vobj, vobj.Object
        self.scene = PathScene(vobj)
        settle_native_lines(vobj.Object)

    def claimChildren(self):
        return [self.obj.Base] if self.obj.Base else []

    def getIcon(self):
        return icon("PatchMill_DressupDcm")

    def onChanged(self, vobj, prop):
        if prop == "Visibility" and self.scene:
            self.scene.switch(vobj.Visibility)

    def updateData(self, obj, prop):
        if prop == "Path" and self.scene:
            result = getattr(obj.Proxy, "result", None)
            self.scene.follow(result.path if result else None)
            settle_native_lines(obj)

    def setEdit(self, vobj, mode=0):
        if mode != 0:
            return False
        if not FreeCAD.getActiveTransaction():
            vobj.Object.Document.openTransaction("DCM")
        FreeCADGui.Control.closeDialog()
        self.panel = made_for_user(lambda: DcmPanel(vobj.Object))
        FreeCADGui.Control.showDialog(self.panel)
        return True

    def unsetEdit(self, vobj, mode=0):
        """Something else is edited, or the object goes in an undo."""
        panel, self.panel = self.panel, None
        if panel is not None:
            panel.leave()
        return False

    def onDelete(self, vobj, names=None):
        return vobj.Object.Proxy.onDelete(vobj.Object, names)

    def dumps(self):
        return None

    def loads(self, state):
        self.scene = None

    __getstate__, __setstate__ = dumps, loads

"""Task panel of the texture operations: FreeCAD's pages for base geometry and heights, and a page of ours
with a picture of the quantities, a form of the properties and a live preview.

Nothing is computed in the GUI thread. While values change, the dimples are placed in the background and
shown; when they stay, the whole texture is planned there, so that OK finds it ready.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import _patchmill as core
import FreeCAD
from _patchmill import InputError
from patchmill.freecad import preferences
from patchmill.freecad.translate import QT_TRANSLATE_NOOP
from patchmill.operations.texture_operation import prepare
from patchmill.textures.plan import place_texture
from PySide import QtCore, QtGui

from patchmill_gui.forms.advanced_fold import AdvancedFold
from patchmill_gui.forms.advisor_box import AdvisorBox
from patchmill_gui.forms.idle_properties import idle_properties
from patchmill_gui.forms.resources import path
from patchmill_gui.forms.texture_summary import placed_summary, planned_summary
from patchmill_gui.forms.widgets import Notice, ProgressBar, WrappingLabel, one_shot, translate
from patchmill_gui.panels.operation_base import OperationPage, OperationPanel
from patchmill_gui.panels.texture_advising import Advising
from patchmill_gui.views.best_speed_box import BestSpeedBox
from patchmill_gui.views.texture_scene import dimple_displays, line_displays
from patchmill_gui.work.background import Background

PICTURE_WIDTH = 220  # as narrow as FreeCAD's panel at first
PLACE_AFTER_MS, PLAN_AFTER_MS = 0, 400
MAIN = QT_TRANSLATE_NOOP("PatchMill", "Pattern")
MAIN_ROWS = ("PatchShape", "Spacing", "Depth", "Margin", "MaskUse", "Machine", "ToolAxisMode", "Strategy")
PREVIEWS = (
    ("dimples", QT_TRANSLATE_NOOP("PatchMill", "Dimples")),
    ("outlines", QT_TRANSLATE_NOOP("PatchMill", "Patches")),
    ("order", QT_TRANSLATE_NOOP("PatchMill", "Order")),
    ("axes", QT_TRANSLATE_NOOP("PatchMill", "Tool axes")),
    ("relief", QT_TRANSLATE_NOOP("PatchMill", "Relief")),
)


def main_first(table):
    """The rows of a table of properties with those of MAIN_ROWS in front, in a group of their own."""
    rows = {row[1]: row for row in table}
    main = [(kind, name, MAIN, tip, default) for kind, name, _, tip, default in map(rows.get, MAIN_ROWS)]
    return main + [row for row in table if row[1] not in MAIN_ROWS]


class TexturePage(OperationPage):
    """The operation's own page."""

    __module__ = "patchmill_gui.texture_panel"  # what documents save

    def getForm(self):
        form, layout = self.begin_form(
            main_first(self.obj.Proxy.properties()), closed=("Limits", "Mask", "Phase", "Tool axis", "Checks")
        )
        layout.addWidget(self.properties.groups[MAIN])
        layout.addWidget(self._preview_box())
        self.advice = AdvisorBox(self.obj, self.advised) if hasattr(self.obj, "Form") else None
        if self.advice is not None:
            layout.addWidget(self.advice)
        layout.addWidget(BestSpeedBox(self.obj, self.advised))
        self.advanced = AdvancedFold(self.properties, (MAIN,))
        picture = QtGui.QLabel()
        picture.setPixmap(QtGui.QIcon(path("icons", "quantities.svg")).pixmap(PICTURE_WIDTH, PICTURE_WIDTH))
        picture.setMinimumWidth(1)
        picture.setAlignment(QtCore.Qt.AlignCenter)
        self.advanced.rows.insertRow(0, picture)
        layout.addWidget(self.advanced)
        layout.addStretch()
        return form

    def advised(self):
        """A proposal was taken over into the properties."""
        self.properties.show()
        self.properties.changed.emit()

    def _preview_box(self):
        box = QtGui.QGroupBox(translate("PatchMill", "Preview"))
        layout = QtGui.QVBoxLayout(box)
        grid = QtGui.QGridLayout()
        self.previews = {}
        for place, (part, text) in enumerate(PREVIEWS):
            check = QtGui.QCheckBox(translate("PatchMill", text))
            check.setObjectName("Preview" + part.capitalize())
            check.setChecked(part in ("dimples", "outlines", "relief"))
            grid.addWidget(check, place // 2, place % 2)
            self.previews[part] = check
        layout.addLayout(grid)
        self.summary = WrappingLabel()
        self.summary.setTextFormat(QtCore.Qt.RichText)
        layout.addWidget(self.summary)
        self.message = Notice()
        layout.addWidget(self.message)
        self.progress = ProgressBar()
        layout.addWidget(self.progress)
        return box

    def getFields(self, obj):
        advising = self.parent.advising
        before = advising.own_values()
        super().getFields(obj)
        if advising.own_values() != before:
            advising.following = False
        if advising.follow_strategy(before[0]):
            self.properties.show()
        self._show_rows()

    def setFields(self, obj):
        super().setFields(obj)
        self._show_rows()

    def _show_rows(self):
        """Only the properties that mean something with the others as they are."""
        self.properties.show_only(set(self.properties.rows) - idle_properties(self.obj))
        if self.advice is not None:
            self.advice.setVisible(self.obj.Form == "Free")

    def show_error(self, error):
        """The sentence of an InputError at its field; elsewhere, or of another property, in the box."""
        self.message.setText(self.properties.show_error(error))


class TexturePanel(OperationPanel):
    """FreeCAD's panel with preview; OK waits for the plan and blocks nothing. `error`: is shown, or None."""

    def __init__(self, obj, delete_on_reject, page, selection):
        super().__init__(obj, delete_on_reject, page, selection)
        self.page, self.view = page, obj.ViewObject.Proxy
        self.scene = self.view.scene
        self.placing, self.drawing, self.planning = Background(brief=True), Background(), Background()
        self.placing.finished.connect(self._placed)
        self.placing.failed.connect(self._failed)
        self.drawing.finished.connect(self.scene.show)
        self.planning.finished.connect(self._planned)
        self.planning.failed.connect(self._failed)
        self.planning.progressed.connect(page.progress.show_share)
        self.advising = Advising(obj, page.advised)
        self.advising.chosen.connect(self._chosen)
        self.advising.relief.connect(self.scene.show)
        self.error, self.ready, self.accepting = None, None, False
        self.place_timer, self.plan_timer = one_shot(self._place), one_shot(self._plan)

    def setupUi(self):
        super().setupUi()
        for part, check in self.page.previews.items():
            check.toggled.connect(lambda on, name=part: self.scene.switch(name, on))
            self.scene.switch(part, check.isChecked())
        self.view.editing = True
        self.view.update(self.obj.ViewObject)
        if not self.advising.head.pin(self.page.form):
            self.page.form.layout().insertWidget(0, self.advising.head)
        if self.view.fresh and not self.obj.Proxy.CALIBRATING:
            self.advising.follow()
        self.view.fresh = False
        self.preview()

    def _chosen(self):
        """The values are chosen."""
        self._plan() if self.accepting else self.preview()

    def pageDirtyChanged(self, page):
        super().pageDirtyChanged(page)
        if page is not None and page.isdirty and hasattr(self, "place_timer"):
            self.accepting = self.accepting and self.advising.applying
            self.preview()
            self.place_timer.stop()  # at once, before what waits is painted
            self._place()

    def preview(self):
        """Shows the texture as the properties are now, soon; Apply needs no more: OK takes this plan."""
        self.planning.cancel()
        self.page.progress.setVisible(False)
        self.advising.outdate()
        self.place_timer.start(PLACE_AFTER_MS)
        self.plan_timer.start(PLAN_AFTER_MS)

    def _input(self):
        """TextureInput of the operation, or None with the reason shown."""
        try:
            self.obj.Proxy.refresh_heights(self.obj)
            return self.obj.Proxy.texture_input(self.obj)
        except InputError as error:
            self._failed(error)
            return None

    def _place(self):
        given = self._input()
        if given is not None:
            self.placing.start(lambda progress: _placed_and_drawn(given, progress))

    def _placed(self, result):
        if result is None:
            return
        placed, displays, summary = result
        self.error = None
        self.page.show_error(None)
        self.scene.empty("relief")  # of the values before, as the dimples were until now
        self.scene.show(displays)
        self.drawing.start(lambda progress: line_displays(placed))
        self.advising.look(placed)
        self.page.summary.setText(summary)

    def _plan(self):
        if self.advising.choosing.busy or self.advising.choose():
            return  # _chosen goes on
        given = self._input()
        if given is None:
            self.accepting = False
            return
        if self.ready is not None and self.ready.planned.asked == given:
            self._planned(self.ready)
        else:
            self.planning.start(lambda progress: _prepared_and_drawn(given, progress))

    def _planned(self, ready):
        self.page.progress.setVisible(False)
        if ready is None:
            return
        self.ready = ready
        self.scene.show({"axes": ready.axes})
        self.page.summary.setText(ready.summary)
        if self.accepting:
            QtCore.QTimer.singleShot(0, self._finish)
        else:
            self.advising.assess(ready.planned)

    def _failed(self, error):
        self.accepting = False
        self.page.progress.setVisible(False)
        if not isinstance(error, InputError):
            FreeCAD.Console.PrintError("PatchMill: %r\n" % error)
        self.error = error
        self.scene.empty("relief")
        self.page.show_error(error)
        if not self.advising.choosing.busy:
            self.advising.explain(error)

    def ready_now(self):
        """Whether everything is planned for the properties as they are."""
        waits = self.place_timer.isActive() or self.plan_timer.isActive() or self.advising.choosing.busy
        return not (waits or self.busy())

    def busy(self):
        return self.placing.busy or self.drawing.busy or self.planning.busy

    def accept(self, resetEdit=True):
        """OK: closes the panel as soon as the plan is ready; at once if it is."""
        self.panelGetFields()
        self.place_timer.stop()
        self.plan_timer.stop()
        self.accepting = True
        self._plan()
        return False  # _finish closes the dialog

    def _finish(self):
        if self.left:
            return
        self.stop()
        preferences.remember_machine(self.obj.Machine)
        self.view.known_relief = self.advising.drawn
        self.close_with(self.ready)

    def reject(self, resetEdit=True):
        """Cancel: of the planning that OK waits for, if it does; else of the panel, with all that was made
        since the command or the edit began."""
        if self.accepting and (self.planning.busy or self.advising.choosing.busy):
            self.accepting = False
            self.planning.cancel()
            self.page.progress.setVisible(False)
            return False
        self.stop()
        return super().reject(resetEdit)

    def stop(self):
        self.place_timer.stop()
        self.plan_timer.stop()
        for work in (self.placing, self.drawing, self.planning):
            work.cancel()
        self.advising.stop()
        self.view.editing = False
        self.scene.clear()
        self.view.update_soon(self.obj)


def _placed_and_drawn(given, progress):
    placed = place_texture(given, progress)
    return placed and (placed, dimple_displays(placed), placed_summary(placed))


def _prepared_and_drawn(given, progress):
    ready = prepare(given, progress)
    if ready is not None:
        ready.summary = planned_summary(ready.planned)
        ready.axes = core.path_axis_display(ready.planned.path, 2.0 * given.tool.radius)
    return ready

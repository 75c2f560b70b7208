"""What the views, panels and their pages of our operations share, over FreeCAD's own.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import typing
import weakref

import FreeCAD
import FreeCADGui
from patchmill.freecad import host
from PySide import QtCore, QtGui

from patchmill_gui.forms.property_form import PropertyForm
from patchmill_gui.forms.resources import native
from patchmill_gui.fields.deleted_widgets import forget_closed_panels, made_alive, require_alive
from patchmill_gui.forms.widgets import guard_editors, let_shrink, translate
from patchmill_gui.work.room import make_room_soon


NativeView: typing.Any = native("operation").ViewProvider
_with_buttons: weakref.WeakSet = weakref.WeakSet()  # panels that hold the box of FreeCAD's buttons
NativePanel: typing.Any = native("operation").TaskPanel
NativePage: typing.Any = native("operation").TaskPanelPage


class OperationView(NativeView):
    """FreeCAD's view provider with our selection gate, icon and panel. A subclass gives `make_panel`."""

    panel: typing.Any  # the task panel while it is open, or None; FreeCAD's view keeps it

    def __init__(self, vobj, resources):
        super().__init__(vobj, resources)
        self.OpIcon = resources.pixmap
        self.deleteOnReject = False  # what Cancel takes back is the transaction that made it, if that is open
        vobj.Proxy = self

    def loads(self, state):
        above: typing.Any = super()
        (above.loads if hasattr(above, "loads") else above.__setstate__)(state)
        self.deleteOnReject = False

    __setstate__ = loads  # FreeCAD 0.20 knows it by this name

    def getSelectionFactory(self):
        return native("selection").fselect

    def make_panel(self, obj, page):
        """The task panel for `obj` with its own page."""
        raise NotImplementedError

    def setEdit(self, vobj=None, mode=0):
        if mode != 0:
            return False
        vobj = vobj if vobj is not None and hasattr(vobj, "Object") else self.vobj
        forget_panels()
        panel = made_alive(lambda: self._new_panel(vobj.Object))
        try:
            self.setupTaskPanel(panel)
        except Exception:
            panel.stop()  # it is not shown: what it has begun would go on without it
            FreeCADGui.Selection.removeObserver(panel)
            raise
        return True

    def _new_panel(self, obj):
        page = self.getTaskPanelOpPage(obj)
        page.setTitle(self.OpName)
        page.setIcon(self.OpIcon)
        panel = self.make_panel(obj, page)
        for each in panel.featurePages:  # also FreeCAD's own
            require_alive(each.form)
        return panel

    def unsetEdit(self, vobj=None, mode=0):
        """Something else is edited, or the object goes: unlike FreeCAD's own, what was made for the panel
        stays, for it may be the very job that is to be edited."""
        panel, self.panel = self.panel, None
        if panel is not None:
            panel.leave()
        QtCore.QTimer.singleShot(0, _forget_if_closed)


def offer_commands(obj, menu, *names):
    """Entries of an object's context menu that run commands on it, by the commands' names."""
    texts = {
        "PatchMill_Play": translate("PatchMill", "Play the path"),
        "PatchMill_Simulate": translate("PatchMill", "Simulate marks"),
        "PatchMill_Check": translate("PatchMill", "Check"),
        "PatchMill_Report": translate("PatchMill", "Report"),
    }
    for name in names:
        action = QtGui.QAction(texts[name], menu)
        action.triggered.connect(lambda *_, name=name: _run_on(obj, name))
        menu.addAction(action)


def _run_on(obj, command):
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(obj)
    FreeCADGui.runCommand(command)


def forget_panels():
    """Lets go of what Python keeps of closed panels; none is open."""
    for panel in list(_with_buttons):
        panel.let_buttons_go()
    forget_closed_panels()


def _forget_if_closed():
    if not FreeCADGui.Control.activeDialog():
        forget_panels()


class OperationPanel(NativePanel):
    """FreeCAD's panel; Apply previews, and OK closes it when the work behind it is done. A subclass gives
    `preview`, starts its work in `accept` and calls `close_with` at the end."""

    left = False  # closed without OK or Cancel: its operation may be gone

    def setupUi(self):
        super().setupUi()
        for page in self.featurePages:
            guard_editors(page.form)  # also FreeCAD's own
        make_room_soon()

    def modifyStandardButtons(self, buttonBox):
        super().modifyStandardButtons(buttonBox)
        _with_buttons.add(self)

    def let_buttons_go(self):
        """After the panel was closed: FreeCAD's class keeps the box of its buttons, and a widget that is made
        at the address of the deleted box would be taken for it (forget_closed_panels)."""
        self.buttonBox = None
        for page in self.featurePages:
            if hasattr(page, "getPoint"):
                page.getPoint.buttonBox = None
        _with_buttons.discard(self)

    def pageDirtyChanged(self, page):
        """Enables Apply. FreeCAD takes the buttons of a panel away before it forgets the panel: a page that
        changes meanwhile changes nothing that is still shown."""
        if self.buttonBox is None:
            return
        try:
            super().pageDirtyChanged(page)
        except RuntimeError as gone:
            if "already deleted" not in str(gone):
                raise

    def stop(self):
        """Gives up what runs for the panel, and what only the panel showed."""
        raise NotImplementedError

    def leave(self):
        """Closes without OK or Cancel. The document may be in the middle of an undo, or of being closed:
        nothing of it is recomputed before the event loop has its turn."""
        self.stop()
        self.left = True
        for page in self.featurePages:
            page.onDirtyChanged(None)
            page.pageCleanup()
        native("selection").clear()
        FreeCADGui.Selection.removeObserver(self)
        place = (self.obj.Document.Name, self.obj.Name)
        self.obj.Document.commitTransaction()
        FreeCADGui.Control.closeDialog()
        QtCore.QTimer.singleShot(0, lambda: _recompute(*place))

    def preview(self):
        """Shows, when it is there, what the properties as they are would give."""
        raise NotImplementedError

    def clicked(self, button):
        if button == QtGui.QDialogButtonBox.Apply:
            self.panelGetFields()
            self.setClean()
            self.preview()

    def close_with(self, ready):
        """Recomputes the operation with what was made beforehand, and closes. Not to be called inside
        FreeCAD's own call of accept, where it commits nothing."""
        if self.left:
            return
        self.obj.Proxy.ready = ready
        self.obj.Document.recompute()  # inside the transaction
        with host.active_document(self.obj.Document):  # another one may be in front
            super().accept()

    def reject(self, resetEdit=True):
        with host.active_document(self.obj.Document):
            return super().reject(resetEdit)


def _recompute(document, name):
    """Recomputes an operation that may be gone meanwhile."""
    found = FreeCAD.listDocuments().get(document)
    obj = found.getObject(name) if found else None
    job = host.PathUtils.findParentJob(obj) if obj is not None else None
    if job is not None:
        job.ViewObject.Proxy.resetEditVisibility(job)
        found.recompute()


def _is_there(obj):
    """Whether an operation is in a job, and not deleted."""
    try:
        return host.PathUtils.findParentJob(obj) is not None
    except ReferenceError:
        return False


class OperationPage(NativePage):
    """A page with tool controller, coolant and a form of the operation's properties. A subclass builds its
    form with `begin_form` and adds to it."""

    def begin_form(self, table, closed=()):
        """(form, layout): tool controller and coolant in it; `self.properties` is made, its groups are not
        in it yet."""
        form = QtGui.QWidget()
        layout = QtGui.QVBoxLayout(form)
        layout.setContentsMargins(2, 2, 8, 2)  # FreeCAD clips its pages on the right
        form.toolController, form.coolantController = QtGui.QComboBox(), QtGui.QComboBox()
        rows = QtGui.QFormLayout()
        for text, combo in (
            (translate("PatchMill", "Tool controller"), form.toolController),
            (translate("PatchMill", "Coolant"), form.coolantController),
        ):
            let_shrink(combo)
            rows.addRow(text, combo)
        layout.addLayout(rows)
        self.properties = PropertyForm(table, self.obj, closed)
        return form, layout

    def pageGetFields(self):
        """A field that loses the keyboard when its panel closes says that it was edited: the operation may be
        gone by then, or be in the middle of an undo."""
        if _is_there(self.obj):
            super().pageGetFields()

    def resetToolController(self, job, tc):
        """FreeCAD tells all pages that are left of what any job has got, also of another document."""
        if _is_there(self.obj) and tc in host.PathUtils.getToolControllers(self.obj):
            super().resetToolController(job, tc)

    def getFields(self, obj):
        if not _is_there(obj):
            return
        self.properties.store()
        self.updateToolController(obj, self.form.toolController)
        self.updateCoolant(obj, self.form.coolantController)

    def setFields(self, obj):
        self.properties.show()
        self.setupToolController(obj, self.form.toolController)
        self.setupCoolant(obj, self.form.coolantController)

    def getSignalsForUpdate(self, obj):
        return [
            self.properties.changed,
            self.form.toolController.currentIndexChanged,
            self.form.coolantController.currentIndexChanged,
        ]

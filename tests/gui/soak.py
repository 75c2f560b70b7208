"""Random actions of a user, by the X server's own events: clicks, texts, wheel, undo, other documents,
preferences, closing, editing again. No traceback, no lost document, and the program lives. An action counts
if it found what it is done to:

    tests/gui/run_gui tests/gui/soak.py                  # 200 actions
    PATCHMILL_GUI_SECONDS=40000 tests/gui/run_gui tests/gui/soak.py 10000 7     # from another seed

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import random
import re
import sys
import tempfile
import time
import traceback

import driver
import FreeCAD
import FreeCADGui
import hands
from patchmill_gui.app import tool_paths
from patchmill_gui.fields.events import below, unless_deleted
from PySide import QtCore, QtGui

ACTIONS, SEED, MOST_DOCUMENTS = 200, 20160105, 3
LOOK_EVERY = 100  # actions, into FreeCAD's report
QUICK = 0.01  # seconds that a hand takes between two actions here
TEXTS = ("0.3", "0,7 mm", "-1", "abc", "1e9", "", "2*0.4", "12", "45 °", "0")
COMMANDS = (
    "PatchMill_PlanarTexture",
    "PatchMill_PyramidTexture",
    "PatchMill_CurvedTexture",
    "PatchMill_CalibrationPatch",
    "PatchMill_CopyMilling",
    "PatchMill_DressupDcm",
    "PatchMill_Play",
    "PatchMill_Simulate",
    "PatchMill_Check",
    "PatchMill_Post",
    "PatchMill_Machines",
)
PLACES = ("Combo View", "Tasks", "PostDialog", "MachineEditor")  # of what can be pressed
VIEW = "User parameter:BaseApp/Preferences/View"


def say(sentence):
    """Prints past FreeCAD's own output, whose end is lost when the program ends."""
    os.write(2, (sentence + "\n").encode())


def tracebacks(text):
    """Tracebacks in a report that pass through this module and are no sentence to the user, as FreeCAD writes
    one where a recompute is refused. FreeCAD's own are told, but are no fault of ours: what Draft puts off
    until the event loop's next turn meets objects that Undo took away meanwhile."""
    blocks = re.findall(r"Traceback .*\n(?:[ \t]+.*\n)+.*", text)
    passing = [block for block in blocks if "patchmill" in block.lower()]
    if len(blocks) > len(passing):
        say("%d tracebacks of FreeCAD's own" % (len(blocks) - len(passing)))
    return [block for block in passing if "InputError" not in block]


def reported():
    """Tracebacks in FreeCAD's report since the last look."""
    views = FreeCADGui.getMainWindow().findChildren(QtGui.QTextEdit, "Report view")
    found = [error for view in views for error in tracebacks(view.toPlainText())]
    for view in views:
        view.clear()
    return found


class Soak:
    """`chance`: a random.Random. `told`: tracebacks. An action returns False where there is nothing that it
    could be done to."""

    def __init__(self, chance):
        self.chance = chance
        self.documents = {}  # name: file
        self.told = []
        self.done = []
        sys.excepthook = lambda *error: self.told.append("".join(traceback.format_exception(*error)))

    def widgets(self, *kinds):
        """What can be pressed in the task panel and in windows of ours, from above to below."""
        docks = FreeCADGui.getMainWindow().findChildren(QtGui.QDockWidget)  # as lasting as the window
        places = docks + [w for w in QtGui.QApplication.topLevelWidgets() if isinstance(w, QtGui.QDialog)]
        places = [p for p in places if unless_deleted(p.isVisible, False) and p.objectName() in PLACES]
        found = [w for place in places for w in below(place, kinds) if unless_deleted(w.isVisible, False)]
        found = [w for w in found if w.isEnabled() and w.height() > 4]
        return sorted(found, key=lambda w: w.mapToGlobal(QtCore.QPoint(0, 0)).toTuple()[::-1])

    def any_of(self, *kinds):
        found = self.widgets(*kinds)
        return self.chance.choice(found) if found else None

    def save_documents(self, folder):
        """The documents that are opened: what a script adds while a panel is open would be part of what that
        panel's Cancel takes back."""
        for number in range(MOST_DOCUMENTS):
            document, _ = driver.new_document(driver.wavy_block(12.0, 8.0), "Soak")
            document.saveAs(os.path.join(folder, "soak%d.FCStd" % number))
            FreeCAD.closeDocument(document.Name)
        self.files = [os.path.join(folder, "soak%d.FCStd" % n) for n in range(MOST_DOCUMENTS)]

    def open_document(self):
        shut = [f for f in self.files if f not in self.documents.values()]
        if not shut:
            return False
        self.documents[FreeCAD.openDocument(shut[0]).Name] = shut[0]
        return True

    def close_document(self):
        if len(self.documents) < MOST_DOCUMENTS:
            return False
        name = self.chance.choice(sorted(self.documents))
        del self.documents[name]
        FreeCAD.closeDocument(name)
        return True

    def switch_document(self):
        area = FreeCADGui.getMainWindow().findChild(QtGui.QMdiArea)
        windows = sorted(below(area, QtGui.QMdiSubWindow), key=lambda window: window.windowTitle())
        if len(windows) > 1:
            area.setActiveSubWindow(self.chance.choice(windows))
        return len(windows) > 1

    @staticmethod
    def ours():
        """The operations and modifiers of ours in the active document."""
        document = FreeCAD.ActiveDocument
        return [o for o in document.Objects if tool_paths.is_ours(o)] if document else []

    def choose_operation(self):
        """Selects one of ours; returns whether there is one."""
        found = self.ours()
        if found:
            FreeCADGui.Selection.clearSelection()
            FreeCADGui.Selection.addSelection(self.chance.choice(found))
        return bool(found)

    def command(self):
        """On the part's top face, or on an operation."""
        document = FreeCAD.ActiveDocument
        part = document.getObject("Part") if document else None
        chosen = self.chance.random() < 0.5 and self.choose_operation()
        if not chosen and part is not None:
            driver.select(part, driver.top_face(part.Shape))
        active = [name for name in COMMANDS if FreeCADGui.Command.get(name).isActive()]
        if not active:
            return False
        FreeCADGui.runCommand(self.chance.choice(active))
        return True

    def edit(self):
        """As a double click on an operation in the tree."""
        found = self.ours()
        if not found:
            return False
        view = self.chance.choice(found).ViewObject
        view.Document.setEdit(view, 0)
        return True

    def delete(self):
        """By the command, of an operation."""
        if FreeCADGui.Control.activeDialog() or not self.choose_operation():
            return False
        FreeCADGui.runCommand("Std_Delete")
        return True

    def press_button(self):
        kinds = (QtGui.QPushButton, QtGui.QCheckBox, QtGui.QToolButton)
        ends = [b for box in self.widgets(QtGui.QDialogButtonBox) for b in box.buttons()]
        found = [b for b in self.widgets(*kinds) if b not in ends]
        if not found:
            return False
        button = self.chance.choice(found)
        hands.show(button)
        return self.tap(button)

    def end_panel(self):
        boxes = self.widgets(QtGui.QDialogButtonBox)
        return bool(boxes) and self.tap(self.chance.choice(boxes[0].buttons()))

    def type_text(self):
        field = self.any_of(QtGui.QAbstractSpinBox, QtGui.QLineEdit)
        if field is None:
            return False
        hands.show(field)
        typed = ["key", "ctrl+a", "type", "--delay", 5, "--", self.chance.choice(TEXTS)]
        if not self.tap(field, *typed):
            return False
        hands.act("key", self.chance.choice(("Return", "Tab")))
        return True

    def choose_entry(self):
        box = self.any_of(QtGui.QComboBox)
        if box is None:
            return False
        hands.show(box)
        if not self.tap(box):
            return False
        hands.act("key", "--delay", 20, *["Down"] * self.chance.randrange(1, 4), "Return")
        return True

    def turn_wheel(self):
        widget = self.any_of(QtGui.QAbstractSpinBox, QtGui.QComboBox, QtGui.QLabel)
        if widget is None or not self.seen(widget):
            return False
        turn = self.chance.choice((4, 5))
        hands.act("mousemove", *hands.place_of(widget), "click", "--repeat", 3, turn)
        return True

    def click_view(self):
        """On a point of the 3-D view: selects a face, a dimple's operation, or nothing."""
        area = FreeCADGui.getMainWindow().findChild(QtGui.QMdiArea)
        if not below(area, QtGui.QMdiSubWindow):
            return False
        x, y = (int(self.chance.uniform(0.3, 0.7) * side) for side in (area.width(), area.height()))
        hands.act("mousemove", *hands.place_of(area, QtCore.QPoint(x, y)), "click", 1)
        return True

    def tap(self, widget, *more):
        """A quick click, and what xdotool is to do next. Returns whether the widget can be touched."""
        if not self.seen(widget):
            return False
        hands.act("mousemove", *hands.place_of(widget), "click", 1, *more)
        return True

    seen = staticmethod(hands.on_top)

    def undo(self):
        FreeCADGui.runCommand(self.chance.choice(("Std_Undo", "Std_Undo", "Std_Redo")))
        return True

    def preference(self):
        group = FreeCAD.ParamGet(VIEW)
        name = self.chance.choice(("EnablePreselection", "EnableSelection", "UseAutoRotation"))
        group.SetBool(name, not group.GetBool(name, True))
        FreeCAD.Units.setSchema(self.chance.choice((0, 3)))
        return True

    def step(self):
        """One action that finds what it is done to."""
        weights = {
            self.press_button: 6, self.type_text: 5, self.choose_entry: 4, self.turn_wheel: 3,
            self.command: 4, self.edit: 2, self.end_panel: 3, self.undo: 2, self.delete: 0.5,
            self.preference: 1, self.click_view: 1, self.switch_document: 1, self.open_document: 1,
            self.close_document: 1,
        }  # fmt: skip
        done = False
        while not done:
            (action,) = self.chance.choices(list(weights), list(weights.values()))
            say("%d %s" % (len(self.done) + 1, action.__name__))
            try:
                done = action()
            except (AssertionError, RuntimeError) as error:  # what was to be pressed is gone meanwhile
                say("   gave up: %s" % str(error)[:100])
                driver.rest(0.0)
            if self.trouble():
                break
        self.done.append(action.__name__)
        driver.rest(self.chance.choice((0.0, 0.0, 0.02, 0.1)))

    def trouble(self):
        """What is wrong now, a sentence, or ''."""
        if self.told:
            return self.told[0]
        lost = [n for n in self.documents if n not in FreeCAD.listDocuments()]
        lost += [n for n in self.documents if n not in lost and not FreeCAD.getDocument(n).getObject("Part")]
        return "lost: %s" % lost if lost else ""

    def run(self, count):
        """So many actions, or until one is found that should not be; what was wrong, or ''."""
        began = time.monotonic()
        while len(self.done) < count:
            self.step()
            wrong = self.trouble()
            if len(self.done) % LOOK_EVERY == 0 or len(self.done) == count:
                say("%d actions in %.0f s" % (len(self.done), time.monotonic() - began))
                wrong = wrong or "\n".join(reported())
            if wrong:
                return "after %d actions, the last %s:\n%s" % (len(self.done), self.done[-5:], wrong)
        return ""


def main():
    count, seed = (int(v) for v in (sys.argv[1:] + [ACTIONS, SEED][len(sys.argv) - 1 :])[:2])
    FreeCADGui.activateWorkbench("PatchMillWorkbench")
    hands.SETTLE = QUICK
    soak = Soak(random.Random(seed))
    folder = tempfile.mkdtemp()
    os.chdir(folder)  # a name that is typed into a file window is a file there
    soak.save_documents(folder)
    soak.open_document()
    say("seed %d" % seed)
    wrong = soak.run(count)
    say("%d actions, seed %d: %s" % (len(soak.done), seed, wrong[:3000] or "nothing found"))
    return 1 if wrong else 0

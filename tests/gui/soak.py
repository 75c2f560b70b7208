"""Random actions of a user, by the X server's own events: clicks, texts, wheel, undo, other documents,
preferences, closing. No traceback, no lost document, and the program lives:

    tests/gui/run_gui tests/gui/soak.py                  # 200 actions
    PATCHMILL_GUI_SECONDS=40000 tests/gui/run_gui tests/gui/soak.py 10000 7     # from another seed

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import random
import re
import sys
import tempfile
import traceback

import driver
import FreeCAD
import FreeCADGui
import hands
from PySide import QtGui

ACTIONS, SEED, MOST_DOCUMENTS = 200, 20160105, 3
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
)
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
    say("%d tracebacks of FreeCAD's own" % (len(blocks) - len(passing)))
    return [block for block in passing if "InputError" not in block]


class Soak:
    """`chance`: a random.Random. `told`: tracebacks."""

    def __init__(self, chance):
        self.chance = chance
        self.documents = {}  # name: file
        self.told = []
        self.done = []
        sys.excepthook = lambda *error: self.told.append("".join(traceback.format_exception(*error)))

    def widgets(self, *kinds):
        """What can be pressed in the task panel and in windows of ours, in the order in which Qt has it."""
        window = FreeCADGui.getMainWindow()
        places = window.findChildren(QtGui.QDockWidget) + window.findChildren(QtGui.QDialog)
        places = [p for p in places if p.isVisible() and p.objectName() in ("Combo View", "PostDialog")]
        found = [w for place in places for kind in kinds for w in place.findChildren(kind)]
        return [w for w in found if w.isVisible() and w.isEnabled() and w.height() > 4]

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
        if shut:
            self.documents[FreeCAD.openDocument(shut[0]).Name] = shut[0]

    def close_document(self):
        if len(self.documents) == MOST_DOCUMENTS:
            name = self.chance.choice(sorted(self.documents))
            del self.documents[name]
            FreeCAD.closeDocument(name)

    def switch_document(self):
        area = FreeCADGui.getMainWindow().findChild(QtGui.QMdiArea)
        windows = area.subWindowList()
        if windows:
            area.setActiveSubWindow(self.chance.choice(windows))

    def command(self):
        document = FreeCAD.ActiveDocument
        part = document.getObject("Part") if document else None
        if part is not None:
            driver.select(part, driver.top_face(part.Shape))
        FreeCADGui.runCommand(self.chance.choice(COMMANDS))

    def press_button(self):
        button = self.any_of(QtGui.QPushButton, QtGui.QCheckBox, QtGui.QToolButton)
        if button is not None and not self.ends_panel(button):
            hands.show(button)
            self.tap(button)

    def ends_panel(self, button):
        return any(button in box.buttons() for box in self.widgets(QtGui.QDialogButtonBox))

    def end_panel(self):
        boxes = self.widgets(QtGui.QDialogButtonBox)
        if boxes:
            self.tap(self.chance.choice(boxes[0].buttons()))

    def type_text(self):
        field = self.any_of(QtGui.QAbstractSpinBox, QtGui.QLineEdit)
        if field is not None:
            hands.show(field)
            self.tap(field, "key", "ctrl+a", "type", "--delay", 5, "--", self.chance.choice(TEXTS))
            hands.act("key", self.chance.choice(("Return", "Tab")))

    def choose_entry(self):
        box = self.any_of(QtGui.QComboBox)
        if box is not None:
            hands.show(box)
            self.tap(box)
            hands.act("key", "--delay", 20, *["Down"] * self.chance.randrange(1, 4), "Return")

    def turn_wheel(self):
        widget = self.any_of(QtGui.QAbstractSpinBox, QtGui.QComboBox, QtGui.QLabel)
        if widget is not None and self.seen(widget):
            turn = self.chance.choice((4, 5))
            hands.act("mousemove", *hands.place_of(widget), "click", "--repeat", 3, turn)

    def tap(self, widget, *more):
        """A quick click, and what xdotool is to do next."""
        if self.seen(widget):
            hands.act("mousemove", *hands.place_of(widget), "click", 1, *more)

    seen = staticmethod(hands.on_top)

    def undo(self):
        FreeCADGui.runCommand(self.chance.choice(("Std_Undo", "Std_Undo", "Std_Redo")))

    def preference(self):
        group = FreeCAD.ParamGet(VIEW)
        name = self.chance.choice(("EnablePreselection", "EnableSelection", "UseAutoRotation"))
        group.SetBool(name, not group.GetBool(name, True))
        FreeCAD.Units.setSchema(self.chance.choice((0, 3)))

    def step(self):
        weights = {
            self.press_button: 6, self.type_text: 5, self.choose_entry: 4, self.turn_wheel: 3,
            self.command: 4, self.end_panel: 3, self.undo: 2, self.preference: 1,
            self.switch_document: 1, self.open_document: 1, self.close_document: 1,
        }  # fmt: skip
        (action,) = self.chance.choices(list(weights), list(weights.values()))
        self.done.append(action.__name__)
        say("%d %s" % (len(self.done), action.__name__))
        try:
            action()
        except (AssertionError, RuntimeError) as error:  # what was to be pressed is gone meanwhile
            say("   gave up: %s" % str(error)[:100])
        driver.rest(self.chance.choice((0.0, 0.02, 0.2)))

    def trouble(self):
        """What is wrong now, a sentence, or ''."""
        if self.told:
            return self.told[0]
        lost = [n for n in self.documents if n not in FreeCAD.listDocuments()]
        lost += [n for n in self.documents if n not in lost and not FreeCAD.getDocument(n).getObject("Part")]
        return "lost: %s" % lost if lost else ""


def main():
    count, seed = (int(v) for v in (sys.argv[1:] + [ACTIONS, SEED][len(sys.argv) - 1 :])[:2])
    FreeCADGui.activateWorkbench("PatchMillWorkbench")
    soak = Soak(random.Random(seed))
    folder = tempfile.mkdtemp()
    os.chdir(folder)  # a name that is typed into a file window is a file there
    soak.save_documents(folder)
    soak.open_document()
    for _ in range(count):
        soak.step()
        if trouble := soak.trouble():
            last = soak.done[-5:]
            say("after %d actions, the last %s:\n%s" % (len(soak.done), last, trouble))
            return 1
    reports = FreeCADGui.getMainWindow().findChildren(QtGui.QTextEdit, "Report view")
    told = [error for view in reports for error in tracebacks(view.toPlainText())]
    for text in told:
        say(text[:3000])
    say("%d actions, seed %d: %s" % (count, seed, "tracebacks" if told else "nothing found"))
    return 1 if told else 0

"""Mouse and keyboard of a user, by xdotool: the events come from the X server, as real ones do, so that
focus, popups, grabs and the wheel behave as on a desk. Needs the `xdotool` program.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import subprocess

import driver
from patchmill_gui.fields.events import around
from PySide import QtCore, QtGui

SETTLE = 0.05  # seconds that a hand takes between two actions


def act(*arguments):
    """Runs xdotool, which may do several things in turn, while the event loop goes on."""
    process = subprocess.Popen(["xdotool", *map(str, arguments)])
    assert driver.wait(lambda: process.poll() is not None, 20), "xdotool does not end"
    assert process.returncode == 0, "xdotool %s" % (arguments,)
    driver.rest(SETTLE)


def place_of(widget, at=None):
    """x and y of a widget's middle, or of the QPoint `at` in it, in the screen's pixels, as texts."""
    place = widget.mapToGlobal(widget.rect().center() if at is None else at)
    scale = QtGui.QApplication.primaryScreen().devicePixelRatio()
    return str(round(place.x() * scale)), str(round(place.y() * scale))


def on_top(widget):
    """Whether a widget's middle can be touched: nothing lies over it, and no scroll area ends before it."""
    top = QtGui.QApplication.widgetAt(widget.mapToGlobal(widget.rect().center()))
    return top is not None and (top is widget or widget.isAncestorOf(top))


def point_at(widget, at=None):
    """Moves the pointer over a widget: its middle, or the QPoint `at` in it. Rows come and go while a panel
    fills: the pointer follows, as an eye does."""
    for _ in range(10):
        steady(widget)
        place = widget.mapToGlobal(widget.rect().center() if at is None else at)
        if (QtGui.QCursor.pos() - place).manhattanLength() <= 2:
            return
        assert QtGui.QApplication.widgetAt(place) is not None, "nothing is shown at %s" % place
        act("mousemove", *place_of(widget, at))
    raise AssertionError("%s does not come to rest" % widget)


def steady(widget):
    """Waits until a widget has stayed at its place for a while."""
    for _ in range(50):
        before = (widget.mapToGlobal(QtCore.QPoint(0, 0)), widget.size())
        driver.rest(0.1)
        if before == (widget.mapToGlobal(QtCore.QPoint(0, 0)), widget.size()):
            return
    raise AssertionError("%s does not come to rest" % widget)


def click(widget, at=None, times=1):
    """Clicks with the left button."""
    point_at(widget, at)
    act("click", "--repeat", times, "--delay", 80, 1)


def wheel(widget, steps, at=None):
    """Turns the wheel over a widget; towards the user if `steps` is positive."""
    point_at(widget, at)
    act("click", "--repeat", abs(steps), "--delay", 40, 5 if steps > 0 else 4)


def give_keyboard(window):
    """What a window manager does for a window that has just opened; there is none here."""
    window.setProperty("answered", True)  # tests/gui/start.py leaves it alone
    window.activateWindow()
    assert driver.wait(window.isActiveWindow, 10), "%s does not get the keyboard" % window
    driver.rest(SETTLE)


def press(*keys):
    """Presses keys, one after the other, by X's names: Return, Tab, ctrl+a, Up."""
    act("key", "--delay", 60, *keys)


def write(text, pause=40):
    """Types text where the keyboard's focus is, a key every `pause` milliseconds."""
    act("type", "--delay", pause, "--", text)


def enter(field, text, end="Return", pause=40):
    """As a user who clicks into a field, selects what is there, types and presses `end`, if that is a key;
    who looks first whether the field has the keyboard."""
    line = field if isinstance(field, QtGui.QLineEdit) else field.findChild(QtGui.QLineEdit)
    for _ in range(3):
        show(field)
        click(field)
        if driver.wait(line.hasFocus, 2):
            break
    other = QtGui.QApplication.focusWidget()
    assert line.hasFocus(), "%s does not take the keyboard: %s has it" % (field, other)
    press("ctrl+a")
    bare = getattr(field, "cleanText", line.text)  # of a box that says its unit behind the number
    selected = driver.wait(lambda: line.selectedText() in (line.text(), bare()), 2)
    assert selected, "%r is not selected" % line.text()
    write(text, pause)
    if end:
        press(end)


def show(widget):
    """Scrolls until a widget is seen, in all areas around it from within."""
    driver.rest(SETTLE)
    for area in reversed(around(widget, QtGui.QScrollArea)):
        area.ensureWidgetVisible(widget)
        driver.rest(SETTLE)
    for view in around(widget, QtGui.QTreeView):  # as the editor of an item
        place = widget.mapTo(view.viewport(), widget.rect().center())
        view.scrollTo(view.indexAt(place), QtGui.QAbstractItemView.PositionAtCenter)
        driver.rest(SETTLE)
    driver.rest(SETTLE)


def open_list(box):
    """Opens the list of a combo box by a click; clicks again where rows that came or went meanwhile took the
    box from under the pointer."""
    for _ in range(3):
        show(box)
        click(box)
        if driver.wait(lambda: box.view().isVisible(), 3):
            return
    raise AssertionError("the list of %s does not open" % (box.objectName() or box))


def choose(box, text):
    """Opens a combo box by a click, and clicks on the entry that reads `text`."""
    open_list(box)
    view = box.view()
    row = box.findText(text)
    assert row >= 0, "no %r among %s" % (text, [box.itemText(i) for i in range(box.count())])
    driver.rest(0.3)  # a list that has just opened takes no click
    index = view.model().index(box.findText(text), box.modelColumn())
    view.scrollTo(index)
    click(view.viewport(), view.visualRect(index).center())
    assert driver.wait(lambda: not view.isVisible(), 5), "the list does not close"
    driver.rest(SETTLE)


def click_button(text, parent=None):
    """Clicks the visible push button of that text below `parent`, of the whole application by default."""
    found = parent.findChildren(QtGui.QPushButton) if parent else QtGui.QApplication.allWidgets()
    for button in found:
        if isinstance(button, QtGui.QPushButton) and button.isVisible():
            if button.text().replace("&", "") == text:
                show(button)
                return click(button)
    raise AssertionError("no button %r is shown" % text)


def middle_left(widget, inset=8):
    """A point near the left border of a widget."""
    return QtCore.QPoint(inset, widget.height() // 2)

"""The head of a texture's panel: what comes out, in green, amber or red, and buttons for what helps. It stays
at the top of FreeCAD's panel however far that is scrolled, and never shows old numbers as new ones.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import html
import math
from functools import partial

from patchmill.advice import verdict
from patchmill.advice.found import GOOD, GOOD_FRACTION
from patchmill.advice.remedies import LAID
from patchmill.machine.machining_time import in_words
from PySide import QtCore, QtGui

from patchmill_gui.fields import unit_text
from patchmill_gui.fields.events import around, kind_of, unless_deleted
from patchmill_gui.fields.sentences import in_user_units
from patchmill_gui.forms.texture_summary import grouped
from patchmill_gui.forms.widgets import WrappingButton, one_shot, plain_label, translate, wrapping_label
from patchmill_gui.work.room import TASK_VIEW

GREEN, AMBER, RED, GREY = "#2e7d32", "#8a5a00", "#b71c1c", "#5f6368"  # under white text, contrast above 5
SETTLED_MS = 300  # FreeCAD scrolls to the page that it opens, and OK and Cancel out of sight


class Head(QtGui.QFrame):
    """`taken(remedy)` when the button of a remedy was clicked."""

    taken = QtCore.Signal(object)

    def __init__(self):
        super().__init__()
        self.setObjectName("TextureHead")
        self.setAutoFillBackground(True)
        self.bar, self.text = plain_label(), wrapping_label()
        self.bar.setObjectName("HeadVerdict")
        self.text.setObjectName("HeadNumbers")
        self.text.setTextFormat(QtCore.Qt.RichText)
        self.hint = plain_label()
        self.hint.hide()
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(4, 4, 4, 4)
        layout.setSpacing(3)
        layout.addWidget(self.bar)
        layout.addWidget(self.text)
        layout.addWidget(self.hint)
        self.fixes = QtGui.QVBoxLayout()
        self.fixes.setSpacing(2)
        layout.addLayout(self.fixes)
        self.buttons = []
        self._place_soon = one_shot(self._place)
        self.state = None
        self._area = self._form = self._margins = None
        self._settled = False
        self.busy(translate("PatchMill", "Looking for good values …"))

    def _say(self, state, sentence):
        self.state = state
        self.bar.setText(in_user_units(sentence))
        self.bar.setStyleSheet(
            "background: %s; color: white; padding: 3px; border-radius: 3px; font-weight: bold" % state
        )
        self._place()

    def busy(self, sentence):
        """Numbers are being made: the old ones are taken away."""
        self.text.setText("")
        self.offer([])
        self.note("")
        self._say(GREY, sentence)

    def show_found(self, found, seconds, phase, notes=()):
        """`found`: an Assessment; `seconds` of milling; `phase`: a _patchmill.Verdict, or None where no
        machine was named; `notes`: sentences that the user should read."""
        lines = [
            "<b>%s</b> · %s"
            % (translate("PatchMill", "{} dimples").format(grouped(found.dimples)), in_words(seconds))
        ]
        if found.patches:
            arrays = sorted({translate("PatchMill", patch.array) for patch in found.patches if patch.array})
            lines.append(
                translate("PatchMill", "quality {} of patches at {}° to {}°: {}").format(
                    " · ".join("%.2f" % patch.quality for patch in found.patches),
                    "%.0f" % found.patches[0].tilt,
                    "%.0f" % found.patches[-1].tilt,
                    ", ".join(arrays) or translate("PatchMill", "none"),
                )
            )
        if found.away_fraction > 1.0 - GOOD_FRACTION:
            away = translate("PatchMill", "{:.0f} % of the faces look away or are too steep as the part lies")
            lines.append(away.format(100.0 * found.away_fraction))
        lines += (html.escape(in_user_units(note)) for note in notes)
        self.text.setText("<br>".join(lines))
        self._say(*verdict_of(found, phase))

    def show_error(self, sentence):
        self.text.setText("")
        self._say(RED, sentence)

    def note(self, sentence):
        """A sentence below the numbers; none if it is empty."""
        self.hint.setText(sentence)
        self.hint.setVisible(bool(sentence))
        self._place()

    def offer(self, remedies):
        """Buttons for remedies.Remedy that were tried."""
        for button in self.buttons:
            button.deleteLater()
            button.hide()
        self.buttons = []
        for remedy in remedies:
            button = WrappingButton(remedy_text(remedy))
            button.setObjectName("Fix" + remedy.kind.title().replace(" ", ""))
            button.broken.connect(self._place_soon.start)
            button.setToolTip(translate("PatchMill", "Tried: this is what it gives"))
            button.clicked.connect(lambda *_, chosen=remedy: self.taken.emit(chosen))
            self.fixes.addWidget(button)
            self.buttons.append(button)
        self._place()

    def pin(self, form):
        """Puts the head on top of the scroll area of FreeCAD's panel that holds `form`; its view then begins
        below it. Returns whether there is one."""
        holders = around(form, QtGui.QWidget)
        views = [unless_deleted(partial(each.inherits, TASK_VIEW), False) for each in holders]
        if True not in views:
            return False
        # FreeCAD's panel is one, or has one in it (1.1); pages of the tool box have areas of their own
        inwards = holders[views.index(True) :]
        area = next(each for each in inwards if isinstance(each, QtGui.QScrollArea))
        self._area, self._form = area, form
        self._margins = area.viewportMargins()  # those of its contents end when it is resized
        self.setParent(area)
        area.installEventFilter(self)
        self.show()
        self._place()
        QtCore.QTimer.singleShot(0, self._place)
        QtCore.QTimer.singleShot(SETTLED_MS, self._scroll_to_top)
        return True

    def _scroll_to_top(self):
        self._settled = True
        if self._area is not None:
            self._area.verticalScrollBar().setValue(0)

    def unpin(self):
        """Gives the panel its place back."""
        if self._area is not None:
            self._area.removeEventFilter(self)
            self._area.widget().setMinimumHeight(0)
            m = self._margins
            self._area.setViewportMargins(m.left(), m.top(), m.right(), m.bottom())
            self._area = self._form = None
        self.hide()
        self.setParent(None)  # PySide keeps what has a parent
        self.deleteLater()

    def eventFilter(self, _, event):
        kind = kind_of(event)
        if kind in (QtCore.QEvent.Resize, QtCore.QEvent.LayoutRequest):
            self._place(resized=kind == QtCore.QEvent.Resize)
        return False

    def _place(self, resized=False):
        if self._area is None:
            return
        area, m, bar = self._area, self._margins, self._area.verticalScrollBar()
        width, before = area.width(), area.viewportMargins().top() - m.top()
        for layout in (self.fixes, self.layout()):
            layout.invalidate()  # buttons that broke their text anew have told neither that they are higher
        height = max(self.layout().heightForWidth(width), self.layout().minimumSize().height())
        rows_stay = self._settled and not resized and _is_at_work_in(area, self._form)
        if rows_stay:
            height = max(height, before - bar.value())  # what cannot be scrolled back stays empty
        self.setGeometry(0, 0, width, height)
        self.raise_()
        if height != before:
            scrolled = bar.value() + height - before if rows_stay else 0 if resized else bar.value()
            area.setViewportMargins(m.left(), m.top() + height, m.right(), m.bottom())
            _scroll_to(area, scrolled)


def _is_at_work_in(area, form):
    """Whether a field in a scroll area has the keyboard, or the pointer is over a field, or over a button of
    the form in it: not OK, which the head would cover. That then stays where it is on the screen, however the
    head's sentences come and go."""
    fields = (QtGui.QLineEdit, QtGui.QAbstractSpinBox, QtGui.QComboBox)
    buttons = (QtGui.QAbstractButton, QtGui.QAbstractSlider, QtGui.QPlainTextEdit)
    app = QtGui.QApplication
    typed, pointed = app.focusWidget(), app.widgetAt(QtGui.QCursor.pos())
    at_hand = [(area, typed)] if isinstance(typed, fields) else []
    if isinstance(pointed, fields + buttons):
        at_hand.append((area if isinstance(pointed, fields) else form, pointed))
    return any(unless_deleted(partial(around.isAncestorOf, one), False) for around, one in at_hand)


def _scroll_to(area, value):
    """Scrolls to `value`, with empty room below the contents where they are too short for that."""
    bar, contents = area.verticalScrollBar(), area.widget()
    height = area.viewport().height() + value if value > 0 else 0
    contents.setMinimumHeight(height)
    if height > contents.height():
        contents.resize(contents.width(), height)  # the bar's range follows at once
    bar.setValue(value)


def verdict_of(found, phase):
    """(colour, sentence) of an Assessment and a _patchmill.Verdict, or None where no machine was named."""
    level, why = verdict.judge(found, phase)
    colour = {verdict.GOOD: GREEN, verdict.DOUBTFUL: AMBER, verdict.BAD: RED}[level]
    share = "%.0f %%" % (100.0 * found.good_fraction)
    left_out = "%.0f %%" % (100.0 * (1.0 - found.milled_fraction))
    short = translate("PatchMill", "{} of the faces good; {} left out").format(share, left_out)
    if why == verdict.LOST:
        return colour, phase.sentence
    if why == verdict.BORDERS and found.whole >= GOOD:
        area = math.floor(100.0 * found.milled_fraction * found.whole_area)
        text = translate("PatchMill", "{} of the faces as planned, their borders included")
        return colour, text.format("%d %%" % area)
    if why == verdict.BORDERS:
        text = translate("PatchMill", "Quality {} with the borders of the faces, {} inside")
        whole = math.floor(100.0 * found.whole) / 100.0  # 0.949 is not good, and shall not read as if
        return colour, text.format("%.2f" % whole, "%.2f" % found.quality)
    if why == verdict.AWAY:
        text = translate("PatchMill", "{} of the faces good; the rest looks away: turn the part for it")
        return colour, text.format(share)
    said = {
        verdict.TOUCHES: translate("PatchMill", "The tool runs into the part beside the faces"),
        verdict.NOT_SIMULATED: translate("PatchMill", "Not simulated"),
        verdict.ALL: translate("PatchMill", "Good: {} of the faces as planned").format(share),
        verdict.PHASE_UNKNOWN: translate(
            "PatchMill", "Good if the machine holds the phase: choose a machine to know"
        ),
    }
    return colour, said.get(why, short)


def _sides_text(remedy):
    """Of a texture that shares the faces with others."""
    count = len(remedy.others) + 1
    if remedy.axis is None:
        text = translate("PatchMill", "Mill them in {} operations, the tool leant from each side")
    else:
        text = translate("PatchMill", "Mill them in {} clampings, a job for each")
    return text.format(count)


def remedy_text(remedy):
    """What a remedy does and gives, as its button says it."""
    found, fields = remedy.assessment, remedy.fields
    steepest = fields.get("steepest_slope", LAID["steepest_slope"])
    what = {
        "incline": translate("PatchMill", "Incline the part {:.0f}°").format(remedy.angle),
        "lean": translate("PatchMill", "Lean the tool {:.0f}°").format(remedy.angle),
        "along": translate("PatchMill", "Let the tool follow the faces, leant {:.0f}°").format(remedy.angle),
        "lay": translate("PatchMill", "Lay the dimples along the faces"),
        "finer": translate("PatchMill", "Choose a smaller spacing"),
        "leave out": translate("PatchMill", "Leave out what is too flat")
        if "minimum_tilt" in fields
        else translate("PatchMill", "Leave out what is steeper than {:.0f}°").format(steepest),
        "values": translate("PatchMill", "Take the values that suit"),
        "sides": _sides_text(remedy),
        "ball": translate("PatchMill", "Take a smaller ball"),
    }[remedy.kind]
    if "tool" in fields:
        across = unit_text.text_of(2.0 * fields["tool"].radius, "mm")
        what = translate("PatchMill", "{}, tool diameter {}").format(what, across)
    if "spacing" in fields:
        spacing = unit_text.text_of(fields["spacing"], "mm")
        what = translate("PatchMill", "{}, spacing {}").format(what, spacing)
    if "mapping" in fields and remedy.kind != "lay":
        what = translate("PatchMill", "{}, dimples laid along the faces").format(what)
    if "minimum_tilt" in fields and remedy.kind != "leave out":
        what = translate("PatchMill", "{}, leave out what is too flat").format(what)
    if remedy.walled:
        margin = unit_text.text_of(fields["margin"], "mm")
        what = translate("PatchMill", "{}, margin {} beside walls").format(what, margin)
    own = remedy.kind == "sides" or (remedy.kind == "leave out" and "minimum_tilt" not in fields)
    if steepest != LAID["steepest_slope"] and not own:
        what = translate("PatchMill", "{}, leave out what is steeper than {:.0f}°").format(what, steepest)
    if not found.borders_are_good:
        what = translate("PatchMill", "{}, borders not as good").format(what)
    return translate("PatchMill", "{}: {:.0f} % good, {}").format(
        what, 100.0 * found.good_fraction, in_words(found.seconds)
    )

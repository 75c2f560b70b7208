"""The time of a texture over the spindle's speed, in its panel: one click looks for the best one that holds,
the next one takes it over. Nothing is changed before that, and a tool controller that other operations use
stays as it is.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from math import log

from _patchmill import InputError
from patchmill.advice import apply
from patchmill.machine.machining_time import in_words
from patchmill.textures.plan import plan_texture
from patchmill.verify import best_speed
from PySide import QtCore, QtGui

from patchmill_gui.fields.sentences import error_text
from patchmill_gui.forms.widgets import Notice, ProgressBar, plain_label, translate
from patchmill_gui.work.background import Background

HOLDS, LOST = QtGui.QColor("#3d85c6"), QtGui.QColor("#8a8f98")  # on light and on dark
HEIGHT, EDGE, DOT = 90, 8, 3  # pixels
PLANNING = 0.1  # of the work: the plan itself, before it is tried at other speeds


class Curve(QtGui.QWidget):
    """Time over speed, both in equal ratios: full dots hold, empty ones do not; a ring is round the best."""

    def __init__(self):
        super().__init__()
        self.setFixedHeight(HEIGHT)
        self.found = None

    def show_found(self, found):
        self.found = found
        self.setVisible(True)
        self.update()

    def places(self):
        """{index in the curve: QPointF} of the points that have a time."""
        there = {i: p for i, p in enumerate(self.found.curve) if p.seconds == p.seconds}
        if not there:
            return {}
        across = [log(p.rpm) for p in there.values()]
        up = [log(p.seconds) for p in there.values()]
        wide, high = self.width() - 2 * EDGE, self.height() - 2 * EDGE

        def share(value, values):
            return (value - min(values)) / ((max(values) - min(values)) or 1.0)

        return {
            i: QtCore.QPointF(EDGE + wide * share(x, across), EDGE + high * (1.0 - share(y, up)))
            for i, x, y in zip(there, across, up)
        }

    def paintEvent(self, event):
        if self.found is None:
            return
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        places = self.places()
        painter.setPen(LOST)
        painter.drawPolyline(QtGui.QPolygonF(list(places.values())))
        for i, place in places.items():
            point = self.found.curve[i]
            colour = HOLDS if point.holds else LOST
            painter.setPen(colour)
            painter.setBrush(colour if point.holds else QtCore.Qt.NoBrush)
            painter.drawEllipse(place, DOT, DOT)
            if point is self.found.best:
                painter.setBrush(QtCore.Qt.NoBrush)
                painter.drawEllipse(place, 2 * DOT, 2 * DOT)
        painter.end()


class BestSpeedBox(QtGui.QGroupBox):
    """`taken()` is called when the speed was taken over into the operation's tool controller."""

    def __init__(self, obj, taken):
        super().__init__(translate("PatchMill", "Spindle speed"))
        self.obj, self.taken, self.best = obj, taken, None
        self.ask = _button(translate("PatchMill", "Find the best speed"), "FindSpeed", self.look)
        self.take = _button("", "TakeSpeed", self.take_over)
        self.curve, self.said, self.wrong, self.progress = Curve(), plain_label(), Notice(), ProgressBar()
        layout = QtGui.QVBoxLayout(self)
        for widget in (self.ask, self.progress, self.curve, self.said, self.wrong, self.take):
            layout.addWidget(widget)
        self.curve.setVisible(False)
        self.said.setVisible(False)
        self.take.setVisible(False)
        self.work = Background()
        self.work.progressed.connect(self.progress.show_share)
        self.work.finished.connect(self._found)
        self.work.failed.connect(self._failed)

    def look(self):
        """Begins to plan the texture at other speeds, as it is set now; another click begins anew."""
        self.take.setVisible(False)
        try:
            given = self.obj.Proxy.texture_input(self.obj)
        except InputError as error:
            self._failed(error)
            return
        self._say(translate("PatchMill", "Trying other speeds …"))
        self.work.start(lambda progress: _looked(given, progress))

    def _found(self, found):
        self.progress.setVisible(False)
        if found is None:
            return
        self.curve.show_found(found)
        self.best = found.best
        if self.best is None:
            said = translate("PatchMill", "No speed from S{} to S{} holds.")
            self._say(said.format(found.curve[0].rpm, found.curve[-1].rpm))
            return
        said = translate(
            "PatchMill", "S{} takes {}, the phase off by up to {:.1f}°. None that holds is faster."
        )
        self._say(said.format(self.best.rpm, in_words(self.best.seconds), self.best.largest))
        if self.best.rpm == round(self.obj.ToolController.SpindleSpeed):
            return
        free = apply.controller_is_free(self.obj)
        self.take.setText(translate("PatchMill", "Set S{}").format(self.best.rpm))
        self.take.setEnabled(free)
        self.take.setToolTip(
            ""
            if free
            else translate(
                "PatchMill", "Other operations use this tool controller: give this one its own."
            )
        )
        self.take.setVisible(True)

    def take_over(self):
        self.obj.ToolController.SpindleSpeed = float(self.best.rpm)
        self.take.setVisible(False)
        self.taken()

    def _failed(self, error):
        self.progress.setVisible(False)
        self.curve.setVisible(False)
        self._say("", error_text(error))

    def _say(self, text, wrong=""):
        self.said.setText(text)
        self.said.setVisible(bool(text))
        self.wrong.setText(wrong)

    def hideEvent(self, event):
        """The panel closes, or another page is in front."""
        if self.work.busy:
            self._say("")
        self.work.cancel()
        self.progress.setVisible(False)
        super().hideEvent(event)


def _button(text, name, call):
    button = QtGui.QPushButton(text)
    button.setObjectName(name)
    button.setMinimumWidth(30)
    button.clicked.connect(call)
    return button


def _looked(given, progress):
    """BestSpeed of a TextureInput, or None if asked to stop."""
    plan = plan_texture(given, lambda share: progress(PLANNING * share))
    if plan is None:
        return None
    return best_speed.of_plan(plan, progress=lambda share: progress(PLANNING + (1.0 - PLANNING) * share))

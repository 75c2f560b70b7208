"""Plays a tool path: tool, holder and spindle angle along it, its way and the dimples as they are cut, with a
slider and a speed; a check runs beside it, and what it finds is on the slider and in the view.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import time

from _patchmill import NO_DIMPLE, InputError
from patchmill.verify import checks
from PySide import QtCore, QtGui

from patchmill_gui.fields import unit_text
from patchmill_gui.forms.texture_summary import grouped
from patchmill_gui.forms.widgets import guard_editors, translate
from patchmill_gui.panels.check_panel import deepest, verdict
from patchmill_gui.views.own_view import scene_of
from patchmill_gui.views.play_scene import PlayScene
from patchmill_gui.views.timeline import FindingsBar, Timeline
from patchmill_gui.work.work_panel import WorkPanel

SPEEDS = (0.01, 0.1, 1.0, 10.0, 100.0, 1000.0)
FRAME_MS = 40
STEPS = 100000  # of the slider
PLACE_DECIMALS = 3  # of mm


class PlayerPanel(WorkPanel):
    """Task panel. `path` is the ToolPath of the document object `operation`."""

    ICON = "PatchMill_Play"

    def __init__(self, operation, path):
        super().__init__(translate("PatchMill", "Play {}").format(operation.Label), operation)
        self.line = Timeline(path, _seconds(operation))
        self.operation = operation
        self.moment, self.found = 0.0, []
        self.view = PlayScene(path, self.line.tips)
        self.tool = self.view.tool
        self._fill_form()
        self.root = scene_of(operation)
        self.root.addChild(self.view.root)
        self.bring_back = _display_set_aside(operation)
        self.timer = QtCore.QTimer()
        self.timer.timeout.connect(self._frame)
        self.go_to(0.0)
        self._check()

    def _check(self):
        """Starts the check of the path, or says why there is none."""
        try:
            given = checks.check_input(self.operation)
        except InputError as error:
            self.show_error(error)
            return
        path = self.line.path
        self.text.setText(translate("PatchMill", "Checking …"))
        self.bar.begin()
        self.work.start(lambda progress: checks.run_check(given, path=path, progress=progress))

    def _fill_form(self):
        self.slider, self.findings_bar = QtGui.QSlider(QtCore.Qt.Horizontal), FindingsBar()
        self.slider.setRange(0, STEPS)
        self.slider.setObjectName("Moment")
        self.slider.valueChanged.connect(self._slid)
        self.play = QtGui.QPushButton(translate("PatchMill", "Play"))
        self.play.setObjectName("Play")
        self.play.setCheckable(True)
        self.play.toggled.connect(self._toggled)
        self.speed = QtGui.QSlider(QtCore.Qt.Horizontal)
        self.speed.setRange(0, len(SPEEDS) - 1)
        self.speed.setValue(SPEEDS.index(1.0))
        self.speed.setObjectName("Speed")
        self.speed.valueChanged.connect(self._show_speed)
        self.speed_label, self.place = QtGui.QLabel(), QtGui.QLabel()
        self.place.setWordWrap(True)
        self.next = QtGui.QPushButton(translate("PatchMill", "Next finding"))
        self.next.setObjectName("NextFinding")
        self.next.setToolTip(translate("PatchMill", "Goes on to where the check found something next"))
        self.next.clicked.connect(self.go_to_next)
        self.next.hide()
        row = QtGui.QHBoxLayout()
        for widget in (self.play, self.speed, self.speed_label):
            row.addWidget(widget)
        self.layout.addWidget(self.slider)
        self.layout.addWidget(self.findings_bar)
        self.layout.addLayout(row)
        self.layout.addWidget(self.place)
        self.layout.addWidget(self.next)
        guard_editors(self.form)
        self._show_speed()
        self.add_progress()

    def _show_speed(self, _=None):
        self.speed_label.setText("{:g} ×".format(SPEEDS[self.speed.value()]))

    def _slid(self, value):
        self.go_to(self.line.seconds * value / STEPS)

    def _toggled(self, on):
        if on:
            self.began = time.monotonic()
            self.timer.start(FRAME_MS)
        else:
            self.timer.stop()

    def _frame(self):
        """The moment goes on by what the clock says, however long a frame took."""
        now = time.monotonic()
        self.go_to(self.moment + (now - self.began) * SPEEDS[self.speed.value()])
        self.began = now
        if self.moment >= self.line.seconds:
            self.play.setChecked(False)

    def go_to(self, moment):
        """Shows the tool at a moment [s]."""
        self.moment = min(max(0.0, moment), self.line.seconds)
        tip, axis, angle, move = self.line.at(self.moment)
        self.view.show(tip, axis, angle, move)
        self.slider.blockSignals(True)
        self.slider.setValue(int(STEPS * self.moment / self.line.seconds) if self.line.seconds else 0)
        self.slider.blockSignals(False)
        dimple, goal = self.line.dimples[move], ""
        if dimple != NO_DIMPLE:
            goal = translate("PatchMill", ", to dimple {}").format(grouped(int(dimple)))
        self.place.setText(
            translate(
                "PatchMill", "{} of {}\nmove {} of {}{}\nX {}  Y {}  Z {} {}\nspindle {:.0f}°"
            ).format(
                _clock(self.moment),
                _clock(self.line.seconds),
                grouped(move + 1),
                grouped(len(self.line.turns)),
                goal,
                *_in_user_unit(tip),
                math.degrees(angle) % 360.0,
            )
        )

    def go_to_next(self, _=None):
        """The next place that the check found; after the last one the first."""
        later = [moment for moment in self.found if moment > self.moment + 1e-6]
        self.play.setChecked(False)
        self.go_to(later[0] if later else self.found[0])

    def show_result(self, result):
        """What the check found: a CheckResult."""
        self.result = result
        self.bar.hide()
        self.text.setText(verdict(result))
        self.found = [float(moment) for moment in self.line.moments(result.findings)]
        self.findings_bar.show_shares([moment / self.line.seconds for moment in self.found])
        self.view.show_findings(deepest(result))
        self.next.setVisible(bool(self.found))

    def leave(self):
        super().leave()
        self.timer.stop()
        self.root.removeChild(self.view.root)
        self.bring_back()


def _seconds(operation):
    """Of the whole path, where the operation tells it."""
    seconds = getattr(operation, "MachiningTime", 0.0)
    return seconds if seconds > 0.0 else None


def _display_set_aside(operation):
    """Hides what the operation shows, dimples or its whole path: only what has been cut is to be seen.
    Returns what brings it back."""
    scene = getattr(operation.ViewObject.Proxy, "scene", None)
    parts = getattr(scene, "parts", scene)
    return parts.set_aside() if parts is not None else lambda: None


def _in_user_unit(tip):
    """Texts of the coordinates of a place [mm], and their unit."""
    unit, factor = unit_text.user_unit("mm")
    decimals = PLACE_DECIMALS + max(0, round(math.log10(factor)))
    texts = ("%.*f" % (decimals, value / factor) for value in tip)
    return [*(text.replace(".", unit_text.decimal_point()) for text in texts), unit]


def _clock(seconds):
    hours, rest = divmod(int(seconds), 3600)
    return "%d:%02d:%02d" % (hours, *divmod(rest, 60))

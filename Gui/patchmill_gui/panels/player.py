"""Plays a tool path: tool, holder and spindle angle along it, with a slider and a speed.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import time

import numpy as np
from PySide import QtCore, QtGui

from patchmill_gui.forms.texture_summary import grouped
from patchmill_gui.forms.widgets import guard_editors, translate
from patchmill_gui.views.own_view import scene_of
from patchmill_gui.views.tool_node import ToolNode
from patchmill_gui.work.work_panel import ClosePanel

SPEEDS = (0.01, 0.1, 1.0, 10.0, 100.0, 1000.0)
RAPID_MM_S = 100.0  # for moves whose time is the machine's affair
FRAME_MS = 40
STEPS = 100000  # of the slider


class Timeline:
    """A ToolPath by time: where the tool is at a moment [s] from the start."""

    def __init__(self, path):
        self.path = path
        start = np.asarray(path.start)[None]
        self.tips = np.vstack([start, path.tips])
        self.axes = np.vstack([path.axes[:1], path.axes])
        self.turns = path.turns
        lengths = np.linalg.norm(np.diff(self.tips, axis=0), axis=1)
        known = np.isfinite(self.turns)
        seconds = np.where(known, self.turns / path.spindle.speed, lengths / RAPID_MM_S)
        self.ends = np.concatenate([[0.0], np.cumsum(seconds)])
        turned = np.where(known, self.turns, seconds * path.spindle.speed)
        self.turned = np.concatenate([[0.0], np.cumsum(turned)])
        self.dimples = path.dimples

    @property
    def seconds(self):
        return float(self.ends[-1])

    def at(self, moment):
        """(tip, axis, spindle angle [rad], number of the move) at a moment."""
        move = int(np.clip(np.searchsorted(self.ends, moment, side="right") - 1, 0, len(self.turns) - 1))
        span = self.ends[move + 1] - self.ends[move]
        share = min(1.0, (moment - self.ends[move]) / span) if span > 0.0 else 1.0
        tip = (1.0 - share) * self.tips[move] + share * self.tips[move + 1]
        axis = (1.0 - share) * self.axes[move] + share * self.axes[move + 1]
        turned = (1.0 - share) * self.turned[move] + share * self.turned[move + 1]
        angle = self.path.spindle.sign * 2.0 * math.pi * (turned % 1.0)
        return tip, axis / np.linalg.norm(axis), angle, move


class PlayerPanel(ClosePanel):
    """Task panel. `path` is the ToolPath of the document object `operation`."""

    def __init__(self, operation, path):
        super().__init__(translate("PatchMill", "Play"), operation)
        self.line = Timeline(path)
        self.operation = operation
        self.moment = 0.0
        self._fill_form()
        radius = path.tool.radius
        self.tool = ToolNode(radius, path.tool.flutes, path.tool.sections)
        self.root = scene_of(operation)
        self.root.addChild(self.tool.root)
        self.timer = QtCore.QTimer()
        self.timer.timeout.connect(self._frame)
        self.go_to(0.0)

    def _fill_form(self):
        self.slider = QtGui.QSlider(QtCore.Qt.Horizontal)
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
        self.speed.valueChanged.connect(lambda _: self._show_speed())
        self.speed_label, self.text = QtGui.QLabel(), QtGui.QLabel()
        self.text.setWordWrap(True)
        row = QtGui.QHBoxLayout()
        for widget in (self.play, self.speed, self.speed_label):
            row.addWidget(widget)
        self.layout.addWidget(self.slider)
        self.layout.addLayout(row)
        self.layout.addWidget(self.text)
        self.layout.addStretch()
        guard_editors(self.form)
        self._show_speed()

    def _show_speed(self):
        self.speed_label.setText("{:g} ×".format(SPEEDS[self.speed.value()]))

    def _slid(self, value):
        self.go_to(self.line.seconds * value / STEPS)

    def _toggled(self, on):
        if on:
            self.began, self.from_moment = time.monotonic(), self.moment
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
        self.tool.place(tip, axis, self.line.path.tool.radius, angle)
        self.slider.blockSignals(True)
        self.slider.setValue(int(STEPS * self.moment / self.line.seconds) if self.line.seconds else 0)
        self.slider.blockSignals(False)
        dimple = self.line.dimples[move]
        self.text.setText(
            translate(
                "PatchMill", "{} of {}\nmove {} of {}{}\nX {:.3f}  Y {:.3f}  Z {:.3f}\nspindle {:.0f}°"
            ).format(
                _clock(self.moment),
                _clock(self.line.seconds),
                grouped(move + 1),
                grouped(len(self.line.turns)),
                translate("PatchMill", ", to dimple {}").format(grouped(int(dimple))) if dimple >= 0 else "",
                *tip,
                math.degrees(angle) % 360.0,
            )
        )

    def leave(self):
        self.timer.stop()
        self.root.removeChild(self.tool.root)


def _clock(seconds):
    hours, rest = divmod(int(seconds), 3600)
    return "%d:%02d:%02d" % (hours, *divmod(rest, 60))

"""A tool path by time, and the bar that shows where on it a check found something.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math

import numpy as np
from PySide import QtCore, QtGui

RAPID_MM_S = 100.0  # where nothing else tells how long a rapid takes
BAR_HEIGHT, TICK = 10, 3  # pixels
FOUND_COLOUR = "#b71c1c"


class Timeline:
    """A ToolPath by time: where the tool is at a moment [s] from the start. `seconds`: of the whole path as
    the operation tells it; what its timed moves do not take of that is shared by the rapids."""

    def __init__(self, path, seconds=None):
        self.path = path
        start = np.asarray(path.start)[None]
        self.tips = np.vstack([start, path.tips])
        self.axes = np.vstack([path.axes[:1], path.axes])
        self.turns = path.turns
        lengths = np.linalg.norm(np.diff(self.tips, axis=0), axis=1)
        known = np.isfinite(self.turns)
        timed = np.where(known, self.turns / path.spindle.speed, 0.0)
        rapid = np.where(known, 0.0, lengths)
        rest = -1.0 if seconds is None else seconds - timed.sum()
        speed = rapid.sum() / rest if rest > 0.0 and rapid.sum() > 0.0 else RAPID_MM_S
        each = timed + rapid / speed
        self.ends = np.concatenate([[0.0], np.cumsum(each)])
        turned = np.where(known, self.turns, each * path.spindle.speed)
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

    def moments(self, findings):
        """When the moves of Findings of a check end [s], in order, each once."""
        return np.unique(self.ends[[finding.move + 1 for finding in findings]]) if findings else np.zeros(0)


class FindingsBar(QtGui.QWidget):
    """Under a slider: a red tick at each of `shares` of the way."""

    def __init__(self):
        super().__init__()
        self.shares = []
        self.setFixedHeight(BAR_HEIGHT)

    def show_shares(self, shares):
        self.shares = list(shares)
        self.update()

    def paintEvent(self, event):
        painter = QtGui.QPainter(self)
        colour, wide = QtGui.QColor(FOUND_COLOUR), max(1, self.width() - TICK)
        for at in {int(wide * share) for share in self.shares}:
            painter.fillRect(QtCore.QRect(at, 0, TICK, self.height()), colour)
        painter.end()

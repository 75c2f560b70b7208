"""Work off the GUI thread: one job at a time, the newest wins, each can be cancelled.

The work is a function `work(progress)` that calls progress(share) now and then and stops when that returns
False. It runs in a thread of its own; what it gives comes back to the GUI thread as a signal.

Qt's objects must die in the thread that made them, or they take the program with them. So no thread here
holds the last reference to its Background, and Python's collector, which frees cycles in whatever thread it
happens to start in (closed panels among them), is off while one runs.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import gc
import os
import sys
import threading
import time

import _patchmill as core
from PySide import QtCore


NICER = 10  # threads that compute, than those of the GUI and of software rendering


class _Threads:
    """All that are running, seen from the GUI thread: they keep their Background alive, the collector off."""

    def __init__(self):
        self._owners = []
        self._paused = False

    def began(self, owner):
        if not self._owners and gc.isenabled():
            gc.disable()
            self._paused = True
        self._owners.append(owner)

    def ended(self, owner):
        self._owners.remove(owner)
        if self._owners or not self._paused:
            return
        gc.enable()
        self._paused = False


_threads = _Threads()


def _give_way():
    """Puts the calling thread behind those of the GUI and of the renderer, where threads have a niceness of
    their own. Threads that it starts, such as those of a parallel loop, inherit it."""
    if sys.platform == "linux":
        gui = os.getpriority(os.PRIO_PROCESS, os.getpid())
        os.setpriority(os.PRIO_PROCESS, threading.get_native_id(), min(gui + NICER, 19))


class Background(QtCore.QObject):
    """Signals, all in the GUI thread: `progressed(share, seconds left)`, `finished(result)`,
    `failed(exception)`. A cancelled job gives none of the last two."""

    progressed = QtCore.Signal(float, float)
    finished = QtCore.Signal(object)
    failed = QtCore.Signal(object)
    _arrived = QtCore.Signal(int, str, object)

    def __init__(self, brief=False, parent=None):
        """`brief`: what it runs is over soon and may take all cores."""
        super().__init__(parent)
        self._spare = 0 if brief else 1
        self._number = 0
        self._running = 0
        self._arrived.connect(self._deliver, QtCore.Qt.QueuedConnection)

    def start(self, work):
        """Cancels what is running and starts `work`."""
        self._number += 1
        self._running = self._number
        _threads.began(self)
        thread = threading.Thread(target=self._run, args=(work, self._number), daemon=True)
        thread.start()

    def cancel(self):
        """Whatever is running will stop at its next look, and say nothing."""
        self._number += 1
        self._running = 0

    @property
    def busy(self):
        return self._running != 0

    def _run(self, work, number):
        _give_way()
        began = last = time.monotonic()

        def progress(share):
            nonlocal last
            now = time.monotonic()
            if now - last > 0.1:
                last = now
                left = (now - began) * (1.0 - share) / share if share > 0.0 else 0.0
                self._arrived.emit(number, "progressed", (share, left))
            return number == self._number

        try:
            # a core stays free for the GUI: without it its thread would wait for its turn
            limit = core.ThreadLimit(max(1, (os.cpu_count() or 2) - self._spare))
            result = None
            with core.Watch(progress) as asked:  # by all that is called, whether or not it is handed on
                result = work(asked)
            del limit
        except Exception as error:  # delivered to whoever asked, in the GUI thread
            self._arrived.emit(number, "failed", error)
        else:
            self._arrived.emit(number, "finished", result)

    def _deliver(self, number, what, value):
        if what != "progressed":
            _threads.ended(self)
        if number != self._number:
            return
        if what == "progressed":
            self.progressed.emit(*value)
            return
        self._running = 0
        getattr(self, what).emit(value)

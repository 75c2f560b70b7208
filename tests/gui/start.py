"""Runs in FreeCAD when its window is up: the script named in the environment, and ends FreeCAD with an honest
status. A modal box that nobody expects would stop everything: a timer presses its first button, and says so.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import runpy
import sys
import traceback

from PySide import QtCore, QtGui

boxes = []  # texts of the message boxes that were closed


def close_modal():
    box = QtGui.QApplication.activeModalWidget()
    if QtGui.QApplication.instance().property("answered"):
        return  # a test waits for a box that it answers itself
    if isinstance(box, QtGui.QMessageBox):
        boxes.append(box.text())
        print("message box: %s" % box.text(), flush=True)
        box.buttons()[0].click()
    elif box is not None and _seen_long(box):
        boxes.append(box.windowTitle())
        print("modal window: %s" % box.windowTitle(), flush=True)
        box.reject() if hasattr(box, "reject") else box.close()


_seen = [None, 0]


def _seen_long(box):
    """Whether a dialog has been there for three seconds: a test answers its own sooner, or says that it is
    being answered by hand (hands.give_keyboard)."""
    _seen[:] = [box, _seen[1] + 1] if _seen[0] is box else [box, 1]
    return _seen[1] > 10 and not box.property("answered")


def run():
    root = os.environ["PATCHMILL_GUI_ROOT"]
    sys.path.insert(0, os.path.join(root, "tests", "gui"))
    script = os.environ["PATCHMILL_GUI_SCRIPT"]
    sys.argv = [script] + os.environ["PATCHMILL_GUI_ARGUMENTS"].split()
    status = 1
    try:
        # not as __main__: that name is FreeCAD's own, which runs its commands there
        status = runpy.run_path(script, run_name="gui_script")["main"]()
    except SystemExit as end:
        status = end.code if isinstance(end.code, int) else int(end.code is not None)
    except BaseException:
        traceback.print_exc()
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)


closer = QtCore.QTimer()
closer.timeout.connect(close_modal)
closer.start(300)
QtCore.QTimer.singleShot(1500, run)

"""What FreeCAD asks of the object that a dressup of its own is put on, be it an operation or a modifier: its
tool controller (LeadInOut) and whether it is switched on (RampEntry). A modifier has both from what it is on;
its time, which FreeCAD adds up for the job, is its own.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from patchmill.freecad import host
from patchmill.freecad.translate import QT_TRANSLATE_NOOP
from patchmill.machine import machining_time

PROPERTIES = [
    (
        "App::PropertyLink",
        "ToolController",
        QT_TRANSLATE_NOOP("App::Property", "Tool controller of the operation that is modified"),
    ),
    (
        "App::PropertyString",
        "CycleTime",
        QT_TRANSLATE_NOOP("App::Property", "Time that FreeCAD counts for the job"),
    ),
    (
        "App::PropertyBool",
        "Active",
        QT_TRANSLATE_NOOP("App::Property", "Whether the operation that is modified is switched on"),
    ),
]
HIDDEN = 2  # FreeCAD's editor mode


def add(obj):
    """Adds the properties that `obj` lacks, and gives them what they have below it."""
    for kind, name, tip in PROPERTIES:
        if not hasattr(obj, name):
            obj.addProperty(kind, name, "Base", tip)
        obj.setEditorMode(name, HIDDEN)
    follow(obj)


def follow(obj):
    """Gives `obj` the tool controller and the state of what it is on."""
    if obj.Base is None:
        return
    wanted = {"ToolController": _controller_of(obj.Base), "Active": bool(host.is_active(obj.Base))}
    for name, value in wanted.items():
        if getattr(obj, name) != value:
            setattr(obj, name, value)


def tell_cycle_time(obj, seconds):
    """Has FreeCAD count a time [s] for the job in the place of the time of what is modified."""
    obj.CycleTime = machining_time.clock(seconds)
    job = host.PathUtils.findParentJob(obj)
    if job is not None:
        job.Proxy.getCycleTime()


def pass_on(obj, name):
    """Whoever switches `obj` on or off means the operation that is modified."""
    base = getattr(obj, "Base", None)
    if name != "Active" or base is None or "Restore" in obj.State:
        return
    if hasattr(base, "Active") and base.Active != obj.Active:
        base.Active = obj.Active


def _controller_of(base):
    """The tool controller of an operation or of the one under dressups; None if there is none."""
    if hasattr(base, "ToolController"):
        return base.ToolController
    under = getattr(base, "Base", None)
    return _controller_of(under) if hasattr(under, "Path") else None

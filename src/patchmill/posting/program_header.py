"""The lines at the top of a program that tell a machinist what it is and what has to be set: part, tool,
machine, strategy, turns per dimple, time, where the phase is counted from.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from patchmill.freecad import host
from patchmill.freecad.kinds import COPY_MILLING, DCM, kind_of
from patchmill.machine import machines, machining_time

TITLES = {COPY_MILLING: "Copy milling", DCM: "DCM modifier"}


def textures(objects):
    """The texture operations among a post's objects that have a plan."""
    return [o for o in objects if getattr(getattr(o, "Proxy", None), "planned", None) is not None]


def machine_of(objects):
    """The machines.Machine of the first texture that names one, else of the first other operation or modifier
    that does."""
    for op in textures(objects):
        if op.Proxy.planned.machine is not None:
            return op.Proxy.planned.machine
    names = [getattr(o, "Machine", "") for o in objects if hasattr(o, "Proxy")]
    return next((machines.load(name) for name in names if isinstance(name, str) and name), None)


def stock_corners(objects):
    """Lowest and highest corner [mm] of the stock of the job that one of a post's objects belongs to; None if
    there is none."""
    for obj in objects:
        job = host.PathUtils.findParentJob(obj) if hasattr(obj, "Proxy") else None
        box = getattr(getattr(getattr(job, "Stock", None), "Shape", None), "BoundBox", None)
        if box is not None and box.isValid():
            return (box.XMin, box.YMin, box.ZMin), (box.XMax, box.YMax, box.ZMax)
    return None


def lines(objects, controller):
    """Header lines for a program of `objects` on `controller`."""
    out = ["PatchMill for %s" % controller]
    for op in textures(objects):
        out += _texture(op)
    for op in objects:
        if kind_of(op) in TITLES:
            out.append("%s: %s" % (TITLES[kind_of(op)], op.Label))
            out.append("Time: %s" % machining_time.in_words(op.MachiningTime))
    machine = machine_of(objects)
    if machine is not None:
        out.append("Machine: %s" % machine.data["name"])
        for line in machine.controller["operator"]:
            out.append("Operator: %s" % line)
    return out


def _texture(op):
    plan = op.Proxy.planned
    given, statistics = plan.input, plan.path.statistics()
    spindle = given.spindle
    machine = plan.machine
    turns = statistics["cut_turns"] / max(1, statistics["dimples"])
    yield "Part: %s" % op.Document.Label
    yield "Texture: %s, %d dimples" % (op.Label, statistics["dimples"])
    if given.first_patch > 1:
        yield "Begins with patch %d of %d" % (given.first_patch, plan.patches)
    if given.last_patch not in (0, plan.patches):
        yield "Ends with patch %d of %d" % (given.last_patch, plan.patches)
    yield "Tool: ball end mill D%g, %d flutes, S%g %s" % (
        2.0 * given.tool.radius,
        given.tool.flutes,
        60.0 * spindle.speed,
        spindle.sense,
    )
    yield "Strategy: %s, %.2f spindle turns per dimple" % (given.strategy, turns)
    yield "Time: %s" % machining_time.in_words(plan.seconds)
    start = machine.data["start_phase_degrees"] if machine else 0.0
    yield "Phase zero: flute 1 towards X+ at the spindle's index, start phase %.2f degrees" % start
    yield "Operator: work zero as in the model, feed override 100 %, spindle override 100 %"
    posture = getattr(plan, "posture", None)
    if posture is not None:
        yield "Operator: tool length to the %s, %s" % (
            posture.reference,
            "TCP is used" if posture.form.tcp else "made for this machine's pivots and this work zero",
        )

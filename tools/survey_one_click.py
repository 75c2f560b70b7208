"""The table of tools/survey-one-click: a row for each part and machine, in Markdown.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import sys
import time
from dataclasses import replace

import _patchmill as core
import FreeCAD
import one_click
import other_parts
from _patchmill import InputError
from patchmill.advice import apply, choice
from patchmill.textures.order import rows
from patchmill.verify import best_speed

MACHINES = ("linuxcnc-mill", "table-table-ac")
COLUMNS = (
    "part", "machine", "one click: state, good, quality", "fix", "after it", "dimples", "values", "min",
    "times the best", "cpu s",
)  # fmt: skip
SHORT = {"Spindle-locked": "locked", "Constant feed, fitted stops": "fitted", "Feed per move": "feed"}
SPEEDS = 3  # the highest ones that are chosen from, beside the first and the one that was chosen
LOOKED_AT = 150.0  # mm² of a large texture, that are simulated in one piece


def said(operation):
    """(state, text of what the head says and what the whole texture is when it is simulated, minutes)."""
    state, found, minutes = one_click.state_of(operation)
    if found is None:
        return state, "%s, none" % state, minutes
    whole = found.whole if found.whole is not None else one_click.whole_quality(operation, LOOKED_AT)
    return state, "%s, %.0f %%, %.2f" % (state, 100 * found.good_fraction, whole), minutes


def values(operation):
    return "%s, %s, S%.0f" % (
        SHORT.get(operation.Strategy, operation.Strategy),
        operation.Order,
        operation.ToolController.SpindleSpeed,
    )


def times_best(operation, start_speed):
    """Time over that of the best point that holds, of both orders and the highest speeds."""
    plan = operation.Proxy.planned
    if plan is None:
        return "-"
    given = plan.asked
    ladder = choice.speeds(given_at(given, start_speed), plan.machine)[-SPEEDS:]
    speeds = [round(start_speed), round(60.0 * given.spindle.speed), *ladder]
    found = best_speed.of_plan(plan, speeds, (rows.HELIX, rows.ROWS))
    if found.best is None:
        return "-"
    return "%.2f" % (plan.path.statistics()["timed_seconds"] / found.best.seconds)


def given_at(given, rpm):
    """A TextureInput with another spindle speed."""
    return replace(given, spindle=core.Spindle(rpm / 60.0, given.spindle.sense))


def described(remedy):
    extra = [
        text
        for name, text in (("spacing", "finer"), ("minimum_tilt", "leave out"), ("mapping", "lay"))
        if name in remedy.fields and remedy.kind != text
    ]
    angle = " %.0f°" % remedy.angle if remedy.angle else ""
    return ", ".join([remedy.kind + angle, *extra])


def row(name, machine):
    shape, face = other_parts.PARTS[name]()
    began = time.process_time()
    operation = one_click.texture(shape, face, machine)
    start_speed = operation.ToolController.SpindleSpeed
    fields = {}
    try:
        fields = one_click.choose_for(operation).fields
    except InputError:
        pass  # the head says so, and the remedies are looked for
    state, first, minutes = said(operation)
    fix, after = "", ""
    if state != "good":
        found = one_click.remedies_of(operation, fields)
        fix = "none"
        if found:
            apply.take(operation, found[0])
            fix = described(found[0])
            state, after, minutes = said(operation)
    spent = time.process_time() - began
    plan = operation.Proxy.planned
    cut = plan.counts["cut"] if plan else 0
    cells = (
        name, machine, first, fix, after, str(cut), values(operation), "%.1f" % minutes,
        times_best(operation, start_speed), "%.0f" % spent,
    )  # fmt: skip
    print("| %s |" % " | ".join(cells), flush=True)
    FreeCAD.closeDocument(operation.Document.Name)


print("| %s |\n|%s" % (" | ".join(COLUMNS), " --- |" * len(COLUMNS)), flush=True)
wanted = [a for a in sys.argv[1:] if a not in MACHINES]
machines = [a for a in sys.argv[1:] if a in MACHINES] or MACHINES
for part in wanted or other_parts.TABLE:
    for key in machines:
        row(part, key)

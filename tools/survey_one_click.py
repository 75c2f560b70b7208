"""The table of tools/survey-one-click: a row for each part and machine.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import sys
import time

import FreeCAD
import one_click
import quality_parts
from _patchmill import InputError

MACHINES = ("linuxcnc-mill", "table-table-ac")
HEADING = "%-23s %-14s state good worst whole minutes | values                      | after the first fix"
SHORT = {"Spindle-locked": "locked", "Constant feed, fitted stops": "fitted", "Feed per move": "feed"}


def said(operation):
    """What the head says, and what the whole texture is when it is simulated."""
    state, found, minutes = one_click.state_of(operation)
    if found is None:
        return state, "%-5s    -    -     -       -" % state
    whole = one_click.whole_quality(operation)
    return state, "%-5s %3.0f%% %5.2f %5.2f %7.1f" % (
        state,
        100 * found.good_fraction,
        found.quality,
        whole,
        minutes,
    )


def values(operation):
    return "%s, %s, S%.0f, F%.0f" % (
        SHORT.get(operation.Strategy, operation.Strategy),
        operation.Order,
        operation.ToolController.SpindleSpeed,
        60.0 * operation.ToolController.HorizFeed.Value,
    )


def row(name, machine):
    shape = quality_parts.PARTS[name]()
    began = time.monotonic()
    operation = one_click.texture(shape, quality_parts.top_face(shape), machine)
    try:
        one_click.choose_for(operation)
    except InputError:
        pass  # the head says so, and the remedies are looked for
    state, first = said(operation)
    text, after = values(operation), ""
    if state != "good":
        kind = one_click.fix(operation)
        after = "%s: %s, %s" % (kind, said(operation)[1], values(operation)) if kind else "no remedy"
    print(
        "%-23s %-14s %s | %-27s | %s | %.0f s"
        % (name, machine, first, text, after, time.monotonic() - began),
        flush=True,
    )
    FreeCAD.closeDocument(operation.Document.Name)


print(HEADING % ("part", "machine"))
for wanted in sys.argv[1:] or quality_parts.PARTS:
    for machine in MACHINES:
        row(wanted, machine)

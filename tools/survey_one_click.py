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


def said(state, found, minutes):
    if found is None:
        return "%-5s %4s %4s %7s" % (state, "-", "-", "-")
    return "%-5s %3.0f%% %4.2f %7.1f" % (state, 100 * found.good_fraction, found.quality, minutes)


def row(name, machine):
    shape = quality_parts.PARTS[name]()
    began = time.monotonic()
    operation = one_click.texture(shape, quality_parts.top_face(shape), machine)
    try:
        one_click.choose_for(operation)
    except InputError:
        pass  # the head says so, and the remedies are looked for
    first = one_click.state_of(operation)
    text, after = operation.Strategy, ""
    if first[0] != "good":
        kind = one_click.fix(operation)
        after = "%s: %s" % (kind or "no remedy", said(*one_click.state_of(operation)) if kind else "")
    print(
        "%-24s %-14s %s | %-28s | %s | %.0f s"
        % (name, machine, said(*first), text, after, time.monotonic() - began),
        flush=True,
    )
    FreeCAD.closeDocument(operation.Document.Name)


print("part                     machine        state good worst minutes | strategy | after the first fix")
for wanted in sys.argv[1:] or quality_parts.PARTS:
    for machine in MACHINES:
        row(wanted, machine)

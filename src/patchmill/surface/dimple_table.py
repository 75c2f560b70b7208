"""A table of dimples, planned and found, as CSV: for spreadsheets, and for comparing with what an instrument
finds.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math

import _patchmill as core

from patchmill.system import files

COLUMNS = (
    "dimple", "state", "planned_x", "planned_y", "found_x", "found_y", "moved", "depth", "diameter", "volume",
    "at_edge",
)  # fmt: skip


def save(filename, simulated):
    """Writes the table of a SimulatedTexture, names in the first line. Raises InputError naming filename."""
    lines = [",".join(COLUMNS)] + [",".join(_word(value) for value in row) for row in rows(simulated)]
    files.write(filename, "\n".join(lines) + "\n")


def rows(simulated):
    """Rows of a SimulatedTexture's table: the planned dimples, then the marks that nobody planned."""
    plan, found = simulated.plan, simulated.found
    names = core.state_names()
    mark_of = dict(zip(found["dimple"].tolist(), zip(found["found"].tolist(), found["moved"].tolist())))
    for dimple, (place, state) in enumerate(zip(plan.places().tolist(), plan.dimples.states.tolist())):
        mark, moved = mark_of.get(dimple, (None, (math.nan, math.nan)))
        said = names[state] if state else "not simulated" if mark is None else "found"
        if mark is not None and mark < 0:
            mark, said = None, "missing"
        measured = _measured(found, mark)
        yield (dimple, said, *place, *measured[:2], math.hypot(*moved), *measured[2:])
    for mark in found["extra"].tolist():
        measured = _measured(found, mark)
        yield (None, "not planned", None, None, *measured[:2], None, *measured[2:])


def _measured(found, mark):
    """x, y, depth, diameter, volume and at_edge of a mark; empty if there is none."""
    if mark is None:
        return (None,) * 6
    depth, diameter = float(found["depths"][mark]), float(found["diameters"][mark])
    volume = math.pi * depth * (3.0 * diameter**2 / 4.0 + depth**2) / 6.0
    return (*found["places"][mark].tolist(), depth, diameter, volume, int(found["at_edge"][mark]))


def _word(value):
    """A cell of a CSV table; empty if there is nothing to say."""
    if value is None or (isinstance(value, float) and not math.isfinite(value)):
        return ""
    return "%.9g" % value if isinstance(value, float) else str(value)

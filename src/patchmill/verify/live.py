"""Live copy milling: moves made while the tool cuts, with conditions that may change on the way (Kobayashi &
Shirase 2014, section 2; docs/copy-milling.md).

    session = patchmill.live.start(op, voxel_size=1.0, low=400 / 60, high=800 / 60)  # op: a CopyMilling
    while not session.done:
        for line in patchmill.live.lines(session.next(0.5)):
            ...                                           # to the controller, by MDI or as a stream
        session.change(axial_depth=1.0, high=10.0)        # from the next batch on, whenever wanted

`lines` needs no FreeCAD, so that it can run beside the controller.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math

import _patchmill as core

SHORTEST = 1e-6  # mm


def start(operation, voxel_size, low, high, memory_limit=4096.0, materials=()):
    """A _patchmill.LiveSession over a CopyMilling operation in scanning lines: its tool, depths, tolerance,
    stock and part; `voxel_size` in mm, V_Lo and V_Hi in mm/s, 0 < low <= high, `memory_limit` in MiB;
    `materials` as the lines of a DressupDCM's. Raises InputError naming the property."""
    from patchmill.operations import copy_milling
    from patchmill.voxels import removal_model
    from patchmill.voxels.materials import of_lines

    if not isinstance(getattr(operation, "Proxy", None), copy_milling.ObjectCopyMilling):
        label = getattr(operation, "Label", repr(operation))
        raise core.InputError("Operation", label, "give a CopyMilling operation.")
    given = copy_milling.input_of(operation)
    options, part = copy_milling.live_options(given)
    voxels = removal_model.ModelInput(
        given.stock,
        given.model,
        voxel_size,
        max(0.01, given.tolerance),
        memory_limit,
        False,
        materials=of_lines(materials, operation.Document, given.stock),
    )
    model = removal_model.make(voxels)
    return core.LiveSession(part, model.grid, options, low, high, model.materials, model.factors)


def lines(batch):
    """G-code for a batch of a session, a line for each move: G0, or G1 with F in mm/min. In G21 G90 G94."""
    before = batch.start
    for tip, kind, turns in zip(batch.tips, batch.kinds, batch.turns):
        length = math.dist(tip, before)
        before = tip
        words = "X%.4f Y%.4f Z%.4f" % tuple(tip)
        if kind == core.MoveKind.RAPID:
            yield "G0 " + words
        elif length > SHORTEST:
            yield "G1 %s F%.3f" % (words, 60.0 * length * batch.spindle.speed / turns)

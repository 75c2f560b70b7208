"""CalibrationPatch: one square patch in which each dimple is asked for a step later than the one before, so
that the machine's unknown start phase is met once (Xu & Sasahara 2016, section 3.3; docs/calibration.md).

    op = patchmill.CalibrationPatch.Create("Calibration", parentJob=job)
    op.Base, op.Machine = [(job.Model.Group[0], ["Face1"])], "linuxcnc-mill"
    ... mill it, find the number of the best dimple under the loupe ...
    patchmill.CalibrationPatch.store(op, best_dimple)

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from math import degrees, radians

import _patchmill as core
from _patchmill import InputError

from patchmill.freecad import host
from patchmill.machine import calibrated, machines
from patchmill.operations.base import create, setup_properties
from patchmill.operations.texture_operation import ObjectTexture


class ObjectCalibrationPatch(ObjectTexture):
    """See texture_operation.ObjectTexture. The patch is as large as the phase step needs."""

    __module__ = "patchmill.calibration_patch"  # what documents save

    SURFACE = "Curved"
    CALIBRATING = True

    def opSetDefaultValues(self, obj, job):
        super().opSetDefaultValues(obj, job)
        obj.PhaseStep = 1.0
        obj.PatchesX = obj.PatchesY = 1

    def texture_input(self, obj):
        given = super().texture_input(obj)
        given.patch_shape, given.patches_x, given.patches_y = "Square", 1, 1
        given.patch_side = core.calibration_side(_period(given), radians(given.phase_step))
        return given


def _period(given):
    rule = core.PhaseRule(given.same_flute, given.extra_turns, 0.0)
    return core.phase_period(given.tool.flutes, rule)


def store(obj, best_dimple):
    """Stores the start phase that the best dimple's number, from 0 along the helix, tells, with the
    operation's machine, and for which controller, S and K it holds (machine/calibrated). Returns it
    in degrees. Raises InputError naming Machine or BestDimple."""
    if not obj.Machine:
        raise InputError("Machine", "''", "name the machine on which the patch was milled.")
    given = obj.Proxy.texture_input(obj)
    if best_dimple >= given.patch_side**2:
        raise InputError("BestDimple", best_dimple, "the patch has %d." % given.patch_side**2)
    found = degrees(core.start_phase(best_dimple, radians(given.phase_step), _period(given)))
    machine = machines.load(obj.Machine)
    conditions = calibrated.conditions(machine.data, given.spindle, given.spacing, given.tool.flutes)
    machines.store_start_phase(obj.Machine, found, conditions)
    return found


def SetupProperties():
    """Names of the properties that a job's setup sheet may hold defaults for."""
    return setup_properties(ObjectCalibrationPatch)


def Create(name, obj=None, parentJob=None):
    """A new CalibrationPatch in the active document; `parentJob` is the Job it goes into."""
    return create(ObjectCalibrationPatch, name, obj, parentJob)


host.register_operation("CalibrationPatch", Create, SetupProperties)

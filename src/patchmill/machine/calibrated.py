"""Under which conditions a machine's start phase was found, and whether they are those of a plan.

A start phase is the machine's and the tool's own: how far flute 1 is from X+ at the spindle's index. What a
program adds to it - the turns from the index to its first dimple, and those that getting to speed costs where
the controller counts a lock from there - is planned (_patchmill.own_start_phase), so a start phase holds for
every texture, S and K. `lock_origin` of the machine file says from where the controller counts: "at speed"
(LinuxCNC up to now) or "index" (Siemens; LinuxCNC as its pull request 4453 would have it). A version that
counts otherwise makes the number void, so a machine file whose controller is not the one of its calibration
is refused.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from _patchmill import InputError

AT_SPEED, INDEX = ORIGINS = ("at speed", "index")


def conditions(data, spindle, spacing, flutes):
    """What is stored beside a start phase: the controller, S and K of the patch it was found with, and from
    where it is counted."""
    return {
        "controller": version(data),
        "spindle_rpm": 60.0 * spindle.speed,
        "pitch_mm": spacing * flutes,
        "counted_from": INDEX,
    }


def version(data):
    """The controller of a machine file's data, with its version; '' where the file does not say."""
    return data.get("controller_version", "")


def from_index(data):
    """Whether the controller of a machine file's data counts a lock's turns from the spindle's index."""
    return data.get("lock_origin", AT_SPEED) == INDEX


def require(machine):
    """Raises InputError naming Machine where the start phase was found with another controller, or was
    counted from where a program's lock began and not from the spindle's index. A start phase that nobody
    calibrated here says nothing of its conditions, and passes."""
    found = machine.data.get("calibration")
    if not found or not machine.start_phase:
        return
    now = version(machine.data)
    if found["controller"] != now:
        said = "its start phase was found with the controller '%s', and it has '%s'"
        said %= found["controller"], now
    elif found.get("counted_from") != INDEX:
        said = "its start phase was found by a version that counted it anew in each program"
    else:
        return
    raise InputError("Machine", machine.key, said + ": mill a calibration patch anew.")

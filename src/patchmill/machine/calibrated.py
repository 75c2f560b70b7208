"""Under which conditions a machine's start phase was found, and whether they are those of a plan.

A lock is counted from where the axis is at speed, on LinuxCNC up to now: the way to get there makes the phase
later by
    S^2 K / (2 a)   turns,   S turns per second, K mm per turn, a mm/s^2,
so a start phase holds for one S and K. Controllers that count from the index itself (Siemens; LinuxCNC as
its pull request 4453 would have it) have no such lag: `lock_origin` of the machine file says which. A version
that counts otherwise makes the number void, so a machine file whose controller is not the one of its
calibration is refused.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from _patchmill import InputError

AT_SPEED, INDEX = ORIGINS = ("at speed", "index")
MOST_OFF = 3.0  # degrees: the phase error, rms, up to which a plan is said to hold


def conditions(data, spindle, spacing, flutes):
    """What is stored beside a start phase: the controller, S and K of the patch it was found with."""
    return {
        "controller": version(data),
        "spindle_rpm": 60.0 * spindle.speed,
        "pitch_mm": spacing * flutes,
    }


def version(data):
    """The controller of a machine file's data, with its version; '' where the file does not say."""
    return data.get("controller_version", "")


def lag(data, rpm, pitch):
    """By how much the lock's origin is later than the index [degrees]."""
    if data.get("lock_origin", AT_SPEED) == INDEX:
        return 0.0
    turns_per_second = rpm / 60.0
    acceleration = data["linear_axes"]["acceleration_mm_s2"]
    return 360.0 * turns_per_second**2 * pitch / (2.0 * acceleration)


def require(machine, spindle, spacing, flutes):
    """Raises InputError naming Machine where the start phase was found with another controller, SpindleSpeed
    where it is off by more than MOST_OFF degrees at this S and K. A start phase that nobody calibrated here
    says nothing of its conditions, and passes."""
    found = machine.data.get("calibration")
    if not found or not machine.start_phase:
        return
    now = conditions(machine.data, spindle, spacing, flutes)
    if found["controller"] != now["controller"]:
        raise InputError(
            "Machine",
            machine.key,
            "its start phase was found with the controller '%s', and it has '%s': mill a calibration patch"
            " anew."
            % (found["controller"], now["controller"]),
        )
    before = lag(machine.data, found["spindle_rpm"], found["pitch_mm"])
    off = lag(machine.data, now["spindle_rpm"], now["pitch_mm"]) - before
    if abs(off) > MOST_OFF:
        raise InputError(
            "SpindleSpeed",
            "%g rpm" % now["spindle_rpm"],
            "the start phase of %s was found at S%g and %g mm a turn; here it is %+.0f degrees off: mill a"
            " calibration patch at this speed." % (machine.key, found["spindle_rpm"], found["pitch_mm"], off),
        )

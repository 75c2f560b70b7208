"""A machine file's data from a LinuxCNC configuration: limits, velocities and accelerations of its axes, its
kinematics, and whether its spindle has an encoder that moves can follow (G33).

    found = read("mill.ini")
    machines.save("my-mill", found.data)
    print("\\n".join(found.remarks))       # what the configuration does not say, and what was taken instead

Kinematics: trivkins on three axes; xyzac-trt-kins and xyzbc-trt-kins, whose tilting axis lies by y-offset or
x-offset, and by z-offset, beside the rotary point (their manual pages, section 9). Others are refused.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import dataclass, field

from _patchmill import InputError

from patchmill.machine.linuxcnc import configuration

INCH = 25.4
LENGTHS = {"mm": 1.0, "metric": 1.0, "in": INCH, "inch": INCH, "imperial": INCH}
ANGLES = {"deg": 1.0, "degree": 1.0, "rad": 57.29577951308232, "radian": 57.29577951308232, "grad": 0.9}
TABLES = {"xyzac-trt-kins": ("A", (1, 0, 0), "y-offset"), "xyzbc-trt-kins": ("B", (0, 1, 0), "x-offset")}
DECIMALS = 4  # of a program for LinuxCNC, as in the machine files that come with PatchMill
LOWEST_JERK = 1.0  # below it LinuxCNC plans without jerk limits whatever PLANNER_TYPE says
ENCODER = (
    ("spindle.0.revs", "motion.spindle-revs"),
    ("spindle.0.index-enable", "motion.spindle-index-enable"),
)


@dataclass
class Imported:
    """`data` of a machine file; `remarks`: whole sentences that the user should read."""

    data: dict
    remarks: list = field(default_factory=list)


def read(filename):
    """Imported from an .ini file. Raises InputError naming the entry that is missing or not understood."""
    found = configuration.read(filename)
    words = found.text("KINS", "KINEMATICS", "trivkins").split()
    if not words or (words[0] != "trivkins" and words[0] not in TABLES):
        remedy = "it can be one of trivkins, %s: take a machine file of that kind and change it."
        raise InputError("[KINS]KINEMATICS", " ".join(words) or "''", remedy % ", ".join(TABLES))
    return _Reader(found, words).machine()


class _Reader:
    """`words`: of KINEMATICS, its module first."""

    def __init__(self, found, words):
        self.found, self.module, self.options = found, words[0], words[1:]
        self.length = self._unit("LINEAR_UNITS", LENGTHS)
        self.angle = self._unit("ANGULAR_UNITS", ANGLES)
        self.remarks: list[str] = []

    def machine(self):
        found = self.found
        period = found.number("EMCMOT", "SERVO_PERIOD")
        if period is None:
            self.remarks.append("[EMCMOT]SERVO_PERIOD is not given: 1 ms was taken, as LinuxCNC does.")
        data = {
            "format": "patchmill-machine",
            "version": 1,
            "name": found.text("EMC", "MACHINE") or "LinuxCNC machine",
            "axes": "XYZ",
            "spindle_lock": self._has_encoder(),
            "decimals": DECIMALS,
            "servo_period_s": 1e-3 if period is None else 1e-9 * period,
            "path_tolerance_mm": 0.0,
            "linear_axes": self._linear(),
            "start_phase_degrees": 0.0,
            "controller": {"dialect": "linuxcnc", "tcp": False},
            "lock_origin": "at speed",
        }
        if self.module in TABLES:
            data.update(self._table(), axes="XYZ%sC" % TABLES[self.module][0])
        else:
            self._say_what_turns()
        self.remarks.append("The start phase is 0°: mill a calibration patch to find it.")
        return Imported(data, self.remarks)

    def _unit(self, name, known):
        text = self.found.text("TRAJ", name, next(iter(known))).lower()
        if text in known:
            return known[text]
        raise InputError("[TRAJ]" + name, text, "give one of: %s." % ", ".join(known))

    def _letters(self):
        """The axis of each joint."""
        for option in self.options:
            if option.lower().startswith("coordinates="):
                return option.partition("=")[2].upper()
        said = "".join(self.found.text("TRAJ", "COORDINATES", "XYZ").split()).upper()
        return said or "XYZ"

    def _joints(self, letter):
        return ["JOINT_%d" % n for n, each in enumerate(self._letters()) if each == letter]

    def _smallest(self, name, letter, factor):
        """The smallest value of an entry among an axis and its joints. Raises InputError if none gives it."""
        places = ["AXIS_" + letter, *self._joints(letter)]
        values = [v for v in (self.found.number(place, name) for place in places) if v is not None]
        if not values:
            raise InputError("[AXIS_%s]%s" % (letter, name), "missing", "give it.")
        return factor * min(values)

    def _of_path(self, name, smallest):
        """`smallest`, or the path's own limit if that is smaller."""
        value = self.found.number("TRAJ", name)
        return smallest if value is None else min(smallest, self.length * value)

    def _linear(self):
        limits = {}
        kinds = {"MAX_VELOCITY": "mm/s", "MAX_ACCELERATION": "mm/s²"}
        lowest = {}
        for name, unit in kinds.items():
            each = {letter: self._smallest(name, letter, self.length) for letter in "XYZ"}
            lowest[name] = min(each.values())
            if max(each.values()) > lowest[name]:
                said = ", ".join("%s %g" % pair for pair in each.items())
                self.remarks.append("%s differs (%s %s): the smallest was taken." % (name, said, unit))
        for letter in "XYZ":
            pair = self._limits(letter, self.length)
            if pair:
                limits[letter] = pair
        jerk = None
        if self.found.number("TRAJ", "PLANNER_TYPE") == 1.0:
            value = self.found.number("TRAJ", "MAX_LINEAR_JERK") or 0.0
            jerk = self.length * value if value >= LOWEST_JERK else None
        return {
            "velocity_mm_s": self._of_path("MAX_LINEAR_VELOCITY", lowest["MAX_VELOCITY"]),
            "acceleration_mm_s2": self._of_path("MAX_LINEAR_ACCELERATION", lowest["MAX_ACCELERATION"]),
            "jerk_mm_s3": jerk,
            "limits_mm": limits,
        }

    def _limits(self, letter, factor):
        """[low, high] of an axis in machine coordinates, or None. With a turning table, those of the joint:
        the axis's are in the frame of the work."""
        joints = self._joints(letter)
        places = joints if self.module in TABLES else ["AXIS_" + letter, *joints]
        low = [v for v in (self.found.number(place, "MIN_LIMIT") for place in places) if v is not None]
        high = [v for v in (self.found.number(place, "MAX_LIMIT") for place in places) if v is not None]
        return [factor * max(low), factor * min(high)] if low and high else None

    def _has_encoder(self):
        found = all(any(map(self.found.signal_of, names)) for names in ENCODER)
        if not found:
            unread = ", ".join(self.found.unread)
            self.remarks.append(
                "No HAL file that was read joins an encoder to spindle.0.revs and spindle.0.index-enable: the"
                " spindle is taken for one that no move can follow."
                + (" Not read: %s." % unread if unread else "")
            )
        return found

    def _say_what_turns(self):
        turning = sorted(set(self._letters()) & set("ABC"))
        if turning:
            self.remarks.append(
                "Where the rotary axis %s lies trivkins does not say: it was left out." % ", ".join(turning)
            )

    def _table(self):
        tilting, direction, pin = TABLES[self.module]
        point = [self._pin(letter + "-rot-point") for letter in "xyz"]
        offset, height = self._pin(pin), self._pin("z-offset")
        beside = [0.0, offset, height] if tilting == "A" else [offset, 0.0, height]
        self.remarks.append("Where the tool is clear of the table is not known: give the retract height.")
        return {
            "rotary_axes": [
                self._rotary("C", (0, 0, 1), point),
                self._rotary(tilting, direction, [p + b for p, b in zip(point, beside)]),
            ],
            "controller": self._control(),
        }

    def _pin(self, name):
        pin = "%s.%s" % (self.module, name)
        value = self.found.pin(pin)
        if value is None:
            self.remarks.append("%s is set in no HAL file that was read: 0 was taken." % pin)
            return 0.0
        return self.length * value

    def _rotary(self, letter, direction, point):
        return {
            "letter": letter,
            "side": "table",
            "direction": list(direction),
            "point_mm": point,
            "limits_degrees": self._limits(letter, self.angle),
            "velocity_deg_s": self._smallest("MAX_VELOCITY", letter, self.angle),
            "acceleration_deg_s2": self._smallest("MAX_ACCELERATION", letter, self.angle),
        }

    def _control(self):
        """TCP: from the start, or by the words that the configuration gives it."""
        control = {"dialect": "linuxcnc", "tcp": True, "reference": "tip"}
        if "sparm=identityfirst" not in self.options:
            return control
        remaps = {text.split()[0] for text in self.found.texts("RS274NGC", "REMAP") if text.split()}
        if not {"M428", "M429"} <= remaps:
            self.remarks.append("No M428 and M429 are there to switch TCP: it is taken to have none.")
            return {"dialect": "linuxcnc", "tcp": False}
        self.remarks.append("M428 is taken to switch TCP on, and M429 off: look into their subroutines.")
        return dict(control, tcp_on="M428", tcp_off="M429")

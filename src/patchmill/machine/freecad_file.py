"""A machine file's data from one of FreeCAD's own machines (.fcm, JSON of FreeCAD 1.2 and later): travels and
velocities of its axes, how they carry each other, its control and the decimals of its programs.

    found = read("mill.fcm")
    machines.save("my-mill", found.data)
    print("\\n".join(found.remarks))       # what the file does not say, and what was taken instead

Lengths are in mm, velocities in mm/min and degrees/min; `parent` names the axis that carries an axis. Files
in inches are refused: FreeCAD does not say in which unit their numbers are.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import os

from _patchmill import InputError

from patchmill.machine import schema
from patchmill.machine.linuxcnc.machine_of import Imported
from patchmill.system import files

ACCELERATION = 500.0  # mm/s² or degrees/s², of which such a file says nothing
PERIOD = 0.001  # s, likewise
SIDES = {"table_rotary": "table", "head_rotary": "head"}
DECIMALS = 3


def read(filename):
    """Imported from an .fcm file. Raises InputError naming what is missing or not understood."""
    name = os.path.basename(files.name_of(filename))
    text = files.read_text(filename, "filename")
    try:
        content = json.loads(text)
    except (ValueError, RecursionError) as error:
        remedy = "it is no machine file of FreeCAD: give another one."
        raise InputError("filename", repr(name), remedy) from error
    reader = _Reader(content, name)
    data = reader.machine()
    schema.checked(json.dumps(data), name)
    return Imported(data, reader.remarks)


class _Reader:
    """`content`: of the file. `name`: for messages."""

    def __init__(self, content, name):
        self.content, self.name = content, name
        self.remarks: list[str] = []
        self.axes = self._part("machine", "axes")
        if not self.axes:
            remedy = "it says nothing of axes: give a machine file of FreeCAD."
            raise InputError("filename", repr(name), remedy)

    def machine(self):
        units = self._part("machine").get("units", "metric")
        if units != "metric":
            remedy = "set the machine to metric units in FreeCAD's machine editor."
            raise InputError("units", repr(units), remedy)
        rotary = self._rotary()
        data = {
            "format": "patchmill-machine",
            "version": 1,
            "name": str(self._part("machine").get("name") or "FreeCAD machine"),
            "axes": "XYZ" + "".join(sorted(axis["letter"] for axis in rotary)),
            "spindle_lock": False,
            "decimals": self._part("output", "precision").get("axis", DECIMALS),
            "servo_period_s": PERIOD,
            "path_tolerance_mm": 0.0,
            "linear_axes": self._linear(),
            "rotary_axes": rotary,
            "start_phase_degrees": 0.0,
            "controller": {"dialect": self._dialect(), "tcp": False},
            "lock_origin": "at speed",
        }
        self.remarks.append(
            "Accelerations are not in the file: %g mm/s² was taken. Give those of the machine, from which"
            " follows what a texture's timing can be." % ACCELERATION
        )
        if rotary:
            self.remarks.append("Those of rotary axes are not either: %g°/s² was taken." % ACCELERATION)
            self.remarks.append("Where the tool is clear of the table is not known: give the retract height.")
            self.remarks.append("The control is taken to have no TCP: say so if it has.")
        told = "Whether the control can follow the spindle is not in the file: it is taken not to."
        self.remarks.append(told)
        self.remarks.append("The start phase is 0°: mill a calibration patch to find it.")
        return data

    def _part(self, *words):
        """An object within the file; an empty one where there is none."""
        found = self.content
        for word in words:
            found = found.get(word) if isinstance(found, dict) else None
        return found if isinstance(found, dict) else {}

    def _number(self, place, value):
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise InputError("filename", "%s of %s" % (place, self.name), "give a number.")
        return value

    def _limits(self, letter):
        said = self._part("machine", "axes", letter, "limits")
        return [self._number("%s/limits/%s" % (letter, end), said.get(end)) for end in ("min", "max")]

    def _velocity(self, letter):
        """In mm/s or degrees/s."""
        said = self._part("machine", "axes", letter).get("max_velocity")
        return self._number(letter + "/max_velocity", said) / 60.0

    def _linear(self):
        each = {letter: self._velocity(letter) for letter in "XYZ"}
        if max(each.values()) > min(each.values()):
            said = ", ".join("%s %g" % pair for pair in each.items())
            self.remarks.append("The velocities differ (%s mm/s): the smallest was taken." % said)
        return {
            "velocity_mm_s": min(each.values()),
            "acceleration_mm_s2": ACCELERATION,
            "jerk_mm_s3": None,
            "limits_mm": {letter: self._limits(letter) for letter in "XYZ"},
        }

    def _rotary(self):
        """The rotary axes in chain order, from the work to the tool: of a table the carried one comes first,
        of a head the carrying one."""
        letters = [a for a in self.axes if self._part("machine", "axes", a).get("role") in SIDES]
        tables = sorted((a for a in letters if self._side(a) == "table"), key=self._carriers, reverse=True)
        heads = sorted((a for a in letters if self._side(a) == "head"), key=self._carriers)
        for pair in (tables, heads):
            if len({self._carriers(letter) for letter in pair}) < len(pair):
                told = "Which of %s carries the other is not in the file: look at the axes."
                self.remarks.append(told % " and ".join(pair))
        return [self._axis(letter) for letter in tables + heads]

    def _side(self, letter):
        return SIDES[self._part("machine", "axes", letter)["role"]]

    def _carriers(self, letter):
        """How many axes carry an axis."""
        seen = [letter]
        while True:
            parent = self._part("machine", "axes", seen[-1]).get("parent")
            if parent not in self.axes or parent in seen:
                return len(seen) - 1
            seen.append(parent)

    def _axis(self, letter):
        joint = self._part("machine", "axes", letter, "joint")
        return {
            "letter": letter,
            "side": self._side(letter),
            "direction": joint.get("axis"),
            "point_mm": joint.get("origin", [0.0, 0.0, 0.0]),
            "limits_degrees": self._limits(letter),
            "velocity_deg_s": self._velocity(letter),
            "acceleration_deg_s2": ACCELERATION,
        }

    def _dialect(self):
        post = str(self._part("postprocessor").get("file_name") or "").replace("patchmill_", "")
        return post if post in schema.DIALECTS else "freecad"

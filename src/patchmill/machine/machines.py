"""Machine files: axes, limits and controller of a machine, and the start phase that was found with its
calibration patch.

JSON, in Resources/machines and in the user's own folder, which comes first. A file is checked against
schema.py and by the core's kinematics; what is wrong is named by its place in the file.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import itertools
import json
import math
import os
import re
from dataclasses import dataclass

import _patchmill as core
import FreeCAD
from _patchmill import InputError

from patchmill.system import files
from patchmill.machine import schema

KEY = r"[A-Za-z0-9][A-Za-z0-9._-]*"


@dataclass
class Machine:
    """A machine file as read; `model` is its _patchmill.MotionModel, `start_phase` in radians."""

    key: str
    data: dict

    @property
    def model(self):
        return self.rounding(self.data["path_tolerance_mm"])

    def rounding(self, tolerance):
        """Its _patchmill.MotionModel where corners that do not say are rounded within `tolerance` [mm]."""
        axes = self.data["linear_axes"]
        jerk = math.inf if axes["jerk_mm_s3"] is None else axes["jerk_mm_s3"]
        return core.MotionModel(
            axes["velocity_mm_s"],
            axes["acceleration_mm_s2"],
            jerk,
            self.data["servo_period_s"],
            tolerance,
            self.data["spindle_lock"],
        )

    @property
    def kinematics(self):
        """Its _patchmill.Kinematics, without a tool."""
        return kinematics(self.data, self.key)

    @property
    def rotary_letters(self):
        """Letters of the rotary axes in chain order; '' on three axes."""
        return "".join(axis["letter"] for axis in self.data.get("rotary_axes", []))

    @property
    def controller(self):
        """What the file says of the controller, with what it leaves out."""
        default = {"dialect": "freecad", "tcp": False, "reference": "tip", "operator": []}
        return dict(default, **self.data.get("controller", {}))

    @property
    def start_phase(self):
        return math.radians(self.data["start_phase_degrees"])


def user_folder():
    """Where the user's own machine files are; PATCHMILL_MACHINES overrides it."""
    default = os.path.join(FreeCAD.getUserAppDataDir(), "PatchMill", "machines")
    return os.environ.get("PATCHMILL_MACHINES", default)


def shipped_folder():
    here = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))  # the package's folder
    for up in (os.path.join(here, ".."), os.path.join(here, "..", "..")):
        folder = os.path.join(up, "Resources", "machines")
        if os.path.isdir(folder):
            return folder
    raise InputError("Machine", "no Resources/machines", "the installation is not complete.")


def names():
    """Keys of all machine files, sorted."""
    found: set = set()
    for folder in (shipped_folder(), user_folder()):
        if os.path.isdir(folder):
            found.update(f[:-5] for f in os.listdir(folder) if f.endswith(".json") and is_key(f[:-5]))
    return sorted(found)


def own(key):
    """Whether the user has a file of that key, which then stands before a shipped one."""
    return is_key(key) and os.path.isfile(os.path.join(user_folder(), key + ".json"))


def is_key(key):
    """Whether it can be the name of a machine file, and of nothing outside the folder."""
    return isinstance(key, str) and re.fullmatch(KEY, key) is not None


def free_key(text):
    """The key that is nearest to a text and that no machine file has."""
    key = re.sub(r"[^A-Za-z0-9._-]+", "-", text).lstrip("._-") or "machine"
    taken = set(names())
    free = (key if n == 1 else "%s-%d" % (key, n) for n in itertools.count(1))
    return next(each for each in free if each not in taken)


def remove(key):
    """Takes away the user's own file of that key; a shipped one of the same name shows again. Raises
    InputError where there is none."""
    if not own(key):
        raise InputError("Machine", key, "only your own machine files can be taken away.")
    try:
        os.remove(os.path.join(user_folder(), key + ".json"))
    except OSError as error:
        remedy = "it cannot be taken away (%s): change the folder's permissions." % error.strerror
        raise InputError("Machine", key, remedy) from error


def load(key):
    """The Machine of that key. Raises InputError naming the place in the file that is wrong."""
    for folder in (user_folder(), shipped_folder()) if is_key(key) else ():
        path = os.path.join(folder, "%s.json" % key)
        if os.path.isfile(path):
            return Machine(key, checked(files.read_text(path, "Machine"), key))
    raise InputError("Machine", key, "there is no such machine file; there are: %s." % ", ".join(names()))


def checked(text, key):
    """The data of a machine file's text, if it fits the schema and its axes make a machine."""
    data = schema.checked(text, key)
    kinematics(data, key)
    return data


def kinematics(data, key):
    """_patchmill.Kinematics of a machine file's data. Raises InputError naming the place."""
    radians = math.radians
    limits = data["linear_axes"].get("limits_mm", {})
    try:
        made = core.Kinematics(
            [limits.get(c, (-math.inf, math.inf))[0] for c in "XYZ"],
            [limits.get(c, (-math.inf, math.inf))[1] for c in "XYZ"],
            data.get("work_zero_mm", (0.0, 0.0, 0.0)),
        )
        for axis in data.get("rotary_axes", []):
            low, high = axis["limits_degrees"] or (-math.inf, math.inf)
            made.add_rotary(
                axis["letter"],
                axis["side"],
                axis["direction"],
                axis["point_mm"],
                radians(low),
                radians(high),
                radians(axis["velocity_deg_s"]),
                radians(axis["acceleration_deg_s2"]),
            )
        made.require_valid()
    except InputError as error:
        place = "Machine file %s: /%s" % (key, error.property)
        raise InputError(place, error.value, error.remedy) from error
    return made


def store_start_phase(key, degrees, conditions):
    """Writes the start phase [degrees] and under which conditions it was found (calibrated.conditions) into
    the user's own copy of the machine file; returns its path."""
    return save(key, dict(load(key).data, start_phase_degrees=float(degrees), calibration=conditions))


def save(key, data):
    """Writes a machine file into the user's folder, if it is sound; returns its path. Raises InputError
    naming the place in it that is wrong, and then leaves the old file as it is."""
    if not is_key(key):
        raise InputError("Machine", key, "use letters, digits, points, dashes and underscores for its name.")
    checked(json.dumps(data), key)
    folder = user_folder()
    try:
        os.makedirs(folder, exist_ok=True)
    except OSError as error:
        remedy = "the folder cannot be made (%s): set PATCHMILL_MACHINES to another one." % error.strerror
        raise InputError("Machine", folder, remedy) from error
    path = os.path.join(folder, key + ".json")
    files.write(path, json.dumps(data, indent=2), "Machine")
    return path

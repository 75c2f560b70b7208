"""Machine files: what a machine can do, and the start phase that was found with its calibration patch.

JSON, in Resources/machines and in the user's own folder, which comes first. A file is checked against the
schema below; what is wrong is named by its place in the file.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import math
import os
from dataclasses import dataclass

import _patchmill as core
import FreeCAD
from _patchmill import InputError

NUMBER = (int, float)
# place in the file: (types, lowest, highest); None where there is no bound
SCHEMA = {
    ("format",): ((str,), None, None),
    ("version",): ((int,), 1, 1),
    ("name",): ((str,), None, None),
    ("spindle_lock",): ((bool,), None, None),
    ("decimals",): ((int,), 0, 9),
    ("servo_period_s",): (NUMBER, 1e-6, 1.0),
    ("path_tolerance_mm",): (NUMBER, 0.0, 10.0),
    ("linear_axes", "velocity_mm_s"): (NUMBER, 1e-3, 1e5),
    ("linear_axes", "acceleration_mm_s2"): (NUMBER, 1e-3, 1e7),
    ("linear_axes", "jerk_mm_s3"): (NUMBER + (type(None),), 1e-3, 1e10),
    ("start_phase_degrees",): (NUMBER, 0.0, 360.0),
}


@dataclass
class Machine:
    """A machine file as read; `model` is its _patchmill.MotionModel, `start_phase` in radians."""

    key: str
    data: dict

    @property
    def model(self):
        axes = self.data["linear_axes"]
        jerk = math.inf if axes["jerk_mm_s3"] is None else axes["jerk_mm_s3"]
        return core.MotionModel(
            axes["velocity_mm_s"],
            axes["acceleration_mm_s2"],
            jerk,
            self.data["servo_period_s"],
            self.data["path_tolerance_mm"],
            self.data["spindle_lock"],
        )

    @property
    def start_phase(self):
        return math.radians(self.data["start_phase_degrees"])


def user_folder():
    """Where the user's own machine files are; PATCHMILL_MACHINES overrides it."""
    default = os.path.join(FreeCAD.getUserAppDataDir(), "PatchMill", "machines")
    return os.environ.get("PATCHMILL_MACHINES", default)


def shipped_folder():
    here = os.path.dirname(os.path.abspath(__file__))
    for up in (os.path.join(here, ".."), os.path.join(here, "..", "..")):
        folder = os.path.join(up, "Resources", "machines")
        if os.path.isdir(folder):
            return folder
    raise InputError("Machine", "no Resources/machines", "the installation is not complete.")


def names():
    """Keys of all machine files, sorted."""
    found = set()
    for folder in (shipped_folder(), user_folder()):
        if os.path.isdir(folder):
            found.update(f[:-5] for f in os.listdir(folder) if f.endswith(".json"))
    return sorted(found)


def load(key):
    """The Machine of that key. Raises InputError naming the place in the file that is wrong."""
    for folder in (user_folder(), shipped_folder()):
        path = os.path.join(folder, key + ".json")
        if os.path.isfile(path):
            with open(path, encoding="utf-8") as file:
                return Machine(key, checked(file.read(), key))
    raise InputError("Machine", key, "there is no such machine file; there are: %s." % ", ".join(names()))


def checked(text, key):
    """The data of a machine file's text, if it fits the schema."""
    try:
        data = json.loads(text)
    except ValueError as error:
        raise InputError("Machine file %s" % key, "no JSON", str(error)) from error
    for place, (types, low, high) in SCHEMA.items():
        _check_value(data, place, types, low, high, key)
    known = {place[0] for place in SCHEMA}
    for word in data:
        if word not in known:
            raise InputError("Machine file %s: /%s" % (key, word), data[word], "unknown word: remove it.")
    if data["format"] != "patchmill-machine":
        raise InputError("Machine file %s: /format" % key, data["format"], "give patchmill-machine.")
    return data


def _check_value(data, place, types, low, high, key):
    name = "Machine file %s: /%s" % (key, "/".join(place))
    value = data
    for word in place:
        if not isinstance(value, dict) or word not in value:
            raise InputError(name, "missing", "give it.")
        value = value[word]
    wrong_type = not isinstance(value, types) or (isinstance(value, bool) and bool not in types)
    if wrong_type:
        raise InputError(name, repr(value), "give a %s." % " or ".join(t.__name__ for t in types))
    if value is not None and low is not None and not low <= value <= high:
        raise InputError(name, value, "give a value from %g to %g." % (low, high))


def store_start_phase(key, degrees):
    """Writes the start phase [degrees] into the user's own copy of the machine file; returns its path."""
    data = dict(load(key).data, start_phase_degrees=float(degrees))
    checked(json.dumps(data), key)
    folder = user_folder()
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, key + ".json")
    with open(path + ".part", "w", encoding="utf-8") as file:
        json.dump(data, file, indent=2)
    os.replace(path + ".part", path)
    return path

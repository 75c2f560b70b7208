"""What a machine file may say: names, units, ranges. What is wrong is named by its place (a JSON pointer).

    checked(text, key) -> data        raises patchmill.InputError "Machine file KEY: /rotary_axes/1/direction"

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import math

import _patchmill as core
from _patchmill import InputError


NUMBER = (int, float)
MOST_SAID = 200  # letters of a wrong value in a message
try:
    CONTROLS = tuple(control["name"] for control in core.controls())
except core.InputError:  # there is no core: documents keep their operations all the same
    CONTROLS = ()
DIALECTS = CONTROLS + ("freecad",)
AXES = ("XYZ", "XYZA", "XYZB", "XYZC", "XYZAB", "XYZAC", "XYZBC")


class Value:
    """A plain value of one of `types`, within bounds or one of some words."""

    def __init__(self, *types, low=None, high=None, words=None):
        self.types, self.low, self.high, self.words = types, low, high, words

    def check(self, place, value):
        wrong = not isinstance(value, self.types) or (isinstance(value, bool) and bool not in self.types)
        if wrong:
            names = {type(None): "null", int: "whole number", float: "number", str: "text"}
            wanted = [names.get(t, t.__name__) for t in self.types if not (t is int and float in self.types)]
            place.refuse(repr(value), "give a %s." % " or ".join(wanted))
        if self.words and value not in self.words:
            place.refuse(repr(value), "give one of: %s." % ", ".join(self.words))
        if value is not None and self.low is not None and not self.low <= value <= self.high:
            place.refuse(value, "give a value from %g to %g." % (self.low, self.high))


def _is_finite(value):
    try:
        return math.isfinite(value)
    except OverflowError:  # a whole number that no float holds
        return False


class Numbers:
    """A list of `count` finite numbers; with `rising`, the first less than the second; null if allowed."""

    def __init__(self, count, rising=False, null=False):
        self.count, self.rising, self.null = count, rising, null

    def check(self, place, value):
        if value is None and self.null:
            return
        good = isinstance(value, list) and len(value) == self.count
        good = good and all(isinstance(v, NUMBER) and not isinstance(v, bool) for v in value)
        if not good or not all(_is_finite(v) for v in value):
            place.refuse(json.dumps(value), "give %d numbers in brackets." % self.count)
        if self.rising and not value[0] < value[1]:
            place.refuse(json.dumps(value), "give the lower limit first.")


class Record:
    """An object with words that must be there and words that may."""

    def __init__(self, required, optional=None):
        self.required, self.optional = required, optional or {}

    def check(self, place, value):
        if not isinstance(value, dict):
            place.refuse(json.dumps(value), "give an object in braces.")
        known = dict(self.required, **self.optional)
        for word, found in value.items():
            if word not in known:
                place.at(word).refuse(json.dumps(found), _about(word, known))
        for word in self.required:
            if word not in value:
                place.at(word).refuse("missing", "give it.")
        for word, found in value.items():
            known[word].check(place.at(word), found)


class List:
    """A list of like things."""

    def __init__(self, item, most):
        self.item, self.most = item, most

    def check(self, place, value):
        if not isinstance(value, list) or len(value) > self.most:
            place.refuse(json.dumps(value), "give a list of %d at most." % self.most)
        for i, item in enumerate(value):
            self.item.check(place.at(i), item)


class Place:
    """Where in which file."""

    def __init__(self, key, words=()):
        self.key, self.words = key, words

    def at(self, word):
        return Place(self.key, self.words + (str(word),))

    def refuse(self, value, remedy):
        place = _said("/".join(self.words))
        raise InputError("Machine file %s: /%s" % (self.key, place), _said(value), _said(remedy))


def _said(value):
    """A value for a message: not pages of it."""
    try:
        text = str(value)
    except ValueError:  # of a whole number with thousands of digits
        return "a number"
    text = text.encode("utf-8", "backslashreplace").decode()  # half a character cannot be shown
    return text if len(text) <= MOST_SAID else text[:MOST_SAID] + " ..."


def _about(word, known):
    """Why an unknown word is refused: it may be a known one in another unit."""
    for other in known:
        stem, units = _stem(other)
        if units and _stem(word)[0] == stem and word != other:
            return "wrong unit: the word is %s." % other
    return "unknown word: remove it."


def _stem(word):
    """'velocity_mm_s' -> ('velocity', ['mm', 's'])"""
    units = ("mm", "s", "s2", "s3", "min", "min2", "deg", "degrees", "rad", "radians", "inch", "ms")
    parts = word.split("_")
    cut = len(parts)
    while cut > 1 and parts[cut - 1] in units:
        cut -= 1
    return "_".join(parts[:cut]), parts[cut:]


TEXT = Value(str)
RATE = Value(*NUMBER, low=1e-3, high=1e5)
ACCELERATION = Value(*NUMBER, low=1e-3, high=1e7)
LINEAR = Record(
    {
        "velocity_mm_s": RATE,
        "acceleration_mm_s2": ACCELERATION,
        "jerk_mm_s3": Value(*NUMBER, type(None), low=1e-3, high=1e10),
    },
    {"limits_mm": Record({}, {letter: Numbers(2, rising=True) for letter in "XYZ"})},
)
ROTARY = Record(
    {
        "letter": Value(str, words=("A", "B", "C")),
        "side": Value(str, words=("table", "head")),
        "direction": Numbers(3),
        "point_mm": Numbers(3),
        "limits_degrees": Numbers(2, rising=True, null=True),
        "velocity_deg_s": RATE,
        "acceleration_deg_s2": ACCELERATION,
    }
)
CONTROLLER = Record(
    {"dialect": Value(str, words=DIALECTS), "tcp": Value(bool)},
    {
        "reference": Value(str, words=("tip", "ball centre")),
        "tcp_on": TEXT,
        "tcp_off": TEXT,
        "smoothing_on": TEXT,
        "smoothing_off": TEXT,
        "operator": List(TEXT, 20),
    },
)
CALIBRATION = Record(
    {
        "controller": TEXT,
        "spindle_rpm": Value(*NUMBER, low=1e-3, high=1e6),
        "pitch_mm": Value(*NUMBER, low=1e-6, high=1e4),
    },
    {"counted_from": Value(str, words=("index",))},
)
MACHINE = Record(
    {
        "format": Value(str, words=("patchmill-machine",)),
        "version": Value(int, low=1, high=1),
        "name": TEXT,
        "spindle_lock": Value(bool),
        "decimals": Value(int, low=0, high=9),
        "servo_period_s": Value(*NUMBER, low=1e-6, high=1.0),
        "path_tolerance_mm": Value(*NUMBER, low=0.0, high=10.0),
        "linear_axes": LINEAR,
        "start_phase_degrees": Value(*NUMBER, low=0.0, high=360.0),
    },
    {
        "axes": Value(str, words=AXES),
        "rotary_axes": List(ROTARY, 2),
        "work_zero_mm": Numbers(3),
        "retract_mm": Record({}, {letter: Value(*NUMBER, low=-1e5, high=1e5) for letter in "ZXY"}),
        "controller": CONTROLLER,
        "controller_version": TEXT,
        "lock_origin": Value(str, words=("at speed", "index")),
        "calibration": CALIBRATION,
    },
)


def checked(text, key):
    """The data of a machine file's text, if it fits. `key` is the file's name, for messages."""
    try:
        data = json.loads(text)
    except ValueError as error:
        raise InputError("Machine file %s" % key, "no JSON", str(error)) from error
    except RecursionError as error:
        raise InputError("Machine file %s" % key, "no machine", "it is nested too deeply.") from error
    place = Place(key)
    MACHINE.check(place, data)
    rotary = data.get("rotary_axes", [])
    described = [axis["letter"] for axis in rotary]
    for i, letter in enumerate(described):
        if letter in described[:i]:
            place.at("rotary_axes").at(i).at("letter").refuse(letter, "give each axis its own.")
    wanted = data.get("axes", "XYZ" + "".join(sorted(described)))[3:]
    for letter in wanted:
        if letter not in described:
            remedy = "axis %s of %s is missing: describe it." % (letter, data["axes"])
            place.at("rotary_axes").refuse("".join(described) or "none", remedy)
    for i, letter in enumerate(described):
        if letter not in wanted:
            place.at("rotary_axes").at(i).refuse(letter, "the machine's axes are %s." % data["axes"])
    return data

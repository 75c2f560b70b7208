"""The cutting load of a DCM modifier: what the stock resists with, what is not to be exceeded, and the load
along its path (docs/cutting-load.md).

    load = patchmill.cutting_load(dressup)          # of its last recompute
    print(load.force.max(), load.power.max(), load.spread("force"))

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import dataclass

import _patchmill as core
import numpy as np
from _patchmill import InputError

LIMITS = [
    ("App::PropertyFloat", "ForceLimit", "Load", "Largest on the tool in a turn, in N; 0: no limit", 0.0),
    ("App::PropertyFloat", "PowerLimit", "Load", "Power at the tool's edges, in W; 0: no limit", 0.0),
    ("App::PropertyLength", "ChipLimit", "Load", "Mean chip thickness; 0: no limit", 0.0),
]
RESISTANCE = [
    (
        "App::PropertyFloat",
        "SpecificForce",
        "Load",
        "k_c1.1 of the stock: cutting force on a chip 1 mm thick and 1 mm wide, in N",
        2000.0,
    ),
    ("App::PropertyFloat", "ForceExponent", "Load", "m_c of the stock: how thin chips resist more", 0.25),
    ("App::PropertyFloat", "NormalForce", "Load", "Normal to the cutting surface, of the cutting force", 0.3),
]
RESULTS = [
    ("App::PropertyFloat", "LargestForce", "Result", "On the tool in a turn, in N; 0: no limit of the load"),
    ("App::PropertyFloat", "LargestPower", "Result", "At the tool's edges, in W; 0: no limit of the load"),
    ("App::PropertyFloat", "LargestChip", "Result", "Mean chip thickness, in mm; 0: no limit of the load"),
]
LEAST_FEED = 1e-3  # mm/s: posts write less as zero
UNITS = {"ForceLimit": "N", "PowerLimit": "W", "ChipLimit": "mm"}


@dataclass(frozen=True)
class Limits:
    """Of the load, as arguments of limit_load: mm, N, W; infinite: none."""

    chip: float
    force: float
    power: float


@dataclass(frozen=True)
class Resistance:
    """Of the stock, as arguments of load_along."""

    specific: float  # N/mm^2
    exponent: float
    normal: float


@dataclass
class LoadAlong:
    """The load every quarter of a voxel along a path: arrays of one length. `places` (n, 3): of the tool's
    tip [mm]; length of the steps [mm], feed [mm/s], section of what is taken [mm^2], removal [mm^3/s], mean
    chip thickness [mm], force [N] and power [W]."""

    places: np.ndarray
    move: np.ndarray
    length: np.ndarray
    feed: np.ndarray
    section: np.ndarray
    removal: np.ndarray
    chip: np.ndarray
    force: np.ndarray
    power: np.ndarray

    @property
    def seconds(self):
        """When each step ends, rapids not counted [s]."""
        timed = self.feed > 0.0
        return np.cumsum(np.divide(self.length, self.feed, out=np.zeros_like(self.length), where=timed))

    def spread(self, what):
        """Largest over median of "force", "power", "chip", "removal" or "section" where something is cut,
        each step as often as it is long."""
        values = getattr(self, what)
        cut = values > 0.0
        if not cut.any():
            return 1.0
        order = np.argsort(values[cut])
        way = np.cumsum(self.length[cut][order])
        return float(values.max() / values[cut][order][np.searchsorted(way, 0.5 * way[-1])])


def given(obj):
    """{name of a limit: its number}, 0 for none."""
    return {"ForceLimit": obj.ForceLimit, "PowerLimit": obj.PowerLimit, "ChipLimit": obj.ChipLimit.Value}


def limits_of(obj):
    """Limits of a DressupDCM, or None if it has none. Raises InputError naming the property."""
    numbers = given(obj)
    for name, value in numbers.items():
        if not 0.0 <= value < float("inf"):
            raise InputError(name, "%g %s" % (value, UNITS[name]), "give 0, for no limit, or more.")
    if not any(numbers.values()):
        return None
    chip, force, power = (numbers[n] or float("inf") for n in ("ChipLimit", "ForceLimit", "PowerLimit"))
    return Limits(chip, force, power)


def resistance_of(obj):
    """Resistance of a DressupDCM's stock."""
    return Resistance(obj.SpecificForce, obj.ForceExponent, obj.NormalForce)


def limited(path, grid, resistance, limits, acceleration):
    """(path, source) of core.limit_load. Raises InputError as that does, and naming a limit that would all
    but stop the tool."""
    found = core.limit_load(path, grid, **vars(resistance), **vars(limits), acceleration=acceleration)
    made = found[0]
    length = np.linalg.norm(np.diff(np.vstack([[made.start], made.tips]), axis=0), axis=1)
    timed = ~np.isnan(made.turns) & (length > 0.0)  # rapids have none
    if not (made.turns[timed] * LEAST_FEED <= length[timed] * made.spindle.speed).all():
        names = {"ForceLimit": limits.force, "PowerLimit": limits.power, "ChipLimit": limits.chip}
        name, value = next((n, v) for n, v in names.items() if np.isfinite(v))
        remedy = "the feed would fall below %g mm/min: give more." % (60.0 * LEAST_FEED)
        raise InputError(name, "%g %s" % (value, UNITS[name]), remedy)
    return found


def along(path, grid, resistance):
    """LoadAlong of a _patchmill.ToolPath through the stock of a grid. Raises InputError."""
    found = core.load_along(path, grid, **vars(resistance))
    start = np.vstack([np.array(path.start)[None], path.tips])[:-1]
    at, move = found.pop("at")[:, None], found["move"]
    places = start[move] + at * (path.tips[move] - start[move])
    return LoadAlong(places, **found)

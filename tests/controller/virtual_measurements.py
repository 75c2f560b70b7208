"""Virtual measurements of textures that LinuxCNC milled: what measured_texture() says of machines with known
deviations. Three programs run through LinuxCNC once; each random case hides a start phase, a spindle error,
runout, play of X and Y and wear in the log, cuts its relief, and measures it turned, shifted, tilted, with
noise and holes:

    tools/freecad tests/controller/virtual_measurements.py FOLDER FIRST COUNT

Logs are kept in FOLDER. Prints a line for each case, and how many lie within their uncertainties.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))

import recorded_marks  # noqa: E402
from recorded_marks import SENSE, core, controller, patchmill, phase  # noqa: E402

from patchmill.areal.measured_texture import marks_of  # noqa: E402
from patchmill.surface.height_map import HeightMap  # noqa: E402
from patchmill.verify.simulation import _base, _stock, _window  # noqa: E402

STEP, NOISE, HOLES, TILT = 0.02, 0.0005, 0.05, 0.2  # mm, mm, share, degrees
PROGRAMS = [(14, 1), (11, 1), (8, 2)]  # dimples a side, patches a side
NAMES = ("flutes late", "spindle error", "play of X", "play of Y", "runout of flute 2 over flute 1",
         "radius of the tool", "tilt")  # fmt: skip


@dataclass
class Hidden:
    """What a case hides: degrees, per cent, µm, mm."""

    late: float
    error: float
    play: tuple
    runout: float
    radius: float

    @classmethod
    def random(cls, chance):
        """Up to 90° of start phase, 0.3 % spindle error or a spindle that is right, 4 µm, 5 µm, 2 %."""
        return cls(
            chance.uniform(-90, 90),
            chance.uniform(-0.3, 0.3) * chance.integers(2),
            tuple(chance.uniform(0, 5, 2)),
            chance.uniform(-4, 4),
            1.0 - 0.02 * chance.random(),
        )

    def values(self):
        """In the order of NAMES."""
        return (self.late, self.error, *self.play, self.runout, self.radius, TILT)


class Milled:
    """A program as LinuxCNC ran it, to be cut with deviations."""

    def __init__(self, folder, side, patches):
        name = "virtual-%d-%d" % (side, patches)
        self.job, op = recorded_marks.make_operation(name.replace("-", ""), "Spindle-locked", False, 0.0)
        op.PatchSide, op.PatchesX, op.PatchesY = side, patches, patches
        self.plan = patchmill.recompute(op)
        kept = Path(folder) / (name + ".npz")
        if not kept.exists():
            self._run(kept)
        with np.load(kept) as log:
            self.time, self.tip, self.turns = log["time"], log["tip"], log["turns"]
            # the median: the moment at which the tool stands on the first dimple is not always seen
            self.azimuth = SENSE * np.radians(360.0 * self.turns - log["offset"] - np.median(log["error"]))
            self.passed = log["passed"]
            self.middle = float(np.interp(np.median(self.passed), self.time, self.turns))
        self.reference = marks_of(self.plan, STEP)

    def _run(self, kept):
        with tempfile.TemporaryDirectory() as folder:
            program = Path(folder) / "x.ngc"
            patchmill.post(self.job, str(program))
            limits = recorded_marks.ACCELERATION, recorded_marks.VELOCITY
            machine = controller.Machine(*limits)
            log = controller.run(program, machine, stops=recorded_marks.STOPS)
            report = phase.measure(log, recorded_marks.targets_of(self.plan, str(program)), 2, SENSE)
        from_start = log.time > report.time[0] - 1.0  # the spindle stands still before
        np.savez(kept, time=log.time[from_start], tip=log.tip[from_start], turns=log.turns[from_start],
                 offset=report.offset, error=report.error, passed=report.time)  # fmt: skip

    def cut(self, hidden):
        """HeightMap of the relief that the machine with these deviations leaves; the tool's tip is where it
        was told to be, as after measuring its length."""
        given, radius = self.plan.input, hidden.radius
        tip = np.column_stack([played(self.tip[:, 0], 1e-3 * hidden.play[0]),
                               played(self.tip[:, 1], 1e-3 * hidden.play[1]), self.tip[:, 2]])  # fmt: skip
        slow = 2.0 * math.pi * 0.01 * hidden.error * (self.turns - self.middle)
        azimuth = self.azimuth - SENSE * (slow + math.radians(hidden.late))
        motion = core.motion_of_samples(self.time, tip, azimuth, given.spindle, radius)
        low, high = _window(self.plan, None)
        base, reach = _base(self.plan)
        runout = [0.0, 0.0]
        runout[self.second_flute()] = 1e-3 * hidden.runout
        marks = core.simulate_texture(
            motion, core.BallEndMill(radius, given.tool.flutes), self.plan.plane, low - given.spacing,
            high + given.spacing, STEP, _stock(self.plan) + 0.005, base=base, reach=reach, runout=runout,
        )  # fmt: skip
        return HeightMap(marks.heights, marks.step, tuple(marks.first))

    def second_flute(self):
        """Which flute does not cut the first dimple where nothing deviates, by all of them."""
        marks = self.reference.marks
        n = self.plan.dimples.normals[marks.numbers]
        contact = np.arctan2(-n[:, 1], -n[:, 0])
        over = np.round((contact - np.interp(self.passed, self.time, self.azimuth)) / math.pi).astype(int)
        return 1 - int(np.median((over - marks.flutes) % 2))


def played(way, play):
    """An axis that stays behind by half a play, whichever way it came."""
    moved, at = np.empty(len(way)), float(way[0])
    for number, wanted in enumerate(way.tolist()):
        at = min(max(at, wanted - 0.5 * play), wanted + 0.5 * play)
        moved[number] = at
    return moved


def measured(relief, chance, turn, shift):
    """HeightMap as an instrument gives it: a grid that is turned [rad], shifted [mm] and tilted, by bilinear
    interpolation, with noise and holes; and the tilts along its axes [degrees]."""
    rows, columns = relief.shape
    count = int(1.45 * max(relief.size) / STEP)
    along = (np.arange(count) - 0.5 * count) * STEP
    u, v = np.meshgrid(along, along)
    c, s = math.cos(turn), math.sin(turn)
    i = (relief.x().mean() + c * u - s * v - relief.origin[0]) / relief.step[0]
    j = (relief.y().mean() + s * u + c * v - relief.origin[1]) / relief.step[1]
    inside = (i >= 0) & (j >= 0) & (i < columns - 1) & (j < rows - 1)
    left, low = np.where(inside, i, 0).astype(int), np.where(inside, j, 0).astype(int)
    z, p, q = relief.heights.astype(float), i - left, j - low
    below = z[low, left] * (1 - p) + z[low, np.minimum(left + 1, columns - 1)] * p
    up = np.minimum(low + 1, rows - 1)
    above = z[up, left] * (1 - p) + z[up, np.minimum(left + 1, columns - 1)] * p
    way = chance.uniform(0, 2 * math.pi)
    slopes = math.tan(math.radians(TILT)) * np.array([math.cos(way), math.sin(way)])
    heights = below * (1 - q) + above * q + slopes[0] * u + slopes[1] * v
    heights += chance.normal(size=heights.shape) * NOISE
    heights[~inside | (chance.random(heights.shape) < HOLES)] = np.nan
    known = np.isfinite(heights)
    keep = np.ix_(known.any(axis=1), known.any(axis=0))
    return HeightMap(heights[keep], STEP, tuple(shift)), np.degrees(np.arctan(slopes))


def case(milled, seed):
    """(name, hidden, found, uncertainty) of each finding of a random case."""
    chance = np.random.default_rng(seed)
    hidden, turn = Hidden.random(chance), chance.uniform(-math.pi, math.pi)
    surface, tilts = measured(milled.cut(hidden), chance, turn, chance.uniform(-20, 20, 2))
    about = turn + chance.uniform(-0.5, 0.5)  # as a user knows it
    told = patchmill.measured_texture(milled.plan, surface, angle=about, reference=milled.reference)
    wanted = dict(zip(NAMES, hidden.values()))
    del wanted["tilt"]
    wanted.update({"tilt along x": tilts[0], "tilt along y": tilts[1]})
    return [(name, value, told.finding(name).value, told.finding(name).uncertainty)
            for name, value in wanted.items()]  # fmt: skip


def main(folder, first, count):
    with tempfile.TemporaryDirectory() as machines:
        recorded_marks.make_machine(machines)
        milled = [Milled(folder, *program) for program in PROGRAMS]
        off: dict = {}
        for seed in range(first, first + count):
            said = []
            for name, wanted, found, uncertainty in case(milled[seed % len(milled)], seed):
                miss = math.nan if found is None else found - wanted
                if name == "flutes late" and found is not None:
                    miss = math.remainder(miss, 180.0)
                off.setdefault(name, []).append((miss, uncertainty or math.nan))
                said.append("%s %.4g off %.2g ± %.2g" % (name, wanted, miss, uncertainty or math.nan))
            print(seed, "; ".join(said), flush=True)
    print("| finding | within its uncertainty | largest off | mean uncertainty | unknown |\n|" + " --- |" * 5)
    for name, rows in off.items():
        miss, size = np.array(rows).T
        told = np.isfinite(miss)
        print("| %s | %d of %d | %.3g | %.3g | %d |" % (
            name, (abs(miss[told]) <= size[told]).sum(), told.sum(), abs(miss[told]).max(initial=0.0),
            size[told].mean(), (~told).sum()))  # fmt: skip


if __name__ == "__main__":
    main(sys.argv[1], *map(int, sys.argv[2:4]))

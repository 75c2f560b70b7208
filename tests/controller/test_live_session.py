"""A live session drives LinuxCNC while it cuts: feed limits and depth of cut are changed twice on the way,
the tool goes on from where it is, and never stands longer than the look-ahead.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
from harness import controller, load  # noqa: E402

GIVEN = {
    "module": str(HERE.parents[1] / "build" / "Mod" / "PatchMill"),
    "feeds": [(20.0, 40.0), (10.0, 15.0), (30.0, 50.0)],  # mm/s, V_Lo and V_Hi
    "axial": [2.0, 1.0, 3.0],
    "change_at": [60, 200],  # moves sent
    "batch_seconds": 0.4,
    "ahead": 8,  # MDI commands
}
LOOK_AHEAD = 0.4  # s: what is planned and sent ahead of the tool


def run(rate):
    """(Log, moves sent) of one run at `rate` simulated seconds in a second."""
    with tempfile.TemporaryDirectory(prefix="patchmill-live-") as name:
        folder = Path(name)
        empty = folder / "empty.ngc"
        empty.write_text("M2\n")
        machine = controller.Machine()
        controller.prepare(folder, empty, machine)
        shutil.move(folder / "driver.py", folder / "base.py")
        shutil.copy(HERE / "live_driver.py", folder / "driver.py")
        (folder / "live.json").write_text(json.dumps(GIVEN))
        for path in folder.iterdir():
            path.chmod(path.stat().st_mode | 0o666 | (0o111 if path.name == "driver.py" else 0))
        with open(folder / "output.txt", "wb") as sink:
            child = subprocess.Popen(
                controller.command_line(folder, rate),
                stdout=sink,
                stderr=subprocess.STDOUT,
                stdin=subprocess.DEVNULL,
            )
            try:
                child.wait(240)
            except subprocess.TimeoutExpired:
                raise controller.TooFast("not done after 240 s") from None
            finally:
                controller.end(child)
        verdict = folder / "verdict.txt"
        words = verdict.read_text().strip() if verdict.exists() else "no verdict"
        if words != "ok":
            tail = (folder / "output.txt").read_text(errors="replace")[-1500:]
            refused = words.startswith("error")
            raise (controller.ControllerError if refused else controller.TooFast)(words + "\n" + tail)
        return controller.read_samples(folder / "samples.txt", machine), json.loads(
            (folder / "sent.json").read_text()
        )


def longest_rest(log):
    """The longest time that the tool stood between its first move and its last [s]."""
    moving = numpy.linalg.norm(numpy.diff(log.tip, axis=0), axis=1) > 1e-9
    at = numpy.flatnonzero(moving)
    return float(numpy.diff(log.time[at]).max()), at[0], at[-1]


class Live(unittest.TestCase):
    @load.told_from_load
    def test_conditions_change_while_it_cuts(self):
        log, sent = run(1.0 / load.slower())
        load.note(log)
        rest, first, last = longest_rest(log)
        ends = numpy.array([m["tip"] for m in sent])
        print("%d moves in %.1f s; longest rest %.3f s" % (len(sent), log.time[last] - log.time[first], rest))
        self.assertLessEqual(rest, LOOK_AHEAD)
        # the tool was where it was sent, in order
        at = 0
        for end in ends[:: max(1, len(ends) // 100)]:
            d = numpy.linalg.norm(log.tip[at:] - end, axis=1)
            near = numpy.flatnonzero(d < 0.15)  # a rapid goes 0.1 mm in a period, corners are rounded
            self.assertGreater(len(near), 0, end)
            at += near[0]
        conditions = numpy.array([m["conditions"] for m in sent])
        self.assertEqual(sorted(set(conditions)), [0, 1, 2])
        for state, (low, high) in enumerate(GIVEN["feeds"]):
            feeds = [m["feed"] for m in sent if m["conditions"] == state and m["feed"]]
            self.assertGreaterEqual(min(feeds), low * 0.999)
            self.assertLessEqual(max(feeds), high * 1.001)
        levels = {}
        for move in sent:
            levels.setdefault(move["conditions"], set()).add(round(move["level"], 6))
        print("levels:", levels)
        self.assertGreater(len(set().union(*levels.values())), 2)


if __name__ == "__main__":
    load.main(verbosity=2)

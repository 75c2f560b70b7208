"""How long each long call takes to come back after a stop, at 100 random moments (STOPS), and after Ctrl-C
at as many, and the longest time between two of its progress calls, in milliseconds; the aims are 200 and 100.
Beside each the processor time that the process took meanwhile, which says what it was on a machine that did
other things as well. CALLS names those that are to be measured, of all.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import random
import signal
import sys
import tempfile
import threading
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "host"))

import FreeCAD  # noqa: E402
import Part  # noqa: E402
import patchmill  # noqa: E402
from milling_jobs import add_pocket, dress, make_job, pocket_part  # noqa: E402
from parts import job_on  # noqa: E402
from patchmill.modifiers import dcm_input, dressup_dcm  # noqa: E402
from patchmill.operations import copy_input, copy_milling, texture_operation  # noqa: E402
from patchmill.verify import checks  # noqa: E402
from patchmill.voxels import removal_model  # noqa: E402
from recipe import small_job  # noqa: E402

STOPS = int(os.environ.get("STOPS", 100))
CALLS = os.environ.get("CALLS", "").split(",")


class Clock:
    """A progress that says no after `seconds`."""

    def __init__(self, seconds=float("inf")):
        self.end = time.monotonic() + seconds
        self.last, self.taken = time.monotonic(), time.process_time()
        self.longest = self.most = 0.0

    def __call__(self, share):
        now, taken = time.monotonic(), time.process_time()
        self.longest, self.last = max(self.longest, now - self.last), now
        self.most, self.taken = max(self.most, taken - self.taken), taken
        return now < self.end

    def since(self):
        """(seconds, processor seconds) since it was asked last."""
        return time.monotonic() - self.last, time.process_time() - self.taken


class Late:
    """Times of coming back, as a text."""

    def __init__(self):
        self.times, self.taken = [], []

    def add(self, seconds, *taken):
        self.times.append(seconds)
        self.taken.extend(taken)

    def __str__(self):
        times = sorted(self.times)
        text = "%3.0f ms, at most %4.0f" % (1e3 * times[len(times) // 2], 1e3 * times[-1])
        return text + (" (processor %.0f)" % (1e3 * max(self.taken)) if self.taken else "")


def interrupted(call, after):
    """(seconds, processor seconds) from a Ctrl-C after so many seconds to when the call has ended; None if it
    ended before."""
    began = []

    def press():
        began.extend((time.monotonic(), time.process_time()))
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(after, press)
    try:
        timer.start()
        call(None)
        timer.cancel()
        timer.join()
        time.sleep(0.001)  # where it is pressed just now it is told here
    except KeyboardInterrupt:
        return time.monotonic() - began[0], time.process_time() - began[1]
    return None


def measure(name, call):
    """One line of the table; the call is made whole first."""
    if CALLS != [""] and name not in CALLS:
        return
    began, whole = time.monotonic(), Clock()
    call(whole)
    whole(1.0)
    seconds = time.monotonic() - began
    numbers, late, after, keys = random.Random(name), Late(), Late(), Late()
    for _ in range(STOPS):
        clock = Clock(numbers.uniform(0.0, seconds))
        call(clock)
        late.add(time.monotonic() - clock.end)
        after.add(*clock.since())
        pressed = interrupted(call, numbers.uniform(0.0, seconds))
        if pressed is not None:
            keys.add(*pressed)
    row = (name, seconds, 1000 * whole.longest, 1000 * whole.most, late, after, keys if keys.times else "-")
    text = "%-12s %6.2f s; progress each %4.0f ms at most (processor %4.0f); back after a stop %s, "
    print((text + "of that after the answer %s; after Ctrl-C %s") % row, flush=True)


def main():
    _, job, op = small_job(name="stops")
    op.PatchSide, op.PatchesX, op.PatchesY = 30, 3, 2
    given = op.Proxy.texture_input(op)
    measure("texture", lambda progress: texture_operation.prepare(given, progress))
    patchmill.recompute(op)
    measure("simulate", lambda progress: patchmill.simulate(op, progress=progress))
    to_check = checks.check_input(op)
    measure("check", lambda progress: checks.run_check(to_check, progress=progress))
    with tempfile.TemporaryDirectory() as folder:
        how = job, os.path.join(folder, "program.ngc"), "patchmill_linuxcnc", "--precision=3"
        measure("post", lambda progress: patchmill.post(*how, progress))
    _, curved = job_on(Part.makeTorus(40, 15).common(Part.makeBox(80, 80, 40)), "Face1")
    curved.Mapping, curved.PatchSide, curved.Spacing = "On surface", 6, 0.2
    on_surface = curved.Proxy.texture_input(curved)
    measure("on surface", lambda progress: texture_operation.prepare(on_surface, progress))
    _, milling = make_job(pocket_part(), ball=True)
    rough = patchmill.CopyMilling.Create("Copy", parentJob=milling)
    rough.RadialDepth, rough.AxialDepth = 0.05, 0.1
    patchmill.recompute(rough)  # finds its heights
    copy = copy_input.input_of(rough)
    measure("copy milling", lambda progress: copy_milling.mill(copy, progress))
    _, milling = make_job(pocket_part())
    dressup = dress(add_pocket(milling))
    dressup.VoxelSize = 0.08
    dcm = dcm_input.input_of(dressup)
    measure("dcm", lambda progress: dressup_dcm.compute(dcm, "", progress))
    measure("voxels", lambda progress: removal_model.make(dcm.model, "", progress))
    for document in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(document)


main()

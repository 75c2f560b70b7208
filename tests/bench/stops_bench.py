"""How long each long call takes to come back after a stop, at 100 random moments (STOPS), and the longest
time between two of its progress calls, in milliseconds; the aims are 200 and 100.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import random
import sys
import tempfile
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


class Clock:
    """A progress that says no after `seconds`."""

    def __init__(self, seconds=float("inf")):
        self.end = time.monotonic() + seconds
        self.last, self.longest = time.monotonic(), 0.0

    def __call__(self, share):
        now = time.monotonic()
        self.longest, self.last = max(self.longest, now - self.last), now
        return now < self.end


def measure(name, call):
    """One line of the table; the call is made whole first."""
    began, whole = time.monotonic(), Clock()
    call(whole)
    seconds = time.monotonic() - began
    numbers, late = random.Random(name), []
    for _ in range(STOPS):
        clock = Clock(numbers.uniform(0.0, seconds))
        call(clock)
        late.append(time.monotonic() - clock.end)
    late = sorted(late)
    row = (name, seconds, 1000 * whole.longest, 1000 * late[len(late) // 2], 1000 * late[-1])
    text = "%-14s %7.2f s, progress each %6.0f ms at most, back after %6.0f ms, at most %6.0f ms"
    print(text % row, flush=True)


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

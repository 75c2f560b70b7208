"""Memory that random jobs of every operation take at most, beside what was foreseen of them: JOBS of each
(50), each in a process of its own, since what one frees the next takes again. The aim is a ratio within 1.5.
KINDS names those that are to be made, of all; SAY=1 says every job's foreseen and taken MB.

What is foreseen is what the operation would be refused for if it were not free.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import random
import re
import sys
import tempfile
import traceback
from unittest import mock

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "host"))

import FreeCAD  # noqa: E402
import Part  # noqa: E402
import patchmill  # noqa: E402
from milling_jobs import add_pocket, dress, make_job, pocket_part  # noqa: E402
from parts import job_on, tilted_box  # noqa: E402
from patchmill import InputError  # noqa: E402
from patchmill.modifiers import dcm, dcm_input  # noqa: E402
from patchmill.operations import copy_input, copy_milling  # noqa: E402
from patchmill.system import memory  # noqa: E402
from patchmill.textures import plan  # noqa: E402
from patchmill.verify import checks  # noqa: E402
from patchmill.voxels import removal_model  # noqa: E402

JOBS = int(os.environ.get("JOBS", 50))
LEAST = 16e6  # bytes: of less the process's own changes are a part


def status(word):
    """Bytes of a line of /proc/self/status."""
    with open("/proc/self/status", encoding="ascii") as lines:
        return next(1024 * int(line.split()[1]) for line in lines if line.startswith(word + ":"))


def taken(call):
    """Bytes that a call takes at most."""
    with open("/proc/self/clear_refs", "w", encoding="ascii") as peak:
        peak.write("5")
    before = status("VmRSS")
    kept = call()
    most = status("VmHWM") - before
    del kept
    return most


class Once:
    """A progress that goes on until it is asked again."""

    def __init__(self):
        self.count = 0

    def __call__(self, share):
        self.count += 1
        return self.count < 3


class Asked:
    """The most memory that was asked for, in the place of memory.require."""

    most = 0.0

    def __call__(self, needed, *names):
        self.most = max(self.most, needed)


def flat_texture(numbers, dimples):
    """An operation of about so many dimples on a face of 20 x 16 mm."""
    spacing = (320.0 / numbers.uniform(*dimples)) ** 0.5
    _, op = job_on(*tilted_box(), diameter=4.0 * spacing)
    op.PatchShape = numbers.choice(["Square", "Hexagon", "Triangle"])
    op.Strategy, op.PostUnheld = "Constant feed", True  # needs no machine
    op.PatchSide, op.Spacing = numbers.randint(8, 20), spacing
    return op


def placed(numbers):
    given = flat_texture(numbers, (8e4, 3e5)).Proxy.texture_input
    given = given(FreeCAD.ActiveDocument.Objects[-1])
    return lambda: plan.place_texture(given)


def on_surface(numbers):
    spacing = numbers.uniform(0.1, 0.3)
    solid = numbers.choice([Part.makeTorus(40, 15), Part.makeSphere(30)])
    _, op = job_on(solid.common(Part.makeBox(80, 80, 40)), "Face1", diameter=4.0 * spacing)
    op.Mapping, op.PatchSide, op.Spacing = "On surface", 6, spacing
    given = op.Proxy.texture_input(op)
    return lambda: plan.place_texture(given)


def planned(numbers):
    op = flat_texture(numbers, (1e4, 6e4))
    return lambda: patchmill.recompute(op)


def simulated(numbers):
    op = flat_texture(numbers, (2e3, 6e3))
    patchmill.recompute(op)
    step = op.Spacing.Value / numbers.uniform(30.0, 80.0)

    will = 0.0
    for _ in range(4):  # it asks for what it knows, then for more
        try:
            patchmill.simulate(op, step=step, memory_limit=1.01 * will, progress=Once())
        except InputError as error:
            will = 1e9 * float(re.search(r"([\d.e+-]+) GB", error.value).group(1))

    def call():
        memory.require(will)
        return patchmill.simulate(op, step=step)

    return call


def checked(numbers):
    op = flat_texture(numbers, (1e4, 4e4))
    patchmill.recompute(op)
    given = checks.check_input(op)
    return lambda: checks.run_check(given)


def posted(numbers):
    op = flat_texture(numbers, (1e4, 3e4))
    patchmill.recompute(op)
    job = next(o for o in op.Document.Objects if o.Name.startswith("Job"))
    post = "patchmill_" + numbers.choice(["linuxcnc", "fanuc", "siemens"])
    arguments = "--precision=%d" % op.Decimals

    def call():
        with tempfile.TemporaryDirectory() as folder:
            return patchmill.post(job, os.path.join(folder, "x.nc"), post, arguments)

    return call


def copied(numbers):
    _, milling = make_job(pocket_part(), ball=True)
    op = patchmill.CopyMilling.Create("Copy", parentJob=milling)
    op.RadialDepth, op.AxialDepth = numbers.uniform(0.03, 0.1), numbers.uniform(0.1, 0.4)
    patchmill.recompute(op)
    given = copy_input.input_of(op)
    stock, part, _ = copy_milling.solids(given)
    will = copy_milling.foreseen_bytes(given, part, *copy_milling.to_cut(stock, part))

    def call():
        memory.require(will)
        return patchmill.recompute(op)

    return call


def dressed(numbers, controls):
    _, milling = make_job(pocket_part(), ball=controls != "Feed")
    dressup = dress(add_pocket(milling))
    dressup.VoxelSize, dressup.Controls = numbers.uniform(0.08, 0.3), controls
    dressup.Machine = "" if controls == "Feed" else "table-table-ac"
    return dcm_input.input_of(dressup)


def controlled(numbers):
    given = dressed(numbers, numbers.choice(["Feed", "Feed and posture"]))

    def call():
        memory.require(removal_model.estimate(given.model)["total"])
        return dcm.apply(given, removal_model.make(given.model))

    return call


def voxels(numbers):
    given = dressed(numbers, numbers.choice(["Feed", "Posture"])).model

    def call():
        memory.require(removal_model.estimate(given)["total" if given.posture else "grid"])
        return removal_model.make(given)

    return call


KINDS = (placed, on_surface, planned, simulated, checked, posted, copied, controlled, voxels)


def job(kind, number):
    """(bytes taken, bytes foreseen) of a job, made in a child."""
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            call = kind(random.Random("%s %d" % (kind.__name__, number)))
            with mock.patch.object(memory, "require", Asked()) as asked:
                os.write(write, b"%d %d" % (taken(call), asked.most))
        except BaseException:
            traceback.print_exc()
        os._exit(0)
    os.close(write)
    with os.fdopen(read) as pipe:
        text = pipe.read()
    os.waitpid(child, 0)
    return tuple(map(int, text.split())) if text else (0, 0)


def main():
    names = os.environ.get("KINDS", "").split()
    for kind in KINDS:
        if names and kind.__name__ not in names:
            continue
        made = [job(kind, number) for number in range(JOBS)]
        if "SAY" in os.environ:
            print(*("%.1f/%.1f" % (will / 1e6, took / 1e6) for took, will in made), flush=True)
        rows = [(took, will) for took, will in made if took >= LEAST]
        ratios = sorted(will / took for took, will in rows)
        off = sum(not 1 / 1.5 <= ratio <= 1.5 for ratio in ratios)
        if not ratios:
            print("%-12s no job of at least %g MB" % (kind.__name__, LEAST / 1e6), flush=True)
            continue
        print(
            "%-12s %3d jobs of %4.0f to %4.0f MB, foreseen/taken %.2f to %.2f, median %.2f; %d not within 1.5"
            % (kind.__name__, len(rows), min(rows)[0] / 1e6, max(rows)[0] / 1e6, ratios[0], ratios[-1],
               ratios[len(ratios) // 2], off), flush=True)  # fmt: skip


main()

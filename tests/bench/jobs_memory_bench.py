"""Memory that textures take at most, beside what is foreseen of them (textures/division.py): each in a
process of its own, since what one frees the next one takes again.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
SPACINGS = (0.15, 0.1, 0.07, 0.05, 0.035)  # mm, on a face of 20 x 16 mm


def status(word):
    """Bytes of a line of /proc/self/status."""
    with open("/proc/self/status", encoding="ascii") as lines:
        return next(1024 * int(line.split()[1]) for line in lines if line.startswith(word + ":"))


def measured(call):
    """(what the call gives, bytes that it takes at most)"""
    with open("/proc/self/clear_refs", "w", encoding="ascii") as peak:
        peak.write("5")
    before = status("VmRSS")
    return call(), status("VmHWM") - before


def one(spacing):
    """A texture of that spacing: two lines of the table."""
    sys.path.insert(0, str(HERE.parent / "host"))
    import patchmill
    from parts import job_on, tilted_box
    from patchmill.textures import division, plan

    _, op = job_on(*tilted_box(), diameter=4.0 * spacing)
    op.PatchSide, op.Spacing = 20, spacing
    placed, taken = measured(lambda: plan.place_texture(op.Proxy.texture_input(op)))
    points, cut = len(placed.dimples), dict(placed.dimples.counts())["cut"]
    say("placed", points, division.BYTES_PER_POINT, taken)
    del placed
    _, taken = measured(lambda: patchmill.recompute(op))
    say("in the document", cut, division.BYTES_PER_DIMPLE, taken)


def say(what, count, each, taken):
    ratio = each * count / taken
    print("%8d dimples %-16s %7.1f MB, foreseen %7.1f MB, ratio %.2f" % (
        count, what, taken / 1e6, each * count / 1e6, ratio), flush=True)


if len(sys.argv) > 1:
    one(float(sys.argv[1]))
else:
    for spacing in SPACINGS:
        program = str(HERE.parents[1] / "tools" / "freecad")
        done = subprocess.run([program, __file__, str(spacing)], capture_output=True, text=True)
        said = [line + "\n" for line in done.stdout.splitlines() if "foreseen" in line]
        print("".join(said), end="", flush=True)

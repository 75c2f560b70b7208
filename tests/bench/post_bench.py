"""Seconds that PatchMill's own posts take for 1,000,000 five-axis moves, beside FreeCAD's linuxcnc post in
the same run (on a fifth of the moves, times five).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import importlib
import math
import os
import tempfile
import time

import FreeCAD
import Path

from patchmill.freecad import host

MOVES, SHARE = 1000000, 5
POSTS = ("patchmill_linuxcnc", "patchmill_fanuc", "patchmill_siemens", "patchmill_heidenhain")


def path(count):
    lines = ["G0 X0 Y0 Z5"]
    for i in range(count):
        a = 1e-4 * i
        words = (50 * math.sin(a), 50 * math.cos(a), 1e-5 * i, 10 + 1e-5 * i, a)
        lines.append("G1 X%.4f Y%.4f Z%.4f A%.4f C%.4f F7.24" % words)
    return Path.Path("\n".join(lines))


def seconds(call):
    start = time.perf_counter()
    call()
    return time.perf_counter() - start


def main():
    document = FreeCAD.newDocument("bench")
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    job = host.create_job("Job", [box])
    operation = document.addObject("Path::Feature", "Moves")
    operation.addProperty("App::PropertyBool", "Active")
    operation.addProperty("App::PropertyString", "CoolantMode")
    operation.addProperty("App::PropertyLink", "ToolController")
    operation.Active, operation.CoolantMode = True, "None"
    operation.ToolController = host.tool_controllers(job)[0]
    job.Operations.Group = job.Operations.Group + [operation]
    operation.Path = path(MOVES // SHARE)
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        stock = SHARE * seconds(lambda: host.post_parts(job, "linuxcnc", "--no-show-editor"))
    print("%-22s %6.2f s for %d moves" % ("linuxcnc (FreeCAD's)", stock, MOVES))
    operation.Path = path(MOVES)
    for name in POSTS:
        export = importlib.import_module(name + "_post").export
        own = seconds(lambda: export([operation], "-", ""))
        print("%-22s %6.2f s, %.1f times as fast" % (name, own, stock / own))


main()

"""Isolated dimples of several spacings and depths on one part: simulated, with pictures of each and a table.

    patchmill macro sweep.py PART OUT

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import sys

import patchmill

TOOL = {"diameter": 2, "flutes": 2, "speed": 1000, "feed": 434.413}
SPACINGS = (0.6, 0.8)  # mm
DEPTHS = (0.01, 0.02)  # mm


def main(part, out):
    job = patchmill.job(part, tool=TOOL)
    op = patchmill.texture(job, "largest free-form", PatchSide=6, PatchesX=1, PatchesY=1)
    op.TextureKind = "Isolated"
    print("spacing  depth   dimples  diameter found  quality")
    for spacing in SPACINGS:
        for depth in DEPTHS:
            op.Spacing, op.Depth = spacing, depth
            plan = patchmill.recompute(op)
            folder = os.path.join(out, "spacing-%g-depth-%g" % (spacing, depth))
            os.makedirs(folder, exist_ok=True)
            program = os.path.join(folder, "program.ngc")
            posted = patchmill.post(job, program)
            marks = patchmill.simulate(op, path=posted[0].path)
            patchmill.report(posted, program, folder, [marks])
            found = marks.data()
            row = (spacing, depth, plan.counts["cut"], found["diameter_mm"] or 0.0, found["quality"])
            print("%7.3f  %5.3f  %7d  %11.3f mm  %7.3f" % row)
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))

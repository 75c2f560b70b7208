"""The strategies beside each other on one face and one machine: time, displacement of marks, verdict.

    patchmill macro strategies.py PART MACHINE

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import sys

import patchmill

TOOL = {"diameter": 2, "flutes": 2, "speed": 1000, "feed": 434.413}


def main(part, machine):
    job = patchmill.job(part, tool=TOOL, machine=machine)
    op = patchmill.texture(job, "largest free-form", Spacing=0.5, PatchSide=8, PatchesX=2, PatchesY=2)
    for strategy in op.getEnumerationsOfProperty("Strategy"):
        op.Strategy = strategy
        op.SameFlute = strategy != "Spindle-locked"
        try:
            plan = patchmill.recompute(op)
        except patchmill.InputError as error:
            print("%-28s %s" % (strategy, error))
            continue
        seconds = plan.path.statistics()["timed_seconds"]
        marks = patchmill.simulate(op, machine=machine)
        off = 1000.0 * marks.data()["place_rms_mm"] if marks.data()["place_rms_mm"] is not None else math.nan
        print("%-28s %7.1f s  off %6.1f um rms  %s" % (strategy, seconds, off, plan.pacing.verdict.sentence))
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))

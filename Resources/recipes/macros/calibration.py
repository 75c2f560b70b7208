"""The calibration patch for the tool, machine and face of a recipe, and storing what the loupe found.

    patchmill macro calibration.py RECIPE PART OUT          # writes OUT/calibration.ngc: mill it
    patchmill macro calibration.py RECIPE PART OUT NUMBER   # of the best dimple: stores the start phase

How to read the patch: docs/calibration.md.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import os
import sys

import patchmill

KEPT = ("Spacing", "Strategy", "SameFlute", "ExtraTurns")  # what the start phase may depend on


def main(recipe, part, out, best=None):
    with open(recipe, encoding="utf-8") as file:
        data = json.load(file)
    if "machine" not in data:
        print("%s names no machine: the start phase belongs to one" % recipe)
        return 2
    first = data["operations"][0]
    kept = {k: v for k, v in first.get("properties", {}).items() if k in KEPT}
    job = patchmill.job(part, data.get("tool"), data["machine"], data.get("offset"), data.get("post"))
    op = patchmill.texture(job, first["faces"], "Calibration", "Calibration", **kept)
    plan = patchmill.recompute(op)
    if best is not None:
        found = patchmill.CalibrationPatch.store(op, int(best))
        print("start phase %.1f degrees, stored with %s" % (found, op.Machine))
        return 0
    os.makedirs(out, exist_ok=True)
    patchmill.post(job, os.path.join(out, "calibration.ngc"))
    print("%d dimples, each %g degrees later than the one before" % (plan.counts["cut"], op.PhaseStep))
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:5]))

"""A texture on each STEP file of a folder: a program and a report each; refusals are told, the rest goes on.

    patchmill macro folder_of_step_files.py FOLDER OUT

For a hundred parts take `patchmill run`: a process for each, limits, an index (docs/batch.md).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import sys

import FreeCAD
import patchmill

TOOL = {"diameter": 2, "flutes": 2, "speed": 1000, "feed": 434.413}


def mill(filename, stem):
    """Writes STEM.ngc and the folder STEM-report; returns the number of dimples."""
    job = patchmill.job(filename, tool=TOOL)
    op = patchmill.texture(job, "largest free-form", Spacing=0.5, PatchSide=14)
    plan = patchmill.recompute(op)
    posted = patchmill.post(job, stem + ".ngc")
    patchmill.report(posted, stem + ".ngc", stem + "-report")
    FreeCAD.closeDocument(job.Document.Name)
    return plan.counts["cut"]


def main(folder, out):
    os.makedirs(out, exist_ok=True)
    failed = 0
    for name in sorted(os.listdir(folder)):
        stem, ending = os.path.splitext(name)
        if ending.lower() not in (".step", ".stp"):
            continue
        try:
            print("%s: %d dimples" % (name, mill(os.path.join(folder, name), os.path.join(out, stem))))
        except patchmill.InputError as error:
            failed += 1
            print("%s: %s" % (name, error))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))

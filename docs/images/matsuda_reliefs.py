"""The picture of docs/cutter-marks.md in which Matsuda's three arrays are cut and recognised:

    tools/freecad docs/images/matsuda_reliefs.py docs/images

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import runpy
import sys
from pathlib import Path

import FreeCAD
import patchmill
from patchmill.reports import relief_pictures

ROOT = Path(__file__).resolve().parents[2]
recipe = runpy.run_path(str(ROOT / "Resources" / "recipes" / "matsuda2008" / "run.py"), run_name="recipe")


def relief_of(array):
    """SimulatedTexture of one patch on the inclined plane."""
    document, _, operation = recipe["make"]("inclined plane", array)
    operation.PatchesX = operation.PatchesY = 1
    patchmill.recompute(operation)
    result = patchmill.simulate(operation, step=0.01)
    print("%s: %s" % (array, result.alignment))
    print(result.text())
    FreeCAD.closeDocument(document.Name)
    return result


def main(folder):
    results = [relief_of(array) for array in recipe["ARRAYS"]]
    figure = relief_pictures.side_by_side(
        [r.heights for r in results],
        [
            "%s: recognised as %s" % (array, r.alignment["state"])
            for array, r in zip(recipe["ARRAYS"], results)
        ],
        results[0].step,
        results[0].origin,
        exaggeration=2.0,
    )
    relief_pictures.save(figure, os.path.join(folder, "cutter-marks-matsuda.png"))


main(sys.argv[1])

"""The experiments of Matsuda, Sasahara & Tsutsumi 2008 in their free form: square patches on an inclined
plane and on a cylinder, with marks in a square array, staggered and drifting.

As a macro:   run(out_folder)
Headless:     tools/freecad Resources/recipes/matsuda2008/run.py out

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import os

import FreeCAD
import Part
import patchmill
from patchmill.freecad import host

V = FreeCAD.Vector
TOOL_DIAMETER, FLUTES, SPEED = 2.0, 2, 1000.0  # mm, 1, rpm
INCLINATION, RADIUS = 25.0, 30.0  # of the plane [degrees], of the cylinder [mm]
# side, cross-feed and feed per tooth [mm]: what Matsuda's condition makes of them is in the names
ARRAYS = {
    "square": (7.0, 0.5, 0.5),
    "staggered": (7.1875, 0.5, 0.5),
    "drifting": (7.0, 0.51, 0.5),
}


def inclined_plane():
    """A block of 44 x 24 mm with an inclined top, and the name of that face."""
    block = Part.makeBox(44, 24, 6, V(-22, -12, -6))
    block.rotate(V(0, 0, 0), V(0, 1, 0), INCLINATION)
    return block, _highest(block)


def cylinder():
    """The side of a lying cylinder, cut so that no dimple is on its top, where the tip would rub."""
    whole = Part.makeCylinder(RADIUS, 44, V(-22, 0, -RADIUS), V(1, 0, 0))
    part = whole.common(Part.makeBox(60, 22, 60, V(-30, 6, -50)))
    curved = [k for k, f in enumerate(part.Faces) if isinstance(f.Surface, Part.Cylinder)]
    return part, "Face%d" % (curved[0] + 1)


def _highest(shape):
    """Name of the face that looks up most."""
    up = [face.normalAt(0, 0).z for face in shape.Faces]
    return "Face%d" % (up.index(max(up)) + 1)


PARTS = {"inclined plane": inclined_plane, "cylinder": cylinder}


def make(part_name, array, name="matsuda2008"):
    """Document, job and operation of one experiment, not yet recomputed."""
    shape, face = PARTS[part_name]()
    document = FreeCAD.newDocument(name)
    part = document.addObject("Part::Feature", "Part")
    part.Shape = shape
    document.recompute()
    job = host.create_job("Job", [part])
    side, cross_feed, feed_per_tooth = ARRAYS[array]
    feed = feed_per_tooth * FLUTES * SPEED
    host.add_ball_end_controller(job, TOOL_DIAMETER, FLUTES, feed, SPEED)
    job.PostProcessor = "linuxcnc"
    job.PostProcessorArgs = "--no-header --no-show-editor --precision=3"
    operation = patchmill.PlanarTexture.Create("Texture", parentJob=job)
    operation.Base = [(job.Model.Group[0], [face])]
    operation.Form, operation.AutoDirection = "Free", True
    operation.FreeSide, operation.CrossFeed = side, cross_feed
    operation.Mapping = "On surface"  # patches touch on the cylinder too
    return document, job, operation


def run(out_folder, say=print):
    """All experiments: G-code, documents and a summary; returns the names of the files written."""
    os.makedirs(out_folder, exist_ok=True)
    names, summary = [], []
    for part_name in PARTS:
        for array in ARRAYS:
            document, job, operation = make(part_name, array)
            plan = patchmill.recompute(operation)
            stem = os.path.join(out_folder, "%s-%s" % (part_name.replace(" ", "-"), array))
            patchmill.post(job, stem + ".ngc")
            document.saveAs(stem + ".FCStd")
            names += [stem + ".ngc", stem + ".FCStd"]
            summary.append(
                {
                    "part": part_name,
                    "array": operation.MarkArray,
                    "marks": plan.counts["cut"],
                    "drift_teeth_per_pass": operation.PhaseDrift,
                    "measured_drift": operation.MeasuredDrift,
                    "largest_difference_teeth": operation.PhaseMiss,
                }
            )
            say("%s, %s: %s" % (part_name, array, operation.MarkArray))
            FreeCAD.closeDocument(document.Name)
    with open(os.path.join(out_folder, "summary.json"), "w", encoding="utf-8") as file:
        json.dump(summary, file, indent=1)
    return names + [file.name]


if __name__ == "__main__":
    import sys

    run(sys.argv[1])

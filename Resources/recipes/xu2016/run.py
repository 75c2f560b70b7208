"""The experiment of Xu & Sasahara 2016, Tables 1 and 2: a STEP file in, a program and a report out.

As a macro:   run(step_file, out_folder)
Headless:     freecadcmd -c "exec(open('run.py').read())" -M MODULE_FOLDER   (see tools/demo)

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os

import FreeCAD
import Part
import patchmill
from patchmill.advice import apply, assessment, choice
from patchmill.freecad import host

# Table 2 of the paper, and what it leaves open: 14 dimples a side make 8 x 8 patches of 56 mm.
TOOL_DIAMETER, FLUTES, SPEED, FEED, SPACING = 2.0, 2, 1000.0, 434.413, 0.5
PATCH_SIDE, PATCHES = 14, 8
MACHINE, WINDOW = "linuxcnc-mill", ((-24.0, -24.0), (-17.0, -17.0))  # where both textures are compared


def top_face(shape):
    """Name of the face that a vertical ray from above meets at the part's middle."""
    box = shape.BoundBox
    ray = Part.makeLine((0, 0, box.ZMax + 10), (0, 0, box.ZMin - 10))
    heights = []
    for number, face in enumerate(shape.Faces, 1):
        hits = face.common(ray).Vertexes or face.section(ray).Vertexes
        if hits:
            heights.append((max(v.Z for v in hits), "Face%d" % number))
    return max(heights)[1]


def make_document(step_file, name="xu2016"):
    """A new document with the part of `step_file`; returns (document, part object)."""
    document = FreeCAD.newDocument(name)
    part = document.addObject("Part::Feature", "Block")
    part.Shape = Part.read(step_file)
    document.recompute()
    return document, part


def make_job(part, decimals=3, direction="Forward"):
    """A Job with the paper's tool and a CurvedTexture on the part's top face: (job, operation)."""
    job = host.create_job("Job", [part])
    host.add_ball_end_controller(job, TOOL_DIAMETER, FLUTES, FEED, SPEED, direction)
    job.PostProcessor = "linuxcnc"
    job.PostProcessorArgs = "--no-header --no-show-editor --precision=%d" % decimals
    operation = patchmill.CurvedTexture.Create("CurvedTexture", parentJob=job)
    model = job.Model.Group[0]
    operation.Base = [(model, [top_face(model.Shape)])]
    operation.Spacing = SPACING
    operation.PatchSide = PATCH_SIDE
    operation.PatchesX = operation.PatchesY = PATCHES
    operation.Decimals = decimals
    return job, operation


def as_patchmill_proposes(step_file, say):
    """The same texture with the values that PatchMill proposes for a LinuxCNC mill, planned in a document of
    its own, which is closed again."""
    document, part = make_document(step_file, "proposed")
    operation = make_job(part)[1]
    operation.Machine = MACHINE
    given = operation.Proxy.texture_input(operation)
    apply.set_fields(
        operation, choice.choose(assessment.with_simulation(patchmill.simulate), given, True).fields
    )
    plan = patchmill.recompute(operation)
    say("proposed: %s, %s; %s" % (operation.Strategy, operation.Order, operation.Verdict))
    FreeCAD.closeDocument(document.Name)
    return plan


def side_by_side(published, proposed):
    """What a LinuxCNC mill makes of both on the same steep place: pairs for write_report."""
    pairs = (("as published", published), ("as PatchMill proposes", proposed))
    return [(what, patchmill.simulate(plan, machine=MACHINE, window=WINDOW)) for what, plan in pairs]


def run(step_file, out_folder, say=print):
    """Texture, post, save and report; returns the names of the files written."""
    os.makedirs(out_folder, exist_ok=True)
    gcode = os.path.join(out_folder, "xu2016.ngc")
    saved = os.path.join(out_folder, "xu2016.FCStd")
    say("reading %s" % step_file)
    document, part = make_document(step_file)
    job, operation = make_job(part)
    say("texturing %s of %s" % (operation.Base[0][1][0], part.Label))
    plan = patchmill.recompute(operation)
    say("%d dimples; left out: %s" % (plan.counts["cut"], operation.LeftOut or "none"))
    say("posting with FreeCAD's %s post-processor, and reading the text back" % job.PostProcessor)
    posted = patchmill.post(job, gcode)
    say("saving the document")
    document.saveAs(saved)
    say("cutting the posted program in the simulator")
    simulated = patchmill.simulate(operation, path=posted[0].path)
    say("looking for the values that PatchMill proposes for the same face")
    beside = side_by_side(plan, as_patchmill_proposes(step_file, say))
    say("drawing pictures and writing the report")
    reports = patchmill.write_report(posted[0], plan, gcode, out_folder, simulated, beside)
    FreeCAD.closeDocument(document.Name)
    return [gcode, saved] + reports


if __name__ == "__main__":
    import sys

    names = run(sys.argv[1], sys.argv[2], lambda text: print("-- " + text, flush=True))
    print("done:")
    for name in names:
        print("  " + name)

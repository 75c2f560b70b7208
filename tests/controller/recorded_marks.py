"""What LinuxCNC's planner makes of three ways to keep the phase, cut with its own log: FreeCAD posts each
program, LinuxCNC runs it, the recording goes through patchmill.simulate. Makes the picture and the table of
docs/cutter-marks.md:

    tools/freecad tests/controller/recorded_marks.py docs/images

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import os
import sys
import tempfile
from pathlib import Path

import FreeCAD
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path += [str(HERE), str(HERE.parent / "host")]

import _patchmill as core  # noqa: E402
import patchmill  # noqa: E402
from harness import controller, phase  # noqa: E402
from patchmill.machine import machines  # noqa: E402
from patchmill.reports import relief_pictures  # noqa: E402
from recipe import STEP, run  # noqa: E402

ACCELERATION, VELOCITY = 2000.0, 100.0  # of the simulated machine: mm/s², mm/s
CORNER, SIDE, SENSE, FLUTES = -27.5, 14, -1, 2  # the steepest corner of the Bezier surface
# title, strategy, one flute makes all dimples, extra turns
CASES = [
    ("zigzag, as published", "Constant feed", True, 5.0),
    ("feed per move, open loop", "Feed per move", False, 0.0),
    ("zigzag, legs fitted to the stops", "Constant feed, fitted stops", True, 5.0),
    ("spindle-locked", "Spindle-locked", False, 0.0),
]
STOPS = 3  # moments at which a program itself lets the motion queue run empty


def make_machine(folder):
    """A machine file with the limits of the simulated machine."""
    os.environ["PATCHMILL_MACHINES"] = folder
    data = dict(machines.load("linuxcnc-mill").data)
    data["linear_axes"] = dict(
        data["linear_axes"], acceleration_mm_s2=ACCELERATION, velocity_mm_s=VELOCITY
    )
    with open(os.path.join(folder, "simulated.json"), "w", encoding="utf-8") as file:
        json.dump(data, file)


def make_operation(name, strategy, same_flute, extra_turns):
    """(job, operation) of one patch on the surface's corner."""
    _, part = run.make_document(STEP, name)
    job, op = run.make_job(part, 4)
    job.PostProcessor = "patchmill_linuxcnc"
    job.PostProcessorArgs = "--precision=4"
    op.PatchSide, op.PatchesX, op.PatchesY = SIDE, 1, 1
    op.AutoOrigin = False
    middle = CORNER + 0.25 * (SIDE - 1)
    op.Origin = (middle, middle, 0)
    op.Strategy, op.Machine = strategy, "simulated"
    op.SameFlute, op.ExtraTurns = same_flute, extra_turns
    op.PostUnheld = True  # two of them are lost on this machine, as the picture shows
    return job, op


def targets_of(plan, program):
    """Where each dimple is in the program and which phase it wants."""
    with open(program, encoding="ascii") as file:
        section = core.read_gcode(file.read(), plan.input.tool)[-1]
    core.match_plan(section.path, plan.path, 0.5e-4)
    ends = np.flatnonzero(section.path.dimples >= 0)
    number = section.path.dimples[ends]
    n = plan.dimples.normals[number]
    return phase.Targets(
        np.array(section.lines)[ends],
        section.path.tips[ends],
        np.degrees(np.arctan2(-n[:, 1], -n[:, 0])),
        plan.dimples.patches[number],
    )


def cut(folder, name, strategy, same_flute, extra_turns):
    """SimulatedTexture of the recording, phase.Report, and SimulatedTexture of the motion model."""
    job, op = make_operation(name, strategy, same_flute, extra_turns)
    plan = patchmill.recompute(op)
    program = os.path.join(folder, name + ".ngc")
    patchmill.post(job, program)
    machine = controller.Machine(acceleration=ACCELERATION, velocity=VELOCITY)
    log = controller.run(program, machine, stops=STOPS)
    report = phase.measure(log, targets_of(plan, program), FLUTES, SENSE)
    azimuth = SENSE * np.radians(360.0 * log.turns - report.offset)  # as a calibration patch would find it
    samples = np.column_stack([log.time, log.tip, azimuth])
    from_start = log.time > report.time[0] - 1.0  # the spindle stands still before
    result = patchmill.simulate(op, samples=samples[from_start], step=0.01)
    predicted = patchmill.simulate(op, machine="simulated", step=0.01)
    FreeCAD.closeDocument(op.Document.Name)
    return result, report, predicted


def main(out):
    reliefs, titles = [], []
    print(
        "| path | phase, rms | found of 196 | extra | off their places, rms | array | quality "
        "| off by the motion model, rms | quality |"
    )
    print("|" + " --- |" * 9)
    with tempfile.TemporaryDirectory(prefix="patchmill-recorded-") as folder:
        make_machine(folder)
        for number, (title, *case) in enumerate(CASES):
            result, report, predicted = cut(folder, "case%d" % number, *case)
            d = result.data()
            p = predicted.data()
            print(
                "| %s | %.1f° | %d | %d | %.1f µm, %.1f %% of f | %s | %.2f | %.1f µm | %.2f |"
                % (
                    title,
                    report.rms,
                    d["found"],
                    d["extra"],
                    1e3 * d["place_rms_mm"],
                    100 * d["place_rms_share"],
                    d["alignment"],
                    d["quality"],
                    1e3 * p["place_rms_mm"],
                    p["quality"],
                )
            )
            reliefs.append(result.heights)
            titles.append("%s\n%d of %d found, rms %.0f µm" % (
                title, d["found"], d["planned"], 1e3 * d["place_rms_mm"]))
    figure = relief_pictures.side_by_side(
        reliefs, titles, result.step, result.origin, exaggeration=2.0, columns=2
    )
    relief_pictures.save(figure, os.path.join(out, "cutter-marks-recorded.png"))


if __name__ == "__main__":
    main(sys.argv[1])

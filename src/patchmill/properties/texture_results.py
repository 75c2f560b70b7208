"""What a texture operation shows of its plan: the tables of these properties, and their values.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math

import FreeCAD

from patchmill.textures.free_form import phase_differences
from patchmill.textures.laid import coverage

RESULTS = [
    ("App::PropertyInteger", "DimpleCount", "Result", "Dimples that are milled"),
    ("App::PropertyString", "LeftOut", "Result", "Lattice points left out, by reason"),
    ("App::PropertyFloat", "TurnsPerDimple", "Result", "Mean spindle turns from dimple to dimple"),
    ("App::PropertyString", "Verdict", "Result", "Whether the machine can hold the phase"),
    ("App::PropertyFloat", "MachiningTime", "Result", "Time of all moves, rapids too, in seconds"),
    ("App::PropertyLength", "FoundSpacing", "Result", "Distance of neighbouring dimples"),
    ("App::PropertyLength", "FoundDepth", "Result", "Depth of the dimples"),
    ("App::PropertyLength", "FoundDiameter", "Result", "Diameter of a dimple's rim"),
    ("App::PropertyFloat", "FoundAreaShare", "Result", "Share of the faces that is dimple, 0 to 1"),
    ("App::PropertyLength", "FoundRidgeHeight", "Result", "Height of what stays between dimples"),
    ("App::PropertyAngle", "RubbingTilt", "Result", "Tilt below which the tip rubs in a dimple"),
    ("App::PropertyInteger", "RubbingDimples", "Result", "Milled dimples in which the tip rubs"),
    (
        "App::PropertyLength",
        "SpacingLeast",
        "Result",
        "Least distance of any two dimples, straight in space",
    ),
    ("App::PropertyLength", "SpacingGreatest", "Result", "Greatest distance of neighbours, measured"),
    ("App::PropertyFloat", "SpacingRms", "Result", "Root mean square of distance / spacing - 1"),
    ("App::PropertyAngle", "LatticeAngleLeast", "Result", "Least angle of lattice directions, measured"),
    (
        "App::PropertyAngle",
        "LatticeAngleGreatest",
        "Result",
        "Greatest angle of lattice directions, measured",
    ),
    (
        "App::PropertyFloat",
        "Coverage",
        "Result",
        "Milled dimples, each worth a cell of the lattice, over the faces' area; 0: not known",
    ),
    ("App::PropertyString", "Remarks", "Result", "What was decided for you, and what is not covered"),
    ("App::PropertyVector", "FoundDirection", "Result", "Direction of the projection"),
]
FREE_FORM_RESULTS = [
    ("App::PropertyString", "MarkArray", "Result", "How marks of neighbouring passes stand"),
    ("App::PropertyFloat", "PhaseDrift", "Result", "Predicted drift from pass to pass, in teeth"),
    ("App::PropertyFloat", "MeasuredDrift", "Result", "The same, measured on the path"),
    (
        "App::PropertyFloat",
        "PhaseMiss",
        "Result",
        "Largest difference of the phase measured on the path and predicted, in teeth",
    ),
]


def show_results(obj, plan):
    """Sets the read-only results of a texture operation from its PlannedTexture."""
    statistics = plan.path.statistics()
    verdict = plan.pacing.verdict
    _set(
        obj,
        DimpleCount=plan.counts["cut"],
        LeftOut=", ".join(
            "%s: %d" % (name, n) for name, n in plan.counts.items() if n and name != "cut"
        ),
        Verdict=verdict.sentence if verdict else "Unknown: no machine is named.",
        TurnsPerDimple=statistics["cut_turns"] / max(1, plan.counts["cut"]),
        MachiningTime=plan.seconds,
        FoundDirection=FreeCAD.Vector(*plan.plane.direction),
        FoundSpacing=plan.size["spacing"],
        FoundDepth=plan.size["depth"],
        FoundDiameter=plan.size["diameter"],
        FoundAreaShare=plan.size["area_share"],
        FoundRidgeHeight=plan.size["ridge_height"],
        RubbingTilt=math.degrees(plan.size["least_tilt"]),
        RubbingDimples=plan.rubbing(),
        Remarks=" ".join(plan.remarks),
    )
    if plan.free is not None:
        _show_free_form(obj, plan)
        return
    spread = plan.spread()
    _set(
        obj,
        SpacingLeast=spread["nearest"] * plan.size["spacing"],
        Coverage=coverage(plan) or 0.0,
        SpacingGreatest=spread["greatest"] * plan.size["spacing"],
        SpacingRms=spread["rms"],
        LatticeAngleLeast=math.degrees(spread["least_angle"]),
        LatticeAngleGreatest=math.degrees(spread["greatest_angle"]),
    )


def _show_free_form(obj, plan):
    phases = phase_differences(plan)
    _set(
        obj,
        MarkArray=phases["state"],
        PhaseDrift=phases["drift"],
        MeasuredDrift=phases["measured_drift"],
        PhaseMiss=phases["largest_miss"],
        SpacingLeast=0.0,
        SpacingGreatest=0.0,
        Coverage=0.0,
        SpacingRms=0.0,
        LatticeAngleLeast=0.0,
        LatticeAngleGreatest=0.0,
    )


def _set(obj, **results):
    for name, value in results.items():
        setattr(obj, name, value)

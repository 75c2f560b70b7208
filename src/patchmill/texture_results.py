"""What a texture operation shows of its plan: the properties in texture_properties.RESULTS.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math

import FreeCAD


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
        MachiningTime=statistics["timed_seconds"],
        FoundDirection=FreeCAD.Vector(*plan.plane.direction),
        FoundSpacing=plan.size["spacing"],
        FoundDepth=plan.size["depth"],
        FoundDiameter=plan.size["diameter"],
        FoundAreaShare=plan.size["area_share"],
        FoundRidgeHeight=plan.size["ridge_height"],
        RubbingTilt=math.degrees(plan.size["least_tilt"]),
        RubbingDimples=plan.rubbing(),
    )
    spread = plan.spread()
    _set(
        obj,
        SpacingLeast=spread["least"] * plan.size["spacing"],
        SpacingGreatest=spread["greatest"] * plan.size["spacing"],
        SpacingRms=spread["rms"],
        LatticeAngleLeast=math.degrees(spread["least_angle"]),
        LatticeAngleGreatest=math.degrees(spread["greatest_angle"]),
    )


def _set(obj, **results):
    for name, value in results.items():
        setattr(obj, name, value)

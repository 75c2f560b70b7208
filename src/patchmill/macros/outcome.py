"""What became of a job's textures: reports with pictures, and the figures that tables and indexes tell.

    posted = patchmill.post(job, "block.ngc")
    patchmill.report(posted, "block.ngc", "block-report")

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import os
import re
from typing import Any, Dict, List

from patchmill.operations.computed import planned
from patchmill.reports import report as reports
from patchmill.verify.posted_texture import PostedTexture


def report(posted: Any, program: str, folder: str, simulated: Any = None) -> List[str]:
    """Writes report.json, report.html and pictures of each texture of a program; returns the files' names.

    posted: what patchmill.post or patchmill.read_back returned. With one texture they are in `folder`,
    which is made if it is not there; with several each is in a folder of its own below it. simulated: results
    of patchmill.simulate in the order of the textures, or None. Raises OSError if it cannot write there."""
    found = textures(posted)
    results = list(simulated or [None] * len(found))
    if len(results) != len(found):
        raise ValueError("%d simulations of %d textures" % (len(results), len(found)))
    names = []
    for number, (one, result) in enumerate(zip(found, results)):
        own = folder if len(found) == 1 else os.path.join(folder, _folder_name(number, one))
        os.makedirs(own, exist_ok=True)
        names += reports.write_report(one, planned(one.operation), program, own, result)
    return names


def textures(posted: Any) -> List[Any]:
    """The PostedTextures among what was read back."""
    return [one for one in posted if isinstance(one, PostedTexture)]


def _folder_name(number: int, one: Any) -> str:
    parts = [str(number + 1), re.sub(r"[^A-Za-z0-9_-]", "_", one.operation.Label)[:60], one.offset]
    return "-".join(p for p in parts if p)


def figures(one: Any) -> Dict[str, Any]:
    """What an index tells of one PostedTexture: lengths in mm, times in seconds, angles in degrees."""
    plan = planned(one.operation)
    verdict = plan.pacing.verdict
    return {
        "name": one.operation.Label,
        "faces": sorted(name for _, names in one.operation.Base for name in names),
        "dimples": int(plan.counts["cut"]),
        "left_out": {k: int(n) for k, n in plan.counts.items() if n and k != "cut"},
        "seconds": round(plan.seconds, 3),
        "verdict": verdict.sentence if verdict else "Unknown: no machine is named.",
        "phase_error_max_degrees": round(math.degrees(float(one.errors["largest"])), 4),
        "phase_error_rms_degrees": round(math.degrees(float(one.errors["rms"])), 4),
        "check": one.check.outcome if one.check else "unknown",
        "check_sentence": one.check.sentence if one.check else "Unknown: not checked.",
    }

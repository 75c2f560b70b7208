"""report.json and report.html of one posted texture, with pictures.

Everything in it comes from the plan and from the path as it was read back from the posted text.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import html
import json
import math
import os

import _patchmill as core
import numpy as np

from patchmill.machine import machining_time
from patchmill.system import files
from patchmill.reports import pictures, relief_report


def report_data(posted, plan, gcode, simulated=None):
    """What report.json holds, as a dict. Angles in degrees, lengths in mm, times in seconds."""
    errors = np.degrees(posted.errors["error"])
    statistics = posted.path.statistics()
    given = plan.input
    cut = plan.dimples.states == core.DimpleState.CUT
    tilts = np.degrees(_tilts(plan))[cut]
    return {
        "program": os.path.basename(gcode),
        "strategy": given.strategy,
        "machine": plan.machine.data["name"] if plan.machine else None,
        "verdict": plan.pacing.verdict.sentence if plan.pacing.verdict else "Unknown: no machine is named.",
        "dimples": {"tried": len(plan.dimples), "by_state": plan.counts},
        "patches": {
            "shape": given.patch_shape,
            "count": len(plan.division),
            "side": given.patch_side,
        },
        "spacing_mm": given.spacing,
        "tool": {"ball_diameter_mm": 2 * given.tool.radius, "flutes": given.tool.flutes},
        "spindle": {"rpm": round(60 * given.spindle.speed, 6), "sense": given.spindle.sense},
        "feed_mm_min": round(60 * plan.feed, 6),
        "time_s": plan.seconds,
        "turns_per_dimple": _turns_per_dimple(plan, posted.path),
        "lengths_mm": {k: statistics[k + "_length_mm"] for k in ("cut", "link", "rapid")},
        "tilt_degrees": {"least": float(tilts.min()), "greatest": float(tilts.max())},
        "tip_inside_dimple": _tip_inside(plan, tilts),
        "read_back": {
            "decimals": given.decimals,
            "moves_lost": posted.match.lost_moves,
            "moves_extra": posted.match.extra_moves,
            "largest_position_miss_mm": posted.match.largest_miss,
        },
        "phase_error_degrees": {
            "largest": math.degrees(posted.errors["largest"]),
            "rms": math.degrees(posted.errors["rms"]),
            "source": "the posted text" if "runs" in posted.errors else "the machine's motion model",
            "drift_per_1000_dimples": _drift(errors),
            "at_each_dimple": [round(float(e), 5) for e in errors],
            "dimple_numbers": [int(n) for n in posted.errors["dimple"]],
        },
        "gouge_and_collision": _check_data(posted.check),
        "marks": simulated.data() if simulated else None,
        "not_checked": _not_checked(plan, posted.check),
    }


def _drift(errors):
    """Slope of the error over the dimples' order, least squares, per 1000 dimples."""
    if len(errors) < 3:
        return 0.0
    return 1000.0 * float(np.polyfit(np.arange(len(errors)), errors, 1)[0])


def _check_data(check):
    if check is None:
        return None
    worst = check.worst
    return {
        "outcome": check.outcome,
        "sentence": check.sentence,
        "findings": len(check.findings),
        "worst": worst and {"part": worst.part, "place_mm": worst.place, "depth_mm": worst.depth},
        "tool_sections_mm": check.sections,
    }


def _not_checked(plan, check):
    left = []
    if plan.pacing.verdict is None:
        left.append("whether the machine keeps the feed: a planner that slows down loses the phase")
    if check is None or check.outcome == "unknown":
        left.append("gouge, and collision of shank and holder")
    left.append("clamps, stock that is still there, and rapids that a machine does not run straight")
    return left


def _tilts(plan):
    return core.tilts(plan.dimples, (0.0, 0.0, 1.0))


def _turns_per_dimple(plan, path):
    """Least, mean and greatest spindle turns from one place of a patch to the next, links apart."""
    dimples, turns = path.dimples, np.nan_to_num(path.turns)
    ends = np.flatnonzero(dimples != core.NO_DIMPLE)
    between = np.diff(np.cumsum(turns)[ends])
    number, patch = dimples[ends], plan.dimples.patches[dimples[ends]]
    within = between[(np.diff(number) == 1) & (np.diff(patch) == 0)]
    if len(within) == 0:
        return None
    return {
        "least": float(within.min()),
        "mean": float(within.mean()),
        "greatest": float(within.max()),
    }


def _tip_inside(plan, tilts):
    """How many dimples are so near to the tool's tip that it lies inside them: tilt < asin(f / 2R)."""
    ratio = plan.input.spacing / (2.0 * plan.input.tool.radius)
    limit = math.degrees(math.asin(min(1.0, ratio)))
    return {"limit_degrees": limit, "count": int((tilts < limit).sum())}


def write_report(posted, plan, gcode, folder, simulated=None, beside=()):
    """Writes report.json, report.html and the pictures into `folder`; returns their names. `simulated`: a
    SimulatedTexture of the posted path (patchmill.simulate), or None. `beside`: textures of one window of the
    face to be compared, pairs (what it is, SimulatedTexture)."""
    data = report_data(posted, plan, gcode, simulated)
    names = {
        "dimples": pictures.draw_dimples(plan, os.path.join(folder, "dimples.png")),
        "path": pictures.draw_path(plan, posted.path, os.path.join(folder, "path.png")),
        "phase": pictures.draw_phase_error(posted.errors, os.path.join(folder, "phase-error.png")),
    }
    captions = {
        "dimples": "Dimples over the patches, seen along the projection direction, and one patch.",
        "path": "Tool tip over one patch and its links.",
        "phase": "Phase error at every dimple, from %s." % data["phase_error_degrees"]["source"],
    }
    for drawn in _reliefs(simulated, beside, folder):
        names.update({k: name for k, (name, _) in drawn.items()})
        captions.update({k: caption for k, (_, caption) in drawn.items()})
    json_name = os.path.join(folder, "report.json")
    files.write(json_name, json.dumps(data, indent=1))
    html_name = os.path.join(folder, "report.html")
    marks = list(simulated.rows()) if simulated else []
    page = _page(data, {k: os.path.basename(v) for k, v in names.items()}, captions, marks)
    files.write(html_name, page)
    return [json_name, html_name] + list(names.values())


def _reliefs(simulated, beside, folder):
    """Pictures as relief_report makes them, those side by side first."""
    return [
        *([relief_report.draw_beside(beside, folder)] if beside else []),
        *([relief_report.draw(simulated, folder)] if simulated else []),
    ]


def _rows(data):
    turns, phase = data["turns_per_dimple"], data["phase_error_degrees"]
    yield "Program", data["program"]
    yield "Strategy", data["strategy"]
    yield "Machine", data["machine"] or "not named"
    yield "Verdict", data["verdict"]
    yield "Tool", "ball end mill Ø%(ball_diameter_mm)g mm, %(flutes)d flutes" % data["tool"]
    yield "Spindle", "S%(rpm)g %(sense)s" % data["spindle"]
    yield "Feed", "%.3f mm/min" % data["feed_mm_min"]
    yield "Patches", "%(count)d, %(shape)s, %(side)d dimples a side" % data["patches"]
    yield "Spacing", "%g mm" % data["spacing_mm"]
    for state, count in data["dimples"]["by_state"].items():
        yield ("Dimples" if state == "cut" else "Left out: " + state), "{:,}".format(count)
    tip = data["tip_inside_dimple"]
    yield (
        "Dimples that hold the tool's tip",
        "{:,} are tilted by less than {:.1f}°; expect blurred marks there".format(
            tip["count"], tip["limit_degrees"]
        ),
    )
    yield "Time", machining_time.in_words(data["time_s"])
    if turns:
        yield (
            "Spindle turns per dimple",
            "%(mean).3f (%(least).3f to %(greatest).3f)" % turns,
        )
    yield (
        "Phase error, from " + phase["source"],
        "largest %.3f°, rms %.3f°" % (phase["largest"], phase["rms"]),
    )
    yield "Drift", "%.5f° per 1000 dimples" % phase["drift_per_1000_dimples"]
    check = data["gouge_and_collision"]
    yield "Gouge and collision", check["sentence"] if check else "not checked"


_STYLE = """
body { font: 16px/1.5 sans-serif; color: #222; max-width: 60em; margin: 2em auto; padding: 0 1em }
table { border-collapse: collapse } th { text-align: left; font-weight: normal; color: #555 }
th, td { padding: .2em 1.5em .2em 0; border-bottom: 1px solid #ddd; vertical-align: top }
img { max-width: 100%; margin: 1em 0 0 } figcaption { color: #555 }
"""


def _table(rows):
    return "<table>%s</table>" % "\n".join(
        "<tr><th>%s</th><td>%s</td></tr>" % (html.escape(k), html.escape(v)) for k, v in rows
    )


def _page(data, images, captions, marks):
    figures = "\n".join(
        '<figure><img src="%s" alt="%s"><figcaption>%s</figcaption></figure>'
        % (html.escape(images[k]), k, html.escape(captions[k]))
        for k in captions
    )
    simulated = "<h2>The texture before it is cut</h2>%s" % _table(marks) if marks else ""
    title = html.escape(data["program"])
    unchecked = "".join("<li>%s</li>" % html.escape(t) for t in data["not_checked"])
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>%s</title>'
        "<style>%s</style></head><body><h1>%s</h1>\n%s\n%s\n%s\n"
        "<h2>Not checked</h2><ul>%s</ul></body></html>\n"
        % (title, _STYLE, title, _table(_rows(data)), simulated, figures, unchecked)
    )

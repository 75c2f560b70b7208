"""The table of tools/survey-one-click: a row for each part and machine, in Markdown.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import argparse
import contextlib
import math
import pathlib
import signal
import sys
import time
from dataclasses import replace

import _patchmill as core
import FreeCAD
import numpy as np
import one_click
import other_parts
import patchmill
from _patchmill import InputError
from patchmill.advice import apply, assessment, cells, choice, companions, room, verdict
from patchmill.advice.found import GOOD, GOOD_FRACTION, Assessment
from patchmill.textures.order import rows
from patchmill.textures.plan import plan_texture
from patchmill.verify import best_speed
from patchmill_gui.panels import texture_head

MACHINES = ("linuxcnc-mill", "table-table-ac")
COLUMNS = (
    "part", "machine", "one click: head", "document", "fix", "after it: head", "document",
    "dimples", "values", "min", "foreseen", "times the best", "in the way", "search s", "cpu s",
)  # fmt: skip
SHORT = {"Spindle-locked": "locked", "Constant feed, fitted stops": "fitted", "Feed per move": "feed"}
COLOURS = {verdict.GOOD: "green", verdict.DOUBTFUL: "amber", verdict.BAD: "red"}
FAR = 1.3  # times a faster point: of those that are faster by more it is asked whether they are good
SPEEDS = 3  # the highest ones that are chosen from, beside the first and the one that was chosen
SQUARES = 24  # of a document, spread over its faces


def head(operation):
    """What the head of the panel says of a document: (colour, sentence, minutes of milling)."""
    try:
        plan = patchmill.recompute(operation)
    except InputError as error:
        return "red", str(error), math.nan
    found = one_click.together(operation, plan)
    phase = plan.pacing.verdict
    sentence = texture_head.verdict_of(found, phase)[1]
    return COLOURS[verdict.judge(found, phase)[0]], sentence, _minutes(operation)


def _plans(operation):
    """PlannedTextures of an operation and of those that share its faces; none where it has none."""
    if operation.Proxy.planned is None:
        return []
    return [operation.Proxy.planned, *(other.Proxy.planned for other in companions.of(operation))]


def _minutes(operation):
    return sum(plan.path.statistics()["timed_seconds"] for plan in _plans(operation)) / 60.0


def touching(operation):
    """'' where posting finds nothing in the tool's way, else what it says."""
    checked = [patchmill.check(each) for each in (operation, *companions.of(operation))]
    return " / ".join(result.sentence for result in checked if not result.clear)


def judged(operation):
    """What the document is worth, as the machine's model runs it, borders and links included: 'part of the
    area whose cells are as planned; part of the dimples in squares of GOOD quality; quality of all squares'.
    '-' where nothing is planned; 'steep' where the texture is laid on faces that are too steep for one
    relief over the plane: there the head looks at patches from their own side, and this at none."""
    plans = _plans(operation)
    if not plans:
        return "-"
    worth = worth_of(plans)
    return "steep" if worth is None else "%.1f %%; %.0f %%; %.3f" % worth


def worth_of(plans):
    """(per cent of the area, per cent of the dimples, quality) of PlannedTextures, as judged() says; None
    where one of them is steep."""
    if any(p.asked.mapping != "Projected" and cells.steepest(p) > assessment.STEEP for p in plans):
        return None
    results = [
        patchmill.simulate(plan, machine=plan.machine, window=window)
        for plan in plans
        for window in cells.squares(plan, SQUARES)
    ]
    quality = np.array([result.quality for result in results])
    planned = np.array([len(result.found["dimple"]) for result in results])
    marks = planned + [len(result.found["extra"]) for result in results]
    squares = planned[quality >= GOOD].sum() / planned.sum()
    share = cells.good_share(results)
    whole = np.average(quality, weights=marks)
    return 100.0 * share, 100.0 * squares, whole


def values(operation):
    return "%s, %s, S%.0f" % (
        SHORT.get(operation.Strategy, operation.Strategy),
        operation.Order,
        operation.ToolController.SpindleSpeed,
    )


def times_best(operation, start_speed):
    """Time over that of the fastest point that holds, of both orders, both directions of rows and the highest
    speeds; where that is FAR, also over the fastest that is good and clear, of those that are FAR faster."""
    plan = operation.Proxy.planned
    if plan is None:
        return "-"
    given = plan.asked
    ladder = choice.speeds(given_at(given, start_speed), plan.machine)[-SPEEDS:]
    speeds = [round(start_speed), round(60.0 * given.spindle.speed), *ladder]
    points = []
    for direction in (rows.ALONG_X, rows.ALONG_Y):
        turned = plan_texture(replace(given, row_direction=direction))
        curve = best_speed.of_plan(turned, speeds, (rows.HELIX, rows.ROWS)).curve
        points += [(point.seconds, direction, point) for point in curve if point.holds]
    points.sort(key=lambda point: point[:2])
    if not points:
        return "-"
    seconds = plan.path.statistics()["timed_seconds"]
    said = ["%.2f" % (seconds / points[0][0])]
    if seconds / points[0][0] > FAR:
        least = min(GOOD_FRACTION, one_click.assess(given, 3).good_fraction) - 1e-9
        model = apply.model_of(operation)
        faster = (point for point in points if seconds / point[0] > FAR)
        good = next((point[0] for point in faster if is_good_at(given, model, *point[1:], least)), None)
        said.append("%.2f" % (seconds / good) if good else "none of them good")
    return " / ".join(said)


def is_good_at(given, model, direction, point, least):
    """Whether a texture is good and clear of a `model` with rows in a direction, at a best_speed.SpeedPoint;
    where only patches say it, on `least` of the faces or more."""
    asked = replace(given_at(given, point.rpm), row_direction=direction, order=point.order)
    plan = plan_texture(asked)
    if room.held_against(Assessment(0, 0.0, {}), plan, model).touches:
        return False
    worth = worth_of([plan])
    if worth is None:  # steep: patches are seen from their own side
        found = one_click.assess(asked, 3)
        return found.remains_good and found.good_fraction >= least
    return worth[0] >= 95.0 and worth[2] >= GOOD


def given_at(given, rpm):
    """A TextureInput with another spindle speed."""
    return replace(given, spindle=core.Spindle(rpm / 60.0, given.spindle.sense))


def row(name, machine):
    """Cells of a row, as far as they are known when the time is over."""
    cells = [name, machine] + [""] * (len(COLUMNS) - 2)
    began = time.process_time()

    def note(column, text):
        cells[column] = text
        cells[-1] = "%.0f" % (time.process_time() - began)

    shape, face = other_parts.PARTS[name]()
    operation = one_click.texture(shape, face, machine)
    yield cells
    start_speed = operation.ToolController.SpindleSpeed
    fields, before = {}, one_click.cutting(operation)
    begin = time.process_time()
    with contextlib.suppress(InputError):  # the head says so, and the remedies are looked for
        fields = one_click.choose_for(operation).fields
    chosen = "%.1f" % (time.process_time() - begin)
    note(13, chosen)
    colour, sentence, minutes = head(operation)
    note(2, "%s: %s" % (colour, sentence))
    note(3, judged(operation))
    if colour != "green":
        begin = time.process_time()
        found = one_click.remedies_of(operation, fields, before)
        note(13, "%s, %.1f" % (chosen, time.process_time() - begin))
        note(4, " / ".join(texture_head.remedy_text(one) for one in found) or "none")
        if found:
            apply.take(operation, found[0])
            colour, sentence, minutes = head(operation)
            note(5, "%s: %s" % (colour, sentence))
            note(6, judged(operation))
            note(10, "%.2f" % (found[0].assessment.seconds / 60.0))
    if operation.Proxy.planned is not None:
        note(12, touching(operation) or "clear")
    plan = operation.Proxy.planned
    note(7, str(plan.counts["cut"] if plan else 0))
    note(8, values(operation))
    note(9, "%.2f" % minutes)
    note(11, times_best(operation, start_speed))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--seconds", type=int, default=240)
    parser.add_argument("--to", type=pathlib.Path)
    parser.add_argument("names", nargs="*")
    given = parser.parse_args()
    done = given.to.read_text() if given.to and given.to.exists() else ""
    out = given.to.open("a") if given.to else sys.stdout
    if not done:
        print("| %s |\n|%s" % (" | ".join(COLUMNS), " --- |" * len(COLUMNS)), file=out, flush=True)
    pairs = [tuple(one.split("@")) for one in given.names if "@" in one]
    wanted = [a for a in given.names if a not in MACHINES and "@" not in a]
    machines = [a for a in given.names if a in MACHINES] or MACHINES
    pairs += [(part, key) for part in (wanted or (() if pairs else other_parts.TABLE)) for key in machines]

    def over(*_):
        raise TimeoutError

    signal.signal(signal.SIGPROF, over)
    for part, key in pairs:
        if "| %s | %s |" % (part, key) in done:
            continue
        cells = [part, key]
        signal.setitimer(signal.ITIMER_PROF, given.seconds)  # however busy the computer is
        try:
            for cells in row(part, key):  # noqa: B007  they are filled in
                pass
        except TimeoutError:
            cells[-1] = "over %d s" % given.seconds
        signal.setitimer(signal.ITIMER_PROF, 0)
        print("| %s |" % " | ".join(cells), file=out, flush=True)
        for name in FreeCAD.listDocuments():
            FreeCAD.closeDocument(name)


main()

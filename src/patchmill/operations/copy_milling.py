"""CopyMilling: a ball or bull nose end mill led by a virtual probe over the model, in scanning or contour
lines, layer by layer from the stock (Kobayashi & Shirase 2014, section 2; docs/copy-milling.md).

    op = patchmill.CopyMilling.Create("CopyMilling", parentJob=job)    # a job with a ball end mill
    op.Mode, op.RadialDepth, op.AxialDepth = "Scanning", 2.0, 2.0
    op.Base = [(job.Model.Group[0], ["Face1"])]                         # none: the whole model
    patchmill.CopyMilling.recompute(op)                                 # raises patchmill.InputError

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import functools
from dataclasses import dataclass, replace

import _patchmill as core
import FreeCAD
from _patchmill import InputError

from patchmill.freecad import host, kinds
from patchmill.geometry.deflection import told_of
from patchmill.machine import machining_time
from patchmill.operations.base import BallEndOperation, create, setup_properties
from patchmill.operations.computed import recompute  # noqa: F401  for macros: it returns the ToolPath
from patchmill.operations.copy_input import MODES, PASSES, UNDERCUTS, CopyInput, input_of
from patchmill.path import copy_forecast
from patchmill.path.read_text import path_of
from patchmill.properties.check_properties import CHECK_PROPERTIES, gouge_tolerance
from patchmill.system import memory
from patchmill.system.stops import stoppable

BYTES_PER_MOVE = 2200  # with its command in the document: measured by tests/bench/jobs_memory_bench.py
LEAST_HEIGHT = 1e-3  # mm of stock that is looked at, over a face at its top
NOTHING_THERE = "there is nothing to cut on them, or the ball does not reach them from above."
DEFLECTION = 0.25  # of the tolerance: of the mesh that stands for the model
OVERLAP = 0.87  # of the corner's radius that lines go beyond the stock: slopes up to 60 degrees are finished
PROPERTIES = [
    ("App::PropertyEnumeration", "Mode", "Copy", "Lines in planes along X, or contours at levels", MODES),
    ("App::PropertyEnumeration", "Passes", "Copy", "Layers from the stock, the last pass, or both", PASSES),
    ("App::PropertyLength", "RadialDepth", "Copy", "Distance between lines", 2.0),
    ("App::PropertyLength", "AxialDepth", "Copy", "Distance between layers", 2.0),
    ("App::PropertyLength", "FinishingRadialDepth", "Copy", "The last pass's; 0: as the others'", 0.0),
    ("App::PropertyLength", "Allowance", "Copy", "Left by roughing for the last pass", 0.0),
    ("App::PropertyLength", "Tolerance", "Copy", "Of the path from the model", 0.01),
    (
        "App::PropertyString",
        "Machine",
        "Copy",
        "Name of the machine file, whose rapids and accelerations the time counts; empty: unknown",
        "",
    ),
    gouge_tolerance("Tolerance"),
    *CHECK_PROPERTIES,
]
RESULTS = [
    ("App::PropertyInteger", "Moves", "Result", "Of the path"),
    ("App::PropertyFloat", "MachiningTime", "Result", "Time of all moves, rapids too, in seconds"),
    ("App::PropertyFloat", "Scallop", "Result", "Ridge between lines on a flat, in mm"),
    ("App::PropertyInteger", "OutOfReach", "Result", "Lines left out: in a cavity, not reached from above"),
]


class ObjectCopyMilling(BallEndOperation):
    """An operation's proxy. `path` is the _patchmill.ToolPath of the last good execute, else None. `ready`: a
    CopiedPath that was made beforehand of what the operation has now; the next execute takes it. Neither is
    saved."""

    __module__ = "patchmill.copy_milling"  # what documents save

    RESULT = "path"
    KIND = kinds.COPY_MILLING
    path = ready = None

    @classmethod
    def properties(cls):
        return PROPERTIES

    @classmethod
    def results(cls):
        return RESULTS

    def opExecute(self, obj):
        ready, self.ready = self.ready, None
        given = input_of(obj)
        made = ready if ready is not None and ready.asked == given else mill(given)
        self.path = made.path
        tilted = any(getattr(other, "Controls", "Feed") != "Feed" for other in obj.InListRecursive)
        for remark in remarks(made, tilted):
            FreeCAD.Console.PrintWarning("%s: %s\n" % (obj.Label, remark))
        text = str(core.freecad_text(self.path, None, 4))
        self.commandlist.extend(host.begin_upright(path_of(text).Commands))
        obj.Moves = len(self.path)
        obj.MachiningTime = made.seconds
        obj.OutOfReach = made.out_of_reach
        obj.Scallop = given.tool.scallop_height(given.last_radial)


@dataclass
class CopiedPath:
    """A _patchmill.ToolPath, how many lines had to be left out of it: in a cavity, where the tool cannot
    come from above, and the CopyInput it was made from."""

    path: core.ToolPath
    out_of_reach: int
    asked: CopyInput

    @functools.cached_property
    def seconds(self):
        """Time of all its moves [s]: see machining_time. Its programs say nothing of corners."""
        given = self.asked
        return machining_time.seconds(
            self.path, given.rapids, given.machine, rounding=machining_time.UNTOLD
        )


def remarks(made, tilted=False):
    """Sentences on what a user should know of a CopiedPath before it is cut; `tilted`: by a DCM modifier."""
    given, said = made.asked, []
    if given.mode == UNDERCUTS and not tilted:
        said.append("an upright shank would cut the overhang: put a DCM modifier with posture on it.")
    if given.last_radial > 2.0 * given.tool.radius:
        said.append("the lines are further apart than the tool is wide: ridges stay between them.")
    if made.out_of_reach:
        said.append("%d lines in cavities are left out: no way from above." % made.out_of_reach)
    return said


@stoppable
def mill(given, progress=None):
    """CopiedPath of a CopyInput; None if `progress` (share -> bool) returned False. Raises InputError naming
    the property."""
    stock, part, faces = solids(given)
    low, high = to_cut(stock, faces or part)
    _check_heights(given, low, high)
    _require_memory(given, part, low, high)
    jobs = given.each_pass(high[2] - low[2])
    made, lost = [], 0
    for number, depths in enumerate(jobs):
        asked = _Asked(progress, number, len(jobs))
        options = _options(given, low, high, *depths)
        path, missing = core.copy_mill(part, options, asked)
        if faces is not None and not asked.stopped:
            path = core.over_faces(path, part, faces, options, asked)
        if asked.stopped:
            return None
        made.append(path)
        lost += missing
    path = core.with_plunge_feed(core.joined(made), given.plunge_feed)
    if faces is not None and not (path.kinds == core.MoveKind.CUT).any():
        raise InputError("Base", given.chosen, NOTHING_THERE)
    return CopiedPath(path, lost, given)


def foreseen_bytes(given, part, low, high, much=0.0):
    """Memory that a CopyInput's path takes in a document, about: of what surely takes less than `much` a
    number that is too large, of other ones by milling slices of the stock."""
    radius, beyond = given.tool.radius, _beyond(given.tool)
    most, about = 0.0, []
    for radial, axial, allowance in given.each_pass(high[2] - low[2]):
        cut = copy_forecast.Cut(tuple(low), tuple(high), radial, axial, given.tolerance)
        most += BYTES_PER_MOVE * cut.at_most(radius, beyond)

        def count(some, left=allowance):
            asked = replace(given, tolerance=some.tolerance)
            options = _options(asked, some.low, some.high, some.radial, some.axial, left)
            return len(core.copy_mill(part, options)[0])

        about.append((cut, count))
    if most < much:
        return most
    return BYTES_PER_MOVE * sum(
        copy_forecast.moves(cut, given.mode, radius, beyond, count) for cut, count in about
    )


def _require_memory(given, part, low, high):
    """Raises InputError naming the property that takes more memory than there is, with a value of it that was
    found to take less."""
    free = max(1.0, memory.available())
    needed = foreseen_bytes(given, part, low, high, 0.1 * free)
    if needed <= free:
        return
    tried = {  # field of CopyInput: (property, most that is proposed, how its moves go with it)
        "finishing_radial": ("FinishingRadialDepth", given.tool.radius, 1.0),
        "radial": ("RadialDepth", given.tool.radius, 1.0),
        "axial": ("AxialDepth", min(given.tool.radius, given.cutting_edge), 1.0),
        "tolerance": ("Tolerance", 0.1 * given.tool.radius, 2.0),
    }
    remedy, first = "mill a smaller part, or chosen faces of it, in a job of its own.", None
    for field in sorted(tried, key=lambda one: getattr(given, one) / tried[one][1]):
        name, most, power = tried[field]
        value = getattr(given, field)
        if not 0.0 < value < most:
            continue
        first = first or (name, value)
        larger = float("%.2g" % min(most, value * (1.5 * needed / free) ** power))
        if foreseen_bytes(replace(given, **{field: larger}), part, low, high) <= free:
            first, remedy = (name, value), "give about %g mm." % larger
            break
    name, value = first or ("RadialDepth", given.radial)
    memory.require(needed, name, "%g mm" % value, remedy)


class _Asked:
    """Progress of one pass of several, that remembers whether it was told to stop."""

    def __init__(self, progress, number, count):
        self.progress, self.number, self.count = progress, number, count
        self.stopped = False

    def __call__(self, share):
        if self.progress and not self.stopped:
            self.stopped = not self.progress((self.number + share) / self.count)
        return not self.stopped


def live_options(given):
    """(_patchmill.CopyOptions, part as _patchmill.Solid) of a CopyInput, for patchmill.live."""
    stock, part, faces = solids(given)
    if faces is not None:
        raise InputError("Base", given.chosen, "live, choose the whole model.")
    low, high = to_cut(stock, part)
    return _options(given, low, high, given.radial, given.axial, 0.0), part


def to_cut(stock, part):
    """Low and high corner of the stock's box; the stock below `part`, the model or the chosen faces, is not
    for this operation."""
    low, high = stock.bounds
    low[2] = min(max(low[2], part.bounds[0][2]), high[2] - LEAST_HEIGHT)
    return low, high


def _options(given, low, high, radial, axial, allowance):
    depths = (radial, axial, given.tolerance, allowance)
    room = (low, high, given.safe_height - high[2], _beyond(given.tool))
    return core.CopyOptions(given.mode, given.tool, given.spindle, given.feed, *depths, *room)


def solids(given):
    """(stock, part, faces) of a CopyInput as _patchmill.Solid; faces: those chosen, or None."""
    with told_of("Tolerance", DEFLECTION):
        return _solids(given, DEFLECTION * given.tolerance)


def _solids(given, deflection):
    stock = core.solid_of_brep(given.stock, max(deflection, 0.01), "Stock")
    undercut = given.mode == UNDERCUTS
    if given.faces and undercut:
        raise InputError("Base", given.chosen, "with undercuts choose the whole model.")
    part = core.solid_of_brep(given.model, deflection, "Model", undercut)
    _check_inside(stock.bounds, part.bounds)
    faces = core.solid_of_brep(given.faces, deflection, "Base", False) if given.faces else None
    return stock, part, faces


def _beyond(tool):
    """How far lines go beyond the stock: of a ball OVERLAP R, of a bull nose besides its flat bottom."""
    return OVERLAP * tool.corner_radius + (tool.radius - tool.corner_radius)


def _check_inside(stock, part):
    over = max(max(stock[0][k] - part[0][k], part[1][k] - stock[1][k]) for k in range(3))
    if over > 0.01:
        raise InputError(
            "Model", "%.3f mm outside the stock" % over, "move the part into the stock or enlarge it."
        )


def _check_heights(given, low, high):
    """Rapids stay above the stock, and the tool cuts with its edges only."""
    if not given.safe_height > high[2]:
        remedy = "rapids would go through the stock: give more than its top, %g mm." % high[2]
        raise InputError("SafeHeight", "%g mm" % given.safe_height, remedy)
    deepest = min(given.axial, high[2] - low[2])
    if given.passes != "Finishing" and deepest > given.cutting_edge:
        remedy = "give no more than the tool's cutting edge, %g mm." % given.cutting_edge
        raise InputError("AxialDepth", "%g mm" % given.axial, remedy)


def SetupProperties():
    """Names of the properties that a job's setup sheet may hold defaults for."""
    return setup_properties(ObjectCopyMilling)


def Create(name, obj=None, parentJob=None):
    """A new CopyMilling in the active document; `parentJob` is the Job it goes into."""
    return create(ObjectCopyMilling, name, obj, parentJob)


host.register_operation("CopyMilling", Create, SetupProperties)

"""What a post-processor does to the words that textures need, found by posting a few moves with it and
looking at the text: never by its name alone.

    probe(host, "linuxcnc") -> Survey(C=kept, K=dropped, F93=kept, wrap=no, ...)

Works without the compiled core, so that tools/survey_posts.py can run it in any FreeCAD.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import re
from dataclasses import dataclass, fields

import FreeCAD

KEPT, DROPPED, CHANGED, UNKNOWN = "kept", "dropped", "changed", "unknown"

# one line each, told apart by X; FreeCAD's F is in mm/s, and 1/s under G93
PROGRAM = (
    "G0 X10 Y0 Z5",
    "G1 X11 Y0 Z5 A10 C20 F7.24",
    "G1 X12 Y0 Z5 A10 C-371.5 F7.24",
    "G33 X13 Y0 Z5 K0.5",
    "G93",
    "G1 X14 Y0 Z5 A11 C-372 F2",
    "G1 X15 Y0 Z5 A12 C-372 F2",
    "G94",
    "G1 X16.12345 Y0 Z5 F7.24",
    "G43.4 H1",
    "M428",
    "G49",
)


@dataclass
class Survey:
    """One post: what became of each word. `fault` is set if it posted nothing."""

    C: str = UNKNOWN  # of a rotary move
    turns: str = UNKNOWN  # C-371.5 as such
    K: str = UNKNOWN  # of G33
    F93: str = UNKNOWN  # F on every G1 under G93, as 1/min
    inches: str = UNKNOWN  # C with --inches: kept in degrees?
    decimals: str = UNKNOWN
    TCP: str = UNKNOWN  # G43.4 H1 and M428 pass
    fault: str = ""

    def as_row(self):
        return [getattr(self, field.name) for field in fields(self)]


def probe(host, post_name):
    """Survey of one post-processor. `host` is patchmill.freecad.host."""
    active = FreeCAD.ActiveDocument
    document = FreeCAD.newDocument("PatchMillProbe", hidden=True)
    try:
        job = _job(host, document)
        survey = Survey()
        try:
            text = _posted(host, job, post_name, "--no-show-editor")
        except BaseException as error:  # posts call sys.exit on arguments that they do not know
            survey.fault = "%s: %s" % (type(error).__name__, str(error).split("\n")[0][:70])
            if not isinstance(error, (Exception, SystemExit)):
                raise
            return survey
        if not text.strip():
            survey.fault = "it returns no text"
            return survey
        _read(survey, text)
        try:
            _read_inches(survey, _posted(host, job, post_name, "--no-show-editor --inches"))
        except (Exception, SystemExit) as error:
            survey.inches = "refused (%s)" % type(error).__name__
        return survey
    finally:
        FreeCAD.closeDocument(document.Name)
        if active is not None:
            FreeCAD.setActiveDocument(active.Name)


def _job(host, document):
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    job = host.create_job("Job", [box])
    operation = document.addObject("Path::Feature", "Probe")
    operation.Path = host.Path.Path([_command(host, line) for line in PROGRAM])
    for name, value in (("Active", True), ("CoolantMode", "None")):
        kind = "App::PropertyBool" if isinstance(value, bool) else "App::PropertyString"
        operation.addProperty(kind, name)
        setattr(operation, name, value)
    operation.addProperty("App::PropertyLink", "ToolController")
    operation.ToolController = host.tool_controllers(job)[0]
    job.Operations.Group = job.Operations.Group + [operation]
    document.recompute()
    return job


def _command(host, line):
    """Its words by value: FreeCAD would read the numbers of a text as the locale has them."""
    name, *words = line.split()
    return host.Path.Command(name, {word[0]: float(word[1:]) for word in words})


def _posted(host, job, post_name, arguments):
    names = list(job.getEnumerationsOfProperty("PostProcessor") or [])
    job.PostProcessor = names if post_name in names else names + [post_name]
    job.PostProcessor = post_name
    return "\n".join(host.post_parts(job, post_name, arguments))


def _line(text, x):
    """The words of the line whose X is `x`, as {letter: number text}; None if there is none."""
    for line in text.splitlines():
        words = dict(re.findall(r"([A-Z])\s*=?\s*([+-]?\d*\.?\d+)", line))
        try:
            if abs(float(words.get("X", "nan")) - x) < 6e-4:
                return words
        except ValueError:
            continue
    return None


def _number(words, letter):
    return float(words[letter]) if words and letter in words else None


def _read(survey, text):
    def judge(value, wanted):
        if value is None:
            return DROPPED
        return KEPT if abs(value - wanted) < 2e-3 else "%s: %g" % (CHANGED, value)

    rotary, wrapped, locked = _line(text, 11), _line(text, 12), _line(text, 13)
    survey.C = judge(_number(rotary, "C"), 20.0)
    survey.turns = judge(_number(wrapped, "C"), -371.5)
    survey.K = judge(_number(locked, "K"), 0.5)
    feeds = [judge(_number(_line(text, x), "F"), 120.0) for x in (14, 15)]
    survey.F93 = feeds[0] if feeds[0] != KEPT else feeds[1]
    if feeds == [KEPT, DROPPED]:
        survey.F93 = "dropped if the same"
    fine = re.search(r"X\s*\+?16\.(\d+)", text)
    survey.decimals = str(len(fine.group(1))) if fine else UNKNOWN
    tcp = re.search(r"G43\.4\s+H1\b", text) is not None, "M428" in text
    names = {(True, True): KEPT, (False, True): "H dropped", (True, False): "M428 dropped"}
    survey.TCP = names.get(tcp, DROPPED)


def _read_inches(survey, text):
    for words in (_line(text, 11 / 25.4), _line(text, 11)):
        value = _number(words, "C")
        if value is not None:
            kept = KEPT if abs(value - 20.0) < 2e-3 else CHANGED
            survey.inches = "scaled as a length" if abs(value - 20.0 / 25.4) < 2e-3 else kept
            return
    survey.inches = DROPPED


def missing(survey, rotary, turning_far, locked, inverse):
    """Why a path that needs these words must not be fed to that post, a list of sentences."""
    if survey.fault:
        return ["it fails: %s" % survey.fault]
    out = []
    if rotary and survey.C != KEPT:
        out.append("it does not keep C (%s)" % survey.C)
    if rotary and turning_far and survey.turns != KEPT:
        out.append("it does not keep turns of C beyond 360 degrees (%s)" % survey.turns)
    if locked and survey.K != KEPT:
        out.append("it does not keep K of G33 (%s)" % survey.K)
    if inverse and survey.F93 != KEPT:
        out.append("it does not keep F on every move under G93 (%s)" % survey.F93)
    return out

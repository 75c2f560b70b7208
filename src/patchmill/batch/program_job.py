"""One program, inside FreeCADCmd: compared with its job, simulated, or its report written.

Run by patchmill.batch.process, as part_job.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
from typing import Any, Dict, List

import FreeCAD
import patchmill
from patchmill import InputError
from patchmill.batch import answer
from patchmill.freecad import host
from patchmill.freecad.kinds import kind_of
from patchmill.machine import machining_time
from patchmill.macros import outcome


def run(request: Dict[str, Any]) -> Dict[str, Any]:
    """The answer to a request: what (check, simulate or report), program, document, job (a label or None),
    post (a name or None) and output (a folder or None). Its `lines` are for the user; a program that is not
    that of its job is "refused", with the reason."""
    try:
        job = _job(request)
    except InputError as error:
        return {"status": "wrong call", "error": [error.property, str(error.value), error.remedy]}
    try:
        posted = patchmill.read_back(job, request["program"], request["post"])
        lines = [_line(one) for one in posted]
        simulated = []
        if request["what"] == "simulate":
            simulated = [patchmill.simulate(t.operation, path=t.path) for t in outcome.textures(posted)]
            lines += [result.text() for result in simulated]
        if request["output"]:
            lines += outcome.report(posted, request["program"], request["output"], simulated or None)
    except InputError as error:
        return {"status": "refused", "reason": str(error), "property": error.property}
    except OSError as error:
        return {"status": "wrong call", "error": ["-o", request["output"], str(error)]}
    return _answer(posted, simulated, lines)


def _answer(posted: Any, simulated: Any, lines: List[str]) -> Dict[str, Any]:
    """What is not known is not passed, and a dimple that is missing is none."""
    unknown = [one.operation.Label for one in posted if getattr(one, "unknown", "")]
    if unknown:
        return {"status": "unknown", "lines": lines, "reason": "not read back: %s" % ", ".join(unknown)}
    missing = sum(int(result.found["missing"]) for result in simulated)
    if missing:
        return {"status": "missing", "lines": lines, "reason": "%d dimples are missing" % missing}
    return {"status": "done", "lines": lines}


def _job(request: Dict[str, Any]) -> Any:
    """The job of the document. Raises InputError."""
    name = request["document"]
    try:
        document = FreeCAD.openDocument(name)
    except Exception as error:  # FreeCAD raises errors of many kinds
        said = (str(error).splitlines() or [type(error).__name__])[0]
        raise InputError("--document", name, "it cannot be opened (%s)." % said) from error
    found = [job for job in host.jobs() if job.Document is document]
    if request["job"] is not None:
        found = [job for job in found if request["job"] in (job.Label, job.Name)]
    if len(found) != 1:
        labels = ", ".join(job.Label for job in host.jobs()) or "none"
        remedy = "%d jobs are so, of %s: name one with --job." % (len(found), labels)
        raise InputError("--document", os.path.basename(name), remedy)
    return found[0]


def _line(one: Any) -> str:
    """One operation as read back."""
    where = "%s: " % " ".join(word for word in (one.offset, one.operation.Label) if word)
    if hasattr(one, "errors"):
        said = outcome.figures(one)
        phase = "phase error at most %(phase_error_max_degrees).3f°, rms %(phase_error_rms_degrees).3f°"
        said["time"] = machining_time.in_words(said["seconds"])
        return where + ("%(dimples)d dimples, %(time)s, " + phase + ". %(check_sentence)s") % said
    if one.unknown:
        return where + "unknown: %s" % one.unknown
    ours = kind_of(one.operation)
    time = ", " + machining_time.in_words(one.operation.MachiningTime) if ours else ""
    return where + "%d moves as planned%s" % (one.moves, time)


def main(name: str) -> int:
    """Runs the request of that name; 0 if there is an answer, whatever it says."""
    return answer.leave(name, run)

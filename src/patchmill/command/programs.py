"""Calls about one program: compare it with its job, simulate it, write its report. FreeCAD does it, in a
process of its own.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import glob
import logging
import os
import tempfile
from typing import Any, Dict

from patchmill.batch import process
from patchmill.batch.problem import BatchError
from patchmill.command.status import FAILED, WRONG_CALL

LOG = logging.getLogger("patchmill.program")


def check(options: Any) -> int:
    """Prints what was read back of each operation; FAILED if the program is not that of the job. Raises
    BatchError."""
    return _ask(options, "check", None)


def simulate(options: Any) -> int:
    """Prints a table of the marks of each texture, and draws them into a folder if one is given; FAILED if
    the program is not that of the job, or a dimple is missing. Raises BatchError."""
    return _ask(options, "simulate", options.output)


def report(options: Any) -> int:
    """Writes report.html and pictures of a program. Raises BatchError."""
    folder = options.output or os.path.splitext(options.program[-1])[0] + "-report"
    return _ask(options, "report", folder)


def _ask(options: Any, what: str, output: Any) -> int:
    """The exit status of program_job's answer, which is printed."""
    if len(options.program) + bool(options.document) > 2:
        raise BatchError(what, " ".join(options.program), "give one program, and the document of its job.")
    request: Dict[str, Any] = {
        "what": what,
        "program": _file(what, options.program[-1]),
        "document": _document(options),
        "job": options.job,
        "post": options.post,
        "output": output and os.path.abspath(output),
    }
    with tempfile.TemporaryDirectory(prefix="patchmill-") as folder:
        request["folder"] = folder
        result = process.run_part(request, {}, module="patchmill.batch.program_job")
        with open(os.path.join(folder, "log.txt"), encoding="utf-8", errors="replace") as file:
            for row in file:
                LOG.info("%s", row.strip())
    for line in result.get("lines", []):
        print(line)
    if result["status"] == "wrong call":
        raise BatchError(*result["error"])
    if result["status"] != "done":
        print("failed: %s" % result["reason"])
    return {"done": 0, "wrong call": WRONG_CALL}.get(result["status"], FAILED)


def _file(call: str, name: str) -> str:
    if not os.path.isfile(name):
        raise BatchError(call, name, "there is no such file.")
    return os.path.abspath(name)


def _document(options: Any) -> str:
    """The document that is named; else, beside the program, that of its name or the only one."""
    if options.document:
        return _file("--document", options.document)
    if len(options.program) == 2:
        return _file("check", options.program[0])
    stem = os.path.splitext(os.path.abspath(options.program[-1]))[0]
    if os.path.isfile(stem + ".FCStd"):
        return stem + ".FCStd"
    beside = sorted(glob.glob(os.path.join(glob.escape(os.path.dirname(stem)), "*.FCStd")))
    if len(beside) != 1:
        said = "there are %d documents beside the program: name the one with its job." % len(beside)
        raise BatchError("--document", options.program[-1], said)
    return beside[0]

"""`patchmill check`: a program file against the job of a FreeCAD document, operation by operation.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import subprocess
import sys
from typing import Any

from patchmill.batch import process
from patchmill.batch.problem import BatchError

RIGHT, WRONG, WRONG_CALL = 0, 1, 2


def in_freecad(document: str, program: str, job: str = "", post: str = "") -> int:
    """As main, in a FreeCADCmd of its own: the exit status. Raises BatchError if there is no such file."""
    for name in (document, program):
        if not os.path.isfile(name):
            raise BatchError("check", name, "there is no such file.")
    names = [os.path.abspath(document), os.path.abspath(program), job, post]
    code = "import sys; from patchmill.batch import program_check; sys.exit(program_check.main(*%r))" % names
    words = [process.freecad_command(), "-c", code, "-M", process.module_folder()]
    done = subprocess.run(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    said = done.stdout.decode("utf-8", "replace").splitlines()
    lines = [line[len(MARK) :] for line in said if line.startswith(MARK)]
    print("\n".join(lines or said))
    return done.returncode


MARK = "check> "  # FreeCAD writes more than this


def main(document: str, program: str, job_name: str = "", post: str = "") -> int:
    """Prints what the program holds of the job; 0 if it is all of it and nothing else."""
    import FreeCAD
    import patchmill
    from patchmill.freecad import host

    opened = FreeCAD.openDocument(document)
    jobs: Any = [job for job in host.jobs() if job_name in ("", job.Name, job.Label)]
    if len(jobs) != 1:
        names = ", ".join(job.Label for job in host.jobs()) or "none"
        return _say("the document has the jobs: %s. Name one with --job." % names, WRONG_CALL)
    opened.recompute()
    try:
        posted = patchmill.read_back(jobs[0], program, post or None)
    except patchmill.InputError as error:
        return _say(str(error), WRONG)
    for one in posted:
        found = one.match.found if hasattr(one, "match") else one.moves
        what = "dimples" if hasattr(one, "match") else "moves"
        said = getattr(one, "unknown", "") or "%d %s read back" % (found, what)
        _say("%s %s: %s" % (one.offset, one.operation.Label, said))
    unknown = any(getattr(one, "unknown", "") for one in posted)
    if unknown:
        return _say("not all of it could be read.", WRONG)
    return _say("all of the job is in the program, and nothing else.")


def _say(sentence: str, status: int = RIGHT) -> int:
    print(MARK + sentence)
    sys.stdout.flush()
    return status

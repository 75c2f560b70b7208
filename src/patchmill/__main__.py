"""`python3 -m patchmill`, the command: what it is called with, and its exit status.

    patchmill run RECIPE -o OUT [-j N] [--resume]
    patchmill run *.step --recipe mould.json -o OUT
    patchmill compare OLD/index.json NEW/index.json
    patchmill report OUT | PROGRAM -o FOLDER
    patchmill check [DOCUMENT] PROGRAM
    patchmill simulate PROGRAM [-o FOLDER]
    patchmill macro FILE [ARGUMENT ...]
    patchmill machines
    patchmill examples [NAME FOLDER]
    patchmill doctor

Exit status: 0 all is well, 1 something failed or came out otherwise, 2 a wrong call.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import argparse
import logging
import os
import sys
from typing import Any, List, Optional

import patchmill
from patchmill.batch.problem import BatchError
from patchmill.command import listing, programs, runs
from patchmill.command import macro as macros
from patchmill.command.status import FAILED, WRONG_CALL
from patchmill.install import doctor


def main(arguments: Optional[List[str]] = None) -> int:
    """Carries out one call and returns its exit status."""
    options = _parser().parse_args(arguments)
    _log(options.verbose)
    try:
        return int(options.do(options))
    except BatchError as error:
        print("patchmill: %s" % error, file=sys.stderr)
        return WRONG_CALL
    except OSError as error:  # no room, no folder for temporary files
        print("patchmill: %s: %s." % (error.filename or "files", error.strerror or error), file=sys.stderr)
        return FAILED
    except KeyboardInterrupt:
        print("patchmill: stopped; a run goes on from here with --resume.", file=sys.stderr)
        return FAILED


def _log(verbose: bool) -> None:
    """Lines of the log go to the standard error, with the time; without -v warnings alone."""
    logger = logging.getLogger("patchmill")
    for old in list(logger.handlers):
        logger.removeHandler(old)
    handler = logging.StreamHandler(sys.stderr)
    handler.setFormatter(logging.Formatter("%(asctime)s %(name)s: %(message)s"))
    logger.addHandler(handler)
    logger.propagate = False
    logger.setLevel(logging.INFO if verbose else logging.WARNING)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="patchmill", description="Regular dimple textures for batches of parts."
    )
    parser.add_argument("--version", action="version", version="PatchMill " + patchmill.__version__)
    calls = parser.add_subparsers(required=True, metavar="CALL")
    _add_run(calls)
    _add_programs(calls)
    both = _add(calls, "compare", runs.compare_two, "hold two indexes against each other")
    both.add_argument("old")
    both.add_argument("new")
    macro = _add(calls, "macro", macros.run, "run a macro in FreeCAD without its window")
    macro.add_argument("file")
    macro.add_argument("arguments", nargs=argparse.REMAINDER, metavar="ARGUMENT")
    _add(calls, "machines", listing.machines, "list the machine files")
    examples = _add(calls, "examples", listing.examples, "list the example recipes, or copy one")
    examples.add_argument("name", nargs="?")
    examples.add_argument("folder", nargs="?")
    what = "what is installed, and what is wrong with it"
    _add(calls, "doctor", lambda options: doctor.in_freecad(), what)
    return parser


def _add(calls: Any, name: str, do: Any, what: str) -> argparse.ArgumentParser:
    call: argparse.ArgumentParser = calls.add_parser(name, help=what, description=what)
    call.add_argument(
        "-v", "--verbose", action="store_true", help="log lines, to be sent with a bug report"
    )
    call.set_defaults(do=do)
    return call


def _add_run(calls: Any) -> None:
    run = _add(calls, "run", runs.run, "mill the parts of a recipe, each in a process of its own")
    run.add_argument("names", nargs="+", metavar="RECIPE | PART", help="a recipe; with --recipe: parts")
    run.add_argument("--recipe", help="the recipe, when parts are named")
    run.add_argument(
        "-o", "--output", required=True, metavar="OUT", help="folder for programs and index"
    )
    run.add_argument("-j", "--jobs", type=_count, default=1, metavar="N", help="parts at a time (1)")
    run.add_argument(
        "--resume", action="store_true", help="keep what an earlier run into OUT has finished"
    )
    run.add_argument(
        "--compare", metavar="INDEX", help="fail if parts came out otherwise than in this index.json"
    )
    run.add_argument(
        "--cluster", metavar="ADDRESS", help="make the parts on the workers of a Dask scheduler"
    )


def _add_programs(calls: Any) -> None:
    document = "the FreeCAD document with its job (beside it: that of its name, or the only one)"
    for name, do, what in (
        ("check", programs.check, "compare a program with its job: every move, phase, gouges"),
        ("simulate", programs.simulate, "simulate the marks that a program leaves, and count them"),
        ("report", _report, "tell what a run came to, or write the report of a program"),
    ):
        call = _add(calls, name, do, what)
        metavar = "OUT | PROGRAM" if name == "report" else "[DOCUMENT] PROGRAM"
        call.add_argument("program", nargs="+", metavar=metavar)
        call.add_argument("-d", "--document", help=document)
        call.add_argument("--job", metavar="LABEL", help="the job, where the document has several")
        call.add_argument("--post", help="the post-processor that made it (the job's own)")
        if name != "check":
            call.add_argument("-o", "--output", metavar="FOLDER", help="folder for report and pictures")


def _report(options: Any) -> int:
    if os.path.isdir(options.program[-1]):
        return runs.report(options.program[-1])
    return programs.report(options)


def _count(text: str) -> int:
    number = int(text)
    if not 1 <= number <= 1000:
        raise argparse.ArgumentTypeError("give a number of processes from 1 to 1000")
    return number


if __name__ == "__main__":
    sys.exit(main())

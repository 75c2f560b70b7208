"""The command `patchmill`: recipes and indexes from a terminal or from CI.

    patchmill run RECIPE -o OUT [-j N] [--resume]
    patchmill run *.step --recipe mould.json -o OUT
    patchmill check DOCUMENT PROGRAM [--job NAME] [--post NAME]
    patchmill compare OLD/index.json NEW/index.json
    patchmill report OUT
    patchmill machines
    patchmill examples [NAME FOLDER]
    patchmill doctor

Exit status: 0 all is well, 1 something failed or came out otherwise, 2 a wrong call.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import argparse
import os
import shutil
import sys
import time
from typing import Any, Dict, List, Optional

import patchmill
from patchmill.batch import cluster, compare, index, outputs, program_check, recipe
from patchmill.batch import run as batch
from patchmill.batch.problem import BatchError
from patchmill.install import doctor

FAILED, WRONG_CALL = 1, 2


def main(arguments: Optional[List[str]] = None) -> int:
    """Carries out one call and returns its exit status."""
    options = _parser().parse_args(arguments)
    try:
        return int(options.do(options))
    except BatchError as error:
        print("patchmill: %s" % error, file=sys.stderr)
        return WRONG_CALL
    except KeyboardInterrupt:
        print("patchmill: stopped; --resume goes on from here.", file=sys.stderr)
        return FAILED


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="patchmill", description="Regular dimple textures for batches of parts."
    )
    parser.add_argument("--version", action="version", version="PatchMill " + patchmill.__version__)
    calls = parser.add_subparsers(required=True, metavar="CALL")
    run = calls.add_parser("run", help="mill the parts of a recipe, each in a process of its own")
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
    run.add_argument(
        "-v", "--verbose", action="store_true", help="tell each part's log, for a bug report"
    )
    run.set_defaults(do=_run)
    check = calls.add_parser("check", help="read a program back against the job of a document")
    check.add_argument("document", metavar="DOCUMENT")
    check.add_argument("program", metavar="PROGRAM")
    check.add_argument("--job", default="", help="name or label of the job, if there are several")
    check.add_argument("--post", default="", help="post-processor that made it (the job's)")
    check.set_defaults(do=lambda o: program_check.in_freecad(o.document, o.program, o.job, o.post))
    both = calls.add_parser("compare", help="hold two indexes against each other")
    both.add_argument("old")
    both.add_argument("new")
    both.set_defaults(do=_compare)
    report = calls.add_parser("report", help="tell what a run came to")
    report.add_argument("output", metavar="OUT")
    report.set_defaults(do=_report)
    calls.add_parser("machines", help="list the machine files").set_defaults(do=_machines)
    doctors = calls.add_parser("doctor", help="what is installed, and what is wrong with it")
    doctors.set_defaults(do=lambda _: doctor.in_freecad())
    examples = calls.add_parser("examples", help="list the example recipes, or copy one")
    examples.add_argument("name", nargs="?")
    examples.add_argument("folder", nargs="?")
    examples.set_defaults(do=_examples)
    return parser


def _count(text: str) -> int:
    number = int(text)
    if not 1 <= number <= 1000:
        raise argparse.ArgumentTypeError("give a number of processes from 1 to 1000")
    return number


def _run(options: Any) -> int:
    wanted = _recipe(options)
    old = compare.load(options.compare) if options.compare else None
    each = cluster.on(options.cluster) if options.cluster else batch.here(options.jobs)
    with outputs.OutputFolder(options.output) as out:
        told = _Progress(out, options.verbose)
        done = batch.run(wanted, out, each, options.resume, told)
        index.write(wanted, done, out)
    told.end()
    failed = index.failed(done)
    print(
        "%d of %d parts have a program: %s"
        % (
            len(done) - len(failed),
            len(done),
            os.path.join(options.output, "index.html"),
        )
    )
    for name in failed:
        print("failed: %s: %s" % (name, done[name]["reason"]))
    differing = compare.changes(old, index.data(wanted, done)) if old else []
    for sentence in differing:
        print("changed: " + sentence)
    return FAILED if failed or differing else 0


def _recipe(options: Any) -> recipe.Recipe:
    if options.recipe:
        return recipe.load(options.recipe, options.names)
    if len(options.names) != 1:
        raise BatchError("run", " ".join(options.names), "give one recipe, or parts and --recipe.")
    return recipe.load(options.names[0], [])


class _Progress:
    """Tells a run's progress: one line that changes on a terminal, a line for each part elsewhere."""

    def __init__(self, out: outputs.OutputFolder, verbose: bool) -> None:
        self.out, self.verbose = out, verbose
        self.begin = time.monotonic()
        self.terminal = sys.stdout.isatty() and not verbose

    def __call__(self, number: int, of: int, name: str, result: Dict[str, Any]) -> None:
        left = (time.monotonic() - self.begin) / number * (of - number)
        line = "%d of %d, %d min %02d s left: %s: %s" % (
            number,
            of,
            *divmod(round(left), 60),
            name,
            result["status"],
        )
        if self.terminal:
            sys.stdout.write("\r\033[K" + line[: shutil.get_terminal_size().columns - 1])
            sys.stdout.flush()
        else:
            print(line, flush=True)
        if self.verbose:
            self._log(name)

    def _log(self, name: str) -> None:
        log = os.path.join(self.out.part_folder(name), "log.txt")
        if os.path.isfile(log):
            with open(log, encoding="utf-8", errors="replace") as file:
                for row in file:
                    if row.strip():
                        print("  %s: %s" % (name, row.strip()))

    def end(self) -> None:
        """Leaves the line."""
        if self.terminal:
            sys.stdout.write("\n")


def _compare(options: Any) -> int:
    differing = compare.changes(compare.load(options.old), compare.load(options.new))
    for sentence in differing:
        print("changed: " + sentence)
    return FAILED if differing else 0


def _report(options: Any) -> int:
    found = compare.load(os.path.join(options.output, "index.json"))
    for part in found["parts"]:
        said = "%d dimples" % part["dimples"] if part["status"] == "done" else part["reason"]
        print("%s: %s: %s" % (part["name"], part["status"], said))
    return FAILED if found.get("failed") else 0


def _resources(folder: str) -> str:
    return os.path.join(os.path.dirname(recipe.schemas_folder()), folder)


def _machines(options: Any) -> int:
    for name in sorted(os.listdir(_resources("machines"))):
        if name.endswith(".json"):
            print(name[:-5])
    return 0


def _examples(options: Any) -> int:
    folder = _resources("recipes")
    names = sorted(n for n in os.listdir(folder) if os.path.isdir(os.path.join(folder, n)))
    if options.name is None:
        print("\n".join(names))
        return 0
    if options.name not in names:
        raise BatchError("examples", options.name, "there are: %s." % ", ".join(names))
    target = options.folder or options.name
    if os.path.lexists(target):
        raise BatchError("examples", target, "it is there already: give another folder.")
    shutil.copytree(
        os.path.join(folder, options.name), target, ignore=shutil.ignore_patterns("__pycache__")
    )
    print(target)
    return 0

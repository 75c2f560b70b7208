"""Calls that make the parts of a recipe, and hold indexes of runs against each other.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import logging
import os
import platform
from typing import Any

import patchmill
from patchmill.batch import cluster, compare, index, outputs, process, recipe
from patchmill.batch import run as batch
from patchmill.batch.problem import BatchError
from patchmill.command.progress import Progress
from patchmill.command.status import FAILED

LOG = logging.getLogger("patchmill.run")


def run(options: Any) -> int:
    """Makes the parts of a recipe and the index over them; FAILED if one has no program, or if one came out
    otherwise than in the index that it is compared with. Raises BatchError."""
    wanted = _recipe(options)
    LOG.info("PatchMill %s, Python %s, %s", patchmill.__version__, *_system())
    LOG.info("FreeCAD %s, module %s", process.freecad_command(), process.module_folder())
    LOG.info("recipe %s, %d parts, %d at a time", wanted.digest, len(wanted.parts), options.jobs)
    old = compare.load(options.compare) if options.compare else None
    each = cluster.on(options.cluster) if options.cluster else batch.here(options.jobs)
    with outputs.OutputFolder(options.output) as out:
        told = Progress(out, options.verbose)
        done = batch.run(wanted, out, each, options.resume, told)
        index.write(wanted, done, out)
    told.end()
    failed = index.failed(done)
    page = os.path.join(options.output, "index.html")
    print("%d of %d parts have a program: %s" % (len(done) - len(failed), len(done), page))
    for name in failed:
        print("failed: %s: %s" % (name, done[name]["reason"]))
    differing = compare.changes(old, index.data(wanted, done)) if old else []
    for sentence in differing:
        print("changed: " + sentence)
    return FAILED if failed or differing else 0


def _system() -> "tuple[str, str]":
    return platform.python_version(), platform.platform()


def _recipe(options: Any) -> recipe.Recipe:
    if options.recipe:
        return recipe.load(options.recipe, options.names)
    if len(options.names) != 1:
        raise BatchError("run", " ".join(options.names), "give one recipe, or parts and --recipe.")
    return recipe.load(options.names[0], [])


def compare_two(options: Any) -> int:
    """Prints what came out otherwise in a second index; FAILED if anything did. Raises BatchError."""
    differing = compare.changes(compare.load(options.old), compare.load(options.new))
    for sentence in differing:
        print("changed: " + sentence)
    return FAILED if differing else 0


def report(output: str) -> int:
    """Prints a line for each part of a run; FAILED if one has no program. Raises BatchError."""
    found = compare.load(os.path.join(output, "index.json"))
    for part in found["parts"]:
        said = "%d dimples" % part["dimples"] if part["status"] == "done" else part["reason"]
        print("%s: %s: %s" % (part["name"], part["status"], said))
    return FAILED if found.get("failed") else 0

"""A run of a recipe: its parts, some at a time, each in a process of its own; finished ones are not done
again.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import concurrent.futures
import hashlib
import os
import threading
from typing import Any, Callable, Dict, Iterator, List, Optional, Tuple

import patchmill
from patchmill.batch import recipe
from patchmill.batch.outputs import OutputFolder
from patchmill.batch.process import Task, make

Told = Callable[[int, int, str, Dict[str, Any], bool], None]


def key_of(part: recipe.PartFile, made_by: recipe.Recipe) -> str:
    """What a part's files depend on: its content, the recipe and the version."""
    text = "%s %s %s" % (recipe.digest_of(part.file), made_by.digest, patchmill.__version__)
    return hashlib.sha256(text.encode()).hexdigest()


def here(jobs: int) -> Callable[[List[Task]], Iterator[Tuple[Task, Dict[str, Any]]]]:
    """A way to make tasks on this machine, `jobs` at a time; yields them as they end."""

    def each(tasks: List[Task]) -> Iterator[Tuple[Task, Dict[str, Any]]]:
        stop = threading.Event()
        with concurrent.futures.ThreadPoolExecutor(max_workers=jobs) as pool:
            waiting = [pool.submit(make, task, stop) for task in tasks]
            try:
                for done in concurrent.futures.as_completed(waiting):
                    yield done.result()
            except BaseException:
                stop.set()
                for one in waiting:
                    one.cancel()
                raise

    return each


def run(
    wanted: recipe.Recipe,
    out: OutputFolder,
    each: Callable[[List[Task]], Iterator[Tuple[Task, Dict[str, Any]]]],
    resume: bool = False,
    told: Optional[Told] = None,
) -> Dict[str, Dict[str, Any]]:
    """Makes all parts of a recipe in the folder `out`; returns their results by name.
    each: see `here`. resume: parts whose file, recipe and version are those of an earlier run are taken
    over. told(number, of, name, result, made) is called after each; made: not taken over."""
    results: Dict[str, Dict[str, Any]] = {}
    tasks: List[Task] = []
    for part in wanted.parts:
        key = key_of(part, wanted)
        known = out.known(part.name, key) if resume else None
        if known is None:
            tasks.append(_task(part, key, wanted, out))
        else:
            results[part.name] = known
            _tell(told, results, wanted, part.name, False)
    for task, result in each(tasks):
        result.update(key=task.key, file=os.path.relpath(task.request["file"], wanted.folder))
        out.keep(task.name, task.request["folder"], result)
        results[task.name] = result
        _tell(told, results, wanted, task.name, True)
    return {p.name: results[p.name] for p in wanted.parts}


def _task(part: recipe.PartFile, key: str, wanted: recipe.Recipe, out: OutputFolder) -> Task:
    request = {
        "file": part.file,
        "data": {k: v for k, v in wanted.data.items() if k != "parts"},
        "folder": out.working_folder(part.name),
        "recipe_folder": wanted.folder,
    }
    return Task(part.name, request, dict(wanted.data.get("limits", {})), key)


def _tell(told: Optional[Told], results: Any, wanted: recipe.Recipe, name: str, made: bool) -> None:
    if told is not None:
        told(len(results), len(wanted.parts), name, results[name], made)

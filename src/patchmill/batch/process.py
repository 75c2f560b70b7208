"""One part in a FreeCADCmd of its own, with limits of time and memory that end it.

The process dies with the one that started it, has settings of its own (so that runs side by side do not
disturb one another), and writes only into the folder that it is given.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import os
import shutil
import signal
import subprocess
import tempfile
import threading
import time
from dataclasses import dataclass
from typing import Any, Dict, Optional, Tuple

from patchmill.batch.problem import BatchError
from patchmill.install import core_loader

COMMANDS = ("freecadcmd", "FreeCADCmd", "freecad.cmd")
POLL_SECONDS = 0.05


@dataclass(frozen=True)
class Task:
    """One part to be made: everything that a process, here or elsewhere, needs to know."""

    name: str
    request: Dict[str, Any]
    limits: Dict[str, float]
    key: str


def freecad_command() -> str:
    """FreeCAD's command without window: the environment's FREECADCMD, else what PATH has. Raises
    BatchError."""
    named = os.environ.get("FREECADCMD")
    for name in (named,) if named else COMMANDS:
        found = shutil.which(name)
        if found:
            return found
    raise BatchError(
        "FreeCAD", named or "not found", "install FreeCAD, or name its command in FREECADCMD."
    )


def module_folder() -> str:
    """The folder that FreeCAD loads this PatchMill from."""
    return core_loader.module_root()


def run_part(
    request: Dict[str, Any],
    limits: Dict[str, float],
    stop: Optional[threading.Event] = None,
    module: str = "patchmill.batch.part_job",
) -> Dict[str, Any]:
    """The result of one part, whatever happens: that of part_job.run, or one that says that the process
    took too long, too much memory, or died. `request` as part_job.run takes it; limits: seconds, memory_mib;
    `stop` ends it from another thread; module: another than part_job, with a main of its own. Adds `run`:
    seconds and memory_mib of the process."""
    folder = request["folder"]
    name = os.path.join(folder, "request.json")
    with open(name, "w", encoding="utf-8") as file:
        json.dump(request, file)
    log = os.path.join(folder, "log.txt")
    begin = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="patchmill-home-") as home, open(log, "wb") as output:
        process = _start(module, name, home, output)
        ended, peak = _wait(process, limits, begin, stop)
    os.unlink(name)
    result = ended or _answer(folder, process.returncode, log)
    result["run"] = {
        "seconds": round(time.monotonic() - begin, 2),
        "memory_mib": round(peak / 1024.0, 1),
    }
    return result


def make(task: Task, stop: Optional[threading.Event] = None) -> Tuple[Task, Dict[str, Any]]:
    """Makes one part on this machine: (task, result). `stop` ends it from another thread."""
    return task, run_part(task.request, task.limits, stop)


def _start(module: str, request: str, home: str, output: Any) -> "subprocess.Popen[bytes]":
    code = (
        "import importlib, sys; sys.argv = ['part', %r]; "
        "sys.exit(importlib.import_module(%r).main(sys.argv[1]))" % (request, module)
    )
    environment = dict(os.environ, FREECAD_USER_HOME=home, MPLCONFIGDIR=home)
    command = [freecad_command(), "-c", code, "-M", module_folder()]
    if shutil.which(
        "setpriv"
    ):  # Linux: the kernel ends it with the one that started it, however that ends
        command = ["setpriv", "--pdeathsig", "KILL"] + command
    return subprocess.Popen(
        command,
        stdin=subprocess.DEVNULL,
        stdout=output,
        stderr=subprocess.STDOUT,
        env=environment,
        start_new_session=True,
    )


def _wait(
    process: Any, limits: Dict[str, float], begin: float, stop: Optional[threading.Event]
) -> "tuple[Optional[Dict[str, Any]], float]":
    """(a result if a limit was passed, else None; peak of the resident memory [KiB])."""
    peak = 0.0
    seconds, mib = limits.get("seconds"), limits.get("memory_mib")
    try:
        while process.poll() is None:
            peak = max(peak, _resident(process.pid))
            if mib and peak > 1024.0 * mib:
                _end(process)
                return _over("memory", "it needed more than %g MiB of memory" % mib), peak
            if seconds and time.monotonic() - begin > seconds:
                _end(process)
                return _over("time", "it took longer than %g s" % seconds), peak
            if stop is not None and stop.is_set():
                _end(process)
                return {"status": "stopped", "reason": "the run was stopped."}, peak
            time.sleep(POLL_SECONDS)
    except BaseException:
        _end(process)
        raise
    return None, peak


def _over(status: str, reason: str) -> Dict[str, Any]:
    return {"status": status, "reason": reason + ": raise the recipe's limit or take a smaller part."}


def _end(process: Any) -> None:
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass  # it ended by itself meanwhile
    process.wait()


def _resident(pid: int) -> float:
    """Peak of the resident memory of a process [KiB]; 0 where the system does not say."""
    try:
        with open("/proc/%d/status" % pid, encoding="ascii") as file:
            for line in file:
                if line.startswith("VmHWM:"):
                    return float(line.split()[1])
    except OSError:
        pass  # it has just ended, or this is no Linux
    return 0.0


def _answer(folder: str, returncode: int, log: str) -> Dict[str, Any]:
    name = os.path.join(folder, ".answer.json")
    if os.path.isfile(name):
        with open(name, encoding="utf-8") as file:
            result: Dict[str, Any] = json.load(file)
        os.unlink(name)
        return result
    how = "ended by signal %d" % -returncode if returncode < 0 else "ended with status %d" % returncode
    return {"status": "died", "reason": "FreeCAD %s: %s" % (how, _last_line(log))}


def _last_line(log: str) -> str:
    with open(log, encoding="utf-8", errors="replace") as file:
        lines = [line.strip() for line in file if line.strip()]
    return lines[-1][:200] if lines else "it said nothing"

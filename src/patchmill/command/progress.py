"""A run's progress: on a terminal one line that changes, with the time left; elsewhere a line for each part.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import logging
import os
import shutil
import sys
import time
from typing import Any, Dict

from patchmill.batch.outputs import OutputFolder

LOG = logging.getLogger("patchmill.run")


class Progress:
    """Is called after each part: see patchmill.batch.run. Parts that an earlier run has finished tell nothing
    about the time that is left."""

    def __init__(self, out: OutputFolder, verbose: bool) -> None:
        self.out = out
        self.begin = time.monotonic()
        self.made = 0
        self.terminal = sys.stdout.isatty() and not verbose

    def __call__(self, number: int, of: int, name: str, result: Dict[str, Any], made: bool) -> None:
        self.made += made
        done = "" if made else " earlier"
        line = "%d of %d%s: %s: %s%s" % (number, of, self._left(of - number), name, result["status"], done)
        if self.terminal:
            sys.stdout.write("\r\033[K" + line[: shutil.get_terminal_size().columns - 1])
            sys.stdout.flush()
        else:
            print(line, flush=True)
        self._log(name, result)

    def _left(self, parts: int) -> str:
        if not self.made:
            return ""
        seconds = (time.monotonic() - self.begin) / self.made * parts
        return ", %d min %02d s left" % divmod(round(seconds), 60)

    def _log(self, name: str, result: Dict[str, Any]) -> None:
        """What FreeCAD said of the part."""
        run = result.get("run", {})
        LOG.info("%s: %s s, %s MiB", name, run.get("seconds"), run.get("memory_mib"))
        log = os.path.join(self.out.part_folder(name), "log.txt")
        if LOG.isEnabledFor(logging.INFO) and os.path.isfile(log):
            with open(log, encoding="utf-8", errors="replace") as file:
                for row in file:
                    if row.strip():
                        LOG.info("%s: %s", name, row.strip())

    def end(self) -> None:
        """Leaves the line."""
        if self.terminal:
            sys.stdout.write("\n")

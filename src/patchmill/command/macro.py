"""The call that runs a macro in FreeCADCmd, with arguments and with the macro's own exit status.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import subprocess
from typing import Any

from patchmill.batch import process
from patchmill.batch.problem import BatchError


def run(options: Any) -> int:
    """Runs a Python file with this PatchMill; returns its exit status. Raises BatchError."""
    if not os.path.isfile(options.file):
        raise BatchError("macro", options.file, "there is no such file.")
    words = [os.path.abspath(options.file), *options.arguments]
    code = "import runpy, sys; sys.argv = %r; runpy.run_path(sys.argv[0], run_name='__main__')" % words
    command = [process.freecad_command(), "-c", code, "-M", process.module_folder()]
    return subprocess.run(command, stdin=subprocess.DEVNULL).returncode

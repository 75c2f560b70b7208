"""LinuxCNC's own interpreter, rs274, on a program: what it would tell the planner.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import re
import subprocess
import tempfile
from pathlib import Path

INI = """[EMC]
VERSION = 1.1
[RS274NGC]
PARAMETER_FILE = machine.var
[TRAJ]
COORDINATES = X Y Z
LINEAR_UNITS = mm
ANGULAR_UNITS = deg
[EMCIO]
TOOL_TABLE = machine.tbl
"""

CALL = re.compile(r"N\.{5}\s+(\w+)\((.*)\)\s*$")


def interpret(program, tools=(1,)):
    """Canonical calls of a program file: a list of (name, [numbers or texts]). `tools`: their numbers.
    Raises RuntimeError with the interpreter's words if it refuses the program."""
    with tempfile.TemporaryDirectory() as folder:
        ini = Path(folder) / "machine.ini"
        ini.write_text(INI)
        table = "".join("T%d P%d Z0 D0.0787402\n" % (tool, tool) for tool in tools)
        (Path(folder) / "machine.tbl").write_text(table)
        (Path(folder) / "machine.var").write_text("")
        done = subprocess.run(
            ["rs274", "-g", "-i", str(ini), "-t", "machine.tbl", "-v", "machine.var"]
            + [str(Path(program).resolve())],
            cwd=folder,
            capture_output=True,
            text=True,
            timeout=120,
        )
    if done.returncode:
        raise RuntimeError(done.stderr.strip())
    return [_call(*found.groups()) for found in map(CALL.search, done.stdout.splitlines()) if found]


def _call(name, arguments):
    values = []
    for word in arguments.split(","):
        try:
            values.append(float(word))
        except ValueError:
            values.append(word.strip())
    return name, values

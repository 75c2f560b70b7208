"""Readers that are written in Python, each a function of any bytes: what they hold is read, or refused by a
sentence; anything else is raised (python_reader.cpp). Needs no FreeCAD but its module.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import atexit
import os
import pathlib
import shutil
import sys
import tempfile
import warnings

sys.path.append("/usr/lib/freecad/lib")

import FreeCAD  # noqa: E402,F401
from patchmill import InputError  # noqa: E402
from patchmill.batch import recipe  # noqa: E402
from patchmill.batch.problem import BatchError  # noqa: E402
from patchmill.machine import freecad_file, machines  # noqa: E402
from patchmill.machine.linuxcnc import machine_of  # noqa: E402
from patchmill.surface import files  # noqa: E402
from patchmill.textures import masks  # noqa: E402

FOLDER = pathlib.Path(tempfile.mkdtemp(prefix="patchmill-fuzz-", dir="/dev/shm"))
atexit.register(shutil.rmtree, FOLDER, True)
os.environ["PATCHMILL_MACHINES"] = str(FOLDER)
(FOLDER / "part.brep").write_text("")
ENDINGS = sorted(files.READERS)


def _read(data, name, read):
    """Whether a file of these bytes was read, not refused."""
    file = FOLDER / name
    file.write_bytes(data)
    try:
        with warnings.catch_warnings(record=True):  # of numpy, as FreeCAD's users see none
            read(str(file))
    except (InputError, BatchError) as error:
        if len(str(error)) < 10:
            raise ValueError("a refusal that says nothing") from error
        str(error).encode()  # can be shown
        return False
    return True


def _machine(name):
    found = machines.load(pathlib.Path(name).stem)
    return found.model, found.kinematics, found.start_phase, found.controller


def machine_files(data):
    """The first byte says whose: PatchMill's own, FreeCAD's, LinuxCNC's."""
    name, read = (("own.json", _machine), ("x.fcm", freecad_file.read), ("x.ini", machine_of.read))[
        data[0] % 3 if data else 0
    ]
    return _read(data[1:], name, read)


def recipes(data):
    """A recipe in a folder with one part."""
    return _read(data, "recipe.json", lambda name: recipe.load(name, []).digest)


def pictures(data):
    """A mask's."""
    return _read(data, "mask.png", masks.read_grey)


def surfaces(data):
    """The first byte says the format."""
    ending = ENDINGS[data[0] % len(ENDINGS)] if data else ".csv"
    return _read(data[1:], "x" + ending, lambda name: files.load(name, 0.1, 0.01))

"""One function for each kind of file that PatchMill writes, for tests of faults while they are written.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import contextlib
import datetime
import os
import pathlib
import tempfile
import time
from unittest import mock

import patchmill
from matplotlib.figure import Figure
from milling_jobs import add_pocket, dress, make_job, pocket_part
from patchmill import posting
from patchmill.machine import machines
from patchmill.modifiers import dcm_input
from patchmill.posting import several_files
from patchmill.reports import pictures, relief_pictures, report
from patchmill.surface import dimple_table, sdf, x3p
from patchmill.surface import files as surface_files
from patchmill.surface.height_map import HeightMap
from patchmill.voxels import removal_model
from recipe import small_job

AT = datetime.datetime(2026, 11, 22, 12, 0, 0, tzinfo=datetime.timezone.utc)


def writers():
    """{kind: (name of its file, write(path, version))} for versions 0 and 1, which differ. `write` raises
    InputError, or returns what it says of a file that could not be kept."""
    _, job, op = small_job(name="faults")
    op.PatchSide = 3
    patchmill.recompute(op)
    texts, posted = _posted(job)
    relief, endings = patchmill.simulate(op, step=0.1), (*surface_files.GRIDS, *surface_files.MESHES)
    return {
        **{ending: ("x" + ending, _relief(relief, ending)) for ending in endings},
        "program": ("x.ngc", lambda path, version: posting.write(path, texts[version])),
        "voxels": ("x.voxels", _voxels()),
        "machine": ("own.json", _machine),
        "report": ("report.json", _report(patchmill.planned(op), posted)),
        "picture": ("x.png", _picture),
        "table": ("x.csv", _table(relief)),
        "files": ("x-files.csv", _several(job)),
    }


def _posted(job):
    """The programs of both versions, and what was posted."""
    texts = []
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "x.ngc")
        for header in ("", "--no-header "):
            posted = patchmill.post(job, name, "patchmill_linuxcnc", header + "--precision=3")
            texts.append(pathlib.Path(name).read_text(encoding="ascii"))
    return texts, posted[0]


def _voxels():
    _, job = make_job(pocket_part())
    dressup = dress(add_pocket(job))
    dressup.VoxelSize = 4.0
    model = removal_model.make(dcm_input.input_of(dressup).model)

    def write(path, version):
        model.files.clear()
        model.keep(path, "key %d" % version)
        return model.not_saved

    return write


def _machine(path, version):
    data = dict(machines.load("linuxcnc-mill").data, name="version %d" % version)
    with mock.patch.dict(os.environ, PATCHMILL_MACHINES=os.path.dirname(path)):
        machines.save("own", data)


def _report(plan, posted):
    """Without its pictures, which are files of another kind."""

    def draw(*arguments):
        return arguments[-1]

    def write(path, version):
        drawn = {name: draw for name in ("draw_dimples", "draw_path", "draw_phase_error")}
        with mock.patch.multiple(pictures, **drawn):
            report.write_report(posted, plan, "%d.ngc" % version, os.path.dirname(path))

    return write


def _picture(path, version):
    figure = Figure(figsize=(2.0, 2.0), dpi=50)
    figure.add_subplot().plot([0, 1 + version])
    relief_pictures.save(figure, path)


def _table(simulated):
    def write(path, version):
        columns = dimple_table.COLUMNS[: len(dimple_table.COLUMNS) - version] + ("edge",) * version
        with mock.patch.object(dimple_table, "COLUMNS", columns):
            dimple_table.save(path, simulated)

    return write


def _relief(simulated, ending):
    whole = simulated.height_map()
    maps = [whole, HeightMap(whole.heights[:-1], whole.step, whole.origin, "smaller")]

    def write(path, version):
        hour = {"datetime": mock.Mock(**{"now.return_value": AT}), "timezone": datetime.timezone}
        with contextlib.ExitStack() as stack:  # some formats hold when they were written
            for module in (sdf, x3p):
                stack.enter_context(mock.patch.object(module, "datetime", mock.Mock(**hour)))
            stack.enter_context(mock.patch.object(time, "localtime", return_value=AT.timetuple()))
            surface_files.save(path, maps[version])

    return write


def _several(job):
    """The table of a job's programs, which are posted once here, and are files of another kind."""
    made = []
    with tempfile.TemporaryDirectory() as folder:
        for patches in (0, 1):
            made.append(several_files.post_files(job, os.path.join(folder, "x.ngc"), patches))

    def write(path, version):
        known = {
            "_groups": lambda *_: [None],
            "_divided": lambda *_: [None],
            "_posted": lambda *_: made[version],
            "_name": lambda *_: None,
        }
        with mock.patch.multiple(several_files, **known):
            with mock.patch.object(several_files.posting, "write", lambda *_: None):
                several_files.post_files(job, path.replace("-files.csv", ".ngc"))

    return write

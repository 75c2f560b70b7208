"""Ctrl-C in FreeCADCmd, pressed by another process as by a user: each long call ends as KeyboardInterrupt,
and the same process goes on as before.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

from patchmill.batch import process

HERE = pathlib.Path(__file__).resolve().parent
SECONDS = 300  # for FreeCAD and all calls, on a busy machine
SCRIPT = """
import os, sys, tempfile
sys.path.insert(0, %r)
import FreeCAD, Part, patchmill
from milling_jobs import add_pocket, dress, make_job, pocket_part
from parts import job_on
from patchmill.modifiers import dcm_input
from patchmill.operations import copy_input, copy_milling, texture_operation
from patchmill.verify import checks
from patchmill.voxels import removal_model
from recipe import small_job

_, job, op = small_job(name="interrupted")
op.PatchSide = 12
given = op.Proxy.texture_input(op)
patchmill.recompute(op)
to_check = checks.check_input(op)
program = os.path.join(tempfile.mkdtemp(), "x.ngc")
_, curved = job_on(Part.makeTorus(40, 15).common(Part.makeBox(80, 80, 40)), "Face1")
curved.Mapping, curved.PatchSide, curved.Spacing = "On surface", 6, 0.5
on_surface = curved.Proxy.texture_input(curved)
_, milling = make_job(pocket_part(), ball=True)
copy = patchmill.CopyMilling.Create("Copy", parentJob=milling)
patchmill.recompute(copy)
to_copy = copy_input.input_of(copy)
_, milling = make_job(pocket_part())
dressup = dress(add_pocket(milling))
dressup.VoxelSize = 0.3
model = dcm_input.input_of(dressup).model
CALLS = {
    "texture": lambda: texture_operation.prepare(given),
    "on surface": lambda: texture_operation.prepare(on_surface),
    "simulate": lambda: patchmill.simulate(op),
    "check": lambda: checks.run_check(to_check),
    "post": lambda: patchmill.post(job, program, "patchmill_linuxcnc", "--precision=3"),
    "copy milling": lambda: copy_milling.mill(to_copy),
    "voxels": lambda: removal_model.make(model),
}
for name, call in CALLS.items():
    call()
    try:
        print("begun", name, flush=True)
        while True:
            call()
    except KeyboardInterrupt:
        print("ended", name, flush=True)
print("files", sorted(os.listdir(os.path.dirname(program))), flush=True)
patchmill.recompute(op)
print("goes on", flush=True)
os._exit(0)
"""
CALLS = ["texture", "on surface", "simulate", "check", "post", "copy milling", "voxels"]


class CtrlC(unittest.TestCase):
    def test_ends_each_long_call_and_no_more(self):
        with tempfile.TemporaryDirectory() as home:
            started = subprocess.Popen(
                [process.freecad_command(), "-c", SCRIPT % str(HERE), "-M", process.module_folder()],
                env=dict(os.environ, FREECAD_USER_HOME=home, MPLCONFIGDIR=home, TMPDIR=home),
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                text=True,
                # what a shell starts in the background hears no Ctrl-C, nor does what that starts
                preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
            )
            ended = threading.Timer(SECONDS, started.kill)
            ended.start()
            try:
                said = self.pressed(started)
            finally:
                ended.cancel()
                started.kill()
                started.wait()
        self.assertEqual([line[6:] for line in said if line.startswith("ended ")], CALLS, said)
        self.assertEqual(said[-1], "goes on", said)
        files = next(line for line in said if line.startswith("files "))
        self.assertIn(files, ("files ['x.ngc']", "files []"))

    def pressed(self, started):
        """All lines; Ctrl-C is pressed a while after each `begun`, another while every time."""
        said = []
        with started.stdout as lines:
            for line in lines:
                line = line.strip()
                if not line or line.endswith("%)"):
                    continue
                said.append(line)
                if line.startswith("begun "):
                    time.sleep(0.03 * len(said))
                    started.send_signal(signal.SIGINT)
        return said


if __name__ == "__main__":
    outcome = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if outcome.wasSuccessful() and outcome.testsRun else 1)

"""A recipe on the workers of a Dask scheduler, one of which is lost on the way.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import os
import shutil
import subprocess
import sys
import threading
import time
import unittest

from batch_calls import MODULE, RECIPE, STEP, WithFolder, call  # first: it finds the module

from patchmill.batch import compare, index


class Cluster(WithFolder):
    """A scheduler and two workers on loopback, one of which is killed while it has a part."""

    def start(self, *arguments):
        process = subprocess.Popen(
            [sys.executable, "-m"] + list(arguments),
            env=dict(os.environ, PYTHONPATH=MODULE, DASK_DISTRIBUTED__DASHBOARD__LINK=""),
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            cwd=self.folder,
        )
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def test_a_worker_that_is_killed_changes_nothing(self):
        for name in ("a", "b", "c", "d"):
            shutil.copy(STEP, self.path(name + ".step"))
        name = self.write(RECIPE)
        self.assertEqual(call("run", name, "-o", self.path("here"), "-j", "2")[0], 0)
        address_file = self.path("scheduler.json")
        self.start(
            "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0",
            "--no-dashboard", "--scheduler-file", address_file,
        )  # fmt: skip
        while not os.path.isfile(address_file) or not os.path.getsize(address_file):
            time.sleep(0.1)
        with open(address_file, encoding="utf-8") as file:
            address = json.load(file)["address"]
        worker = (
            "distributed.cli.dask_worker",
            address,
            "--nthreads",
            "1",
            "--no-nanny",
            "--no-dashboard",
            "--host",
            "127.0.0.1",
        )
        self.start(*worker)
        lost = self.start(*worker)
        threading.Timer(6.0, lost.kill).start()
        status, said = call("run", name, "-o", self.path("there"), "--cluster", address)
        self.assertEqual(status, 0, said)
        here, there = (
            index.without_times(compare.load(self.path(o, "index.json"))) for o in ("here", "there")
        )
        self.assertEqual(here, there)

    def test_no_scheduler(self):
        shutil.copy(STEP, self.path("a.step"))
        status, said = call(
            "run", self.write(RECIPE), "-o", self.path("out"), "--cluster", "tcp://127.0.0.1:1"
        )
        self.assertEqual(status, 2)
        self.assertIn("no scheduler answers", said)


if __name__ == "__main__":
    unittest.main()

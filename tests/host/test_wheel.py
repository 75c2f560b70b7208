"""A wheel of the core that runs here: it shares no symbol and no library with FreeCAD, and works beside
FreeCAD's own OpenCASCADE, also where that is there for everybody (RTLD_GLOBAL).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import glob
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile

import _patchmill
from patchmill.install import core_loader, wheels

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
PACKAGING = os.path.join(ROOT, "packaging", "wheel")
sys.path.insert(0, PACKAGING)
import elf  # noqa: E402
import symbols  # noqa: E402

PROGRAM = os.environ.get("FREECADCMD", "freecadcmd")
SCRIPT = """
import os, re, sys
sys.setdlopenflags(os.RTLD_NOW | os.RTLD_GLOBAL)
import Part
sys.path.insert(0, %(folder)r)
import _patchmill as core
import numpy as np
import tempfile
model = core.part_model([Part.makeSphere(5).exportBrepToString()], 0.05)
print("distance %%.2f" %% model.distances(np.array([[0.0, 0.0, 7.0]]))[0])
try:
    core.part_model(["no shape"], 0.05)
except core.InputError as error:
    print("refused", error.property)
print("volume %%.3f" %% Part.makeBox(2, 2, 2).cut(Part.makeBox(1, 1, 1)).Volume)
print("kernels", len(set(re.findall(r"/\\S*libTKernel\\S*", open("/proc/self/maps").read()))))
"""


@unittest.skipUnless(shutil.which("patchelf") and shutil.which("dpkg-query"), "no patchelf here to pack with")
class Wheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp()
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        pack = [shutil.which("python3", path="/usr/bin"), os.path.join(PACKAGING, "pack.py")]
        core = os.path.realpath(_patchmill.__file__)
        if os.path.isdir(os.path.join(os.path.dirname(core), "patchmill_core.libs")):
            raise unittest.SkipTest("the core is a wheel's already")
        words = [*pack, core, core_loader.version(), core_loader.tag(), cls.folder]
        done = subprocess.run(words, capture_output=True, text=True)
        assert done.returncode == 0, done.stdout + done.stderr
        cls.wheel = done.stdout.strip()
        cls.inside = os.path.join(cls.folder, "inside")
        with zipfile.ZipFile(cls.wheel) as archive:
            archive.extractall(cls.inside)
        cls.files = glob.glob(os.path.join(cls.inside, "*.so"))
        cls.files += glob.glob(os.path.join(cls.inside, "patchmill_core.libs", "*"))

    def test_it_fits_this_python(self):
        self.assertEqual(wheels.fits(self.wheel), "")

    def test_it_defines_no_name_that_another_has(self):
        self.assertGreater(len(self.files), 8)
        for file in self.files:
            self.assertEqual(symbols.defined_names(file), set(), file)
            with open(file, "rb") as stream:
                bindings = {binding for _, binding, _ in elf.dynamic_symbols(stream.read())}
            self.assertNotIn(elf.UNIQUE, bindings, file)
            self.assertNotRegex(" ".join(elf.needed(file)), r"Coin|libX|libGL|python")

    def test_it_works_beside_freecads_own_opencascade(self):
        script = os.path.join(self.folder, "script.py")
        with open(script, "w", encoding="utf-8") as file:
            file.write(SCRIPT % dict(folder=self.inside))
        done = subprocess.run(
            [PROGRAM, "-c", "exec(open(%r).read())" % script],
            env=dict(os.environ, FREECAD_USER_HOME=os.path.join(self.folder, "home")),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
        )
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        for words in ("distance 2.00", "refused Model", "volume 7.000", "kernels 2"):
            self.assertIn(words, done.stdout)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)

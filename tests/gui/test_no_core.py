"""The workbench without its compiled core: one window that says what is missing and installs it; documents
open.
Runs on a copy of the module without a core (CMakeLists.txt gives PATCHMILL_MODULE).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import base64
import glob
import hashlib
import os
import platform
import shutil
import sys
import unittest
import zipfile

import FreeCAD
import FreeCADGui
from patchmill.install import core_loader, wheels
from PySide import QtGui

import driver


def wheel_of(folder, name, files):
    """A wheel with the given files, {name: bytes}, and a right list of them."""
    about = "patchmill_core-%s.dist-info/RECORD" % core_loader.version()
    rows = []
    path = os.path.join(folder, name)
    with zipfile.ZipFile(path, "w") as archive:
        for file, data in files.items():
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode("ascii")
            rows.append("%s,sha256=%s,%d" % (file, digest, len(data)))
            archive.writestr(file, data)
        archive.writestr(about, "\n".join([*rows, about + ",,", ""]))
    return path


def name_of_wheel(version=None, python=None):
    version, python = version or core_loader.version(), python or core_loader.tag()
    return "patchmill_core-%s-%s-%s-linux_%s.whl" % (version, python, python, platform.machine())


def open_window():
    """The window, if it is shown."""
    for form in FreeCADGui.getMainWindow().findChildren(QtGui.QDialog, "PatchMillCoreWindow"):
        if form.isVisible():
            return form
    return None


def text_of(form):
    return " ".join(label.text() for label in form.findChildren(QtGui.QLabel))


@unittest.skipUnless(core_loader.why_absent(), "it is about a module without its core")
class NoCore(unittest.TestCase):
    def setUp(self):
        shutil.rmtree(os.path.dirname(core_loader.core_folder()), ignore_errors=True)
        FreeCADGui.activateWorkbench("PatchMillWorkbench")
        self.assertTrue(driver.wait(open_window, 20), "no window came up")
        self.form = open_window()

    def tearDown(self):
        self.form.reject()
        FreeCADGui.activateWorkbench("PartWorkbench")
        shutil.rmtree(os.path.dirname(core_loader.core_folder()), ignore_errors=True)

    def button(self, words):
        (found,) = [b for b in self.form.findChildren(QtGui.QPushButton) if words in b.text()]
        return found

    def install_button(self):
        (found,) = [b for b in self.form.findChildren(QtGui.QPushButton) if b.text() == "Install"]
        return found

    def test_it_says_what_is_missing_and_for_which_freecad(self):
        text = text_of(self.form)
        self.assertIn("The compiled core for Python %d.%d is not installed" % sys.version_info[:2], text)
        self.assertIn("FreeCAD %s.%s" % tuple(FreeCAD.Version()[:2]), text)
        picture = os.environ.get("PATCHMILL_PICTURE")
        if picture:
            driver.rest(1.0)
            QtGui.QApplication.primaryScreen().grabWindow(0).save(picture)

    def test_it_is_closed_and_comes_back_with_its_command(self):
        self.button("Close").click()
        self.assertIsNone(open_window())
        FreeCADGui.runCommand("PatchMill_InstallCore")
        self.form = open_window()
        self.assertIn("is not installed", text_of(self.form))

    def test_the_command_can_be_copied(self):
        self.button("Copy").click()
        copied = QtGui.QApplication.clipboard().text()
        self.assertIn("-m pip install", copied)
        self.assertIn(core_loader.core_folder(), copied)

    def test_a_wheel_is_installed_and_goes_again(self):
        folder = os.path.join(core_loader.module_root(), "wheels")
        os.makedirs(folder, exist_ok=True)
        self.addCleanup(shutil.rmtree, folder)
        wheel_of(folder, name_of_wheel(python="cp36"), {})  # not for this Python: passed over
        made = wheels.at_hand([os.path.join(os.environ["PATCHMILL_GUI_ROOT"], "dist")])
        built = glob.glob(os.path.join(os.environ["PATCHMILL_GUI_ROOT"], "build/Mod/PatchMill/_patchmill.*"))
        if made:
            shutil.copy(made[0], folder)
        elif built:
            with open(built[0], "rb") as file:
                wheel_of(folder, name_of_wheel(), {os.path.basename(built[0]): file.read()})
        else:
            self.skipTest("no compiled core was built here, and there is no wheel")
        self.install_button().click()
        self.assertIn("Installed. Start FreeCAD again", text_of(self.form))
        self.assertEqual(core_loader.why_absent(), "")
        wheels.remove()
        self.assertFalse(os.path.exists(core_loader.core_folder()))
        del sys.modules[core_loader.NAME]  # for the tests that follow
        self.assertTrue(core_loader.load())

    def test_what_does_not_fit_or_is_damaged_is_refused(self):
        folder = core_loader.module_root()
        for name, said in (
            (name_of_wheel("0.0.1"), "is of version 0.0.1"),
            (name_of_wheel(python="cp36"), "is for Python 3.6"),
            ("patchmill_core.zip", "is no wheel"),
        ):
            with self.assertRaisesRegex(wheels.InstallError, said):
                wheels.install(os.path.join(folder, name))
        wheel = wheel_of(folder, name_of_wheel(), {"_patchmill.so": b"whole"})
        self.addCleanup(os.remove, wheel)
        with zipfile.ZipFile(wheel, "a") as archive:
            archive.writestr("more.py", b"nobody knows it")
        with self.assertRaisesRegex(wheels.InstallError, "damaged"):
            wheels.install(wheel)
        self.assertFalse(os.path.exists(core_loader.core_folder()))


def main():
    return driver.run_tests(NoCore)

"""Puts a wheel's core into `core/TAG` below the add-on's folder, so that it goes when the add-on goes. Needs
nothing but Python: a wheel is a zip file with a list of its files and their hashes. Where no wheel is at
hand, pip fetches one, if this Python has pip.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import base64
import csv
import glob
import hashlib
import io
import os
import platform
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

from patchmill.install import core_loader

PACKAGE = "patchmill-core"


class InstallError(Exception):
    """What went wrong, in one sentence."""


def interpreter():
    """The command of the Python that runs: inside FreeCAD, sys.executable is FreeCAD, or empty."""
    version = "%d.%d" % sys.version_info[:2]
    folders = [os.path.join(sys.base_prefix, "bin"), sys.base_prefix, sysconfig.get_path("scripts") or ""]
    for folder in folders:
        for name in ("python" + version, "python3", "python.exe", "python"):
            if os.path.isfile(os.path.join(folder, name)):
                return os.path.join(folder, name)
    return shutil.which("python" + version) or ""


def command():
    """What a user can type in a terminal to install the core, a list of words."""
    target = core_loader.core_folder()
    wanted = "%s==%s" % (PACKAGE, core_loader.version())
    python = interpreter() or "python%d.%d" % sys.version_info[:2]
    words = [python, "-m", "pip", "install", "--no-deps", "--only-binary", ":all:", "--upgrade"]
    return words + ["--target", target, wanted]


def fits(wheel):
    """'' if a wheel's name says that it is for this PatchMill, Python and machine, else what it is for."""
    match = re.match(r"patchmill_core-([^-]+)-(cp\d+)-\w+-(\w+)\.whl$", os.path.basename(wheel))
    if not match:
        return "it is no wheel of %s" % PACKAGE
    version, python, machine = match.groups()
    if version != core_loader.version():
        return "it is of version %s, and PatchMill is %s" % (version, core_loader.version())
    if python != core_loader.tag():
        name = re.sub(r"cp(\d)(\d+)", r"\1.\2", python)
        return "it is for Python %s, and this FreeCAD has Python %d.%d" % (name, *sys.version_info[:2])
    if not machine.endswith(platform.machine().lower()) or not machine.startswith(_systems()):
        return "it is for %s" % machine
    return ""


def _systems():
    return {"linux": ("linux", "manylinux"), "win32": ("win",), "darwin": ("macosx",)}.get(sys.platform, ())


def at_hand(folders=()):
    """Wheels that fit, in `folders`, in `wheels` and `dist` below the add-on's folder and in the user's
    downloads."""
    return [file for file in _near(folders) if not fits(file)]


def _near(folders=()):
    """All wheels there, whether they fit or not."""
    root = core_loader.module_root()
    places = [*folders, os.path.join(root, "wheels"), os.path.join(root, "dist")]
    places.append(os.path.join(os.path.expanduser("~"), "Downloads"))
    patterns = [os.path.join(glob.escape(place), "patchmill_core-*.whl") for place in places]
    return [file for pattern in patterns for file in sorted(glob.glob(pattern))]


def install(wheel):
    """Unpacks a wheel that fits. Raises InstallError; then nothing is changed."""
    reason = fits(wheel)
    if reason:
        raise InstallError("%s cannot be used: %s." % (os.path.basename(wheel), reason))
    target = core_loader.core_folder()
    try:
        os.makedirs(os.path.dirname(target), exist_ok=True)
        part = tempfile.mkdtemp(dir=os.path.dirname(target))
        try:
            _unpack(wheel, part)
            remove()
            os.rename(part, target)
        finally:
            shutil.rmtree(part, ignore_errors=True)
    except (OSError, zipfile.BadZipFile) as error:
        raise InstallError("%s cannot be unpacked: %s." % (os.path.basename(wheel), error)) from error


def _unpack(wheel, folder):
    with zipfile.ZipFile(wheel) as archive:
        (record,) = [n for n in archive.namelist() if n.endswith(".dist-info/RECORD")]
        rows = list(csv.reader(io.StringIO(archive.read(record).decode("utf-8"))))
        for name, digest, _ in rows:
            if not digest:
                continue
            kind, wanted = digest.split("=", 1)
            seen = base64.urlsafe_b64encode(hashlib.new(kind, archive.read(name)).digest()).rstrip(b"=")
            if seen.decode("ascii") != wanted:
                raise InstallError("%s is damaged: %s is not as it was." % (os.path.basename(wheel), name))
        unlisted = set(archive.namelist()) - {row[0] for row in rows}
        if unlisted:
            raise InstallError("%s is damaged: nobody knows %s." % (os.path.basename(wheel), min(unlisted)))
        archive.extractall(folder)


def fetch():
    """Lets pip fetch and install the wheel. Raises InstallError with what pip says last, and why a wheel that
    lies near was not taken."""
    try:
        _fetch()
    except InstallError as error:
        for file in _near():
            if fits(file):
                text = "%s %s cannot be used: %s." % (error, os.path.basename(file), fits(file))
                raise InstallError(text) from error
        raise


def _fetch():
    if not interpreter():
        raise InstallError("this FreeCAD comes without a Python interpreter to run pip with.")
    try:
        os.makedirs(os.path.dirname(core_loader.core_folder()), exist_ok=True)
        done = subprocess.run(command(), capture_output=True, text=True, timeout=600,
                              stdin=subprocess.DEVNULL)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise InstallError("pip could not be run: %s." % error) from error
    if done.returncode:
        said = [line for line in done.stderr.splitlines() if line.strip()] or ["no reason given"]
        raise InstallError("pip could not install it: %s" % said[-1])


def remove():
    """Takes the unpacked core away, if there is one."""
    shutil.rmtree(core_loader.core_folder(), ignore_errors=True)

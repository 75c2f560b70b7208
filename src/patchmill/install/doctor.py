"""`patchmill doctor`: what this installation is, and what is wrong with it, for the user and for a bug
report.

    freecadcmd -c "from patchmill.install import doctor; doctor.main()"

Works without the core, and without FreeCAD as far as that goes. What could not be looked at is unknown, which
is neither right nor wrong.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import glob
import importlib
import os
import platform
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass

from patchmill.install import core_loader

RIGHT, WRONG, UNKNOWN = "ok", "wrong", "unknown"
OLDEST, NEWEST = (0, 20), (1, 1)  # FreeCADs that the tests have run in


@dataclass
class Finding:
    """One line: what was looked at, RIGHT, WRONG or UNKNOWN, what was seen, and what to do if it is not
    right."""

    what: str
    state: str
    seen: str
    remedy: str = ""

    def text(self):
        line = "%-8s %-22s %s" % (self.state, self.what, self.seen)
        return line + ("\n%s-> %s" % (" " * 32, self.remedy) if self.remedy else "")


def findings():
    """All findings, a list."""
    found = []
    for look in LOOKS:
        try:
            found += look()
        except Exception as error:  # whatever it is belongs into the report, and the rest is still looked at
            found.append(Finding(look.__name__.strip("_"), UNKNOWN, "%s: %s" % (type(error).__name__, error)))
    return found


def _host():
    try:
        import FreeCAD
    except ImportError:
        return [Finding("FreeCAD", UNKNOWN, "this is %s, not FreeCAD" % sys.executable)]
    version = ".".join(str(v) for v in FreeCAD.Version()[:3]).split(" ")[0]
    numbers = tuple(int(v) for v in FreeCAD.Version()[:2])
    seen = "%s%s" % (version, "" if FreeCAD.GuiUp else ", no GUI")
    if numbers < OLDEST:
        return [Finding("FreeCAD", WRONG, seen, "PatchMill needs %d.%d or later." % OLDEST)]
    if numbers > NEWEST:
        return [Finding("FreeCAD", UNKNOWN, seen, "newer than any that PatchMill was tested in.")]
    return [Finding("FreeCAD", RIGHT, seen)]


def _python():
    seen = "%s, %s %s" % (platform.python_version(), platform.system(), platform.machine())
    return [Finding("Python", RIGHT, seen)]


def _place():
    root = core_loader.module_root()
    kind = "a clone" if os.path.isdir(os.path.join(root, "src", "patchmill")) else "built or installed"
    return [Finding("PatchMill", RIGHT, "%s, %s: %s" % (core_loader.version(), kind, root))]


def _copies():
    """Another PatchMill on the path would give this one its modules, or take them."""
    possible = {os.path.realpath(os.path.join(p, "patchmill", "__init__.py")) for p in sys.path}
    found = sorted(f for f in possible if os.path.isfile(f))
    if len(found) < 2:
        return [Finding("copies", RIGHT, "one PatchMill on Python's path")]
    return [Finding("copies", WRONG, ", ".join(found), "keep one of them.")]


def _core():
    reason = core_loader.why_absent()
    if reason:
        return [Finding("core", WRONG, reason, "install it: docs/troubleshooting.md.")]
    core = sys.modules[core_loader.NAME]
    return [Finding("core", RIGHT, "%s: %s" % (core.__version__, core.__file__))]


def _opencascade():
    """Which libraries of OpenCASCADE the process has: the host's, and the core's own."""
    try:
        with open("/proc/self/maps", encoding="utf-8") as file:
            loaded = sorted({os.path.realpath(p) for p in re.findall(r"(/\S*libTKernel\S*)", file.read())})
    except OSError:
        loaded = []
    try:
        import Part

        seen = "FreeCAD's is %s" % Part.OCC_VERSION
    except ImportError:
        seen = "FreeCAD's is not loaded"
    return [Finding("OpenCASCADE", RIGHT if loaded else UNKNOWN, "%s; %s" % (seen, ", ".join(loaded) or "-"))]


def _packages():
    found = []
    for name, purpose in (("numpy", ""), ("pivy", "the display"), ("matplotlib", "reports")):
        try:
            module = importlib.import_module(name)
        except ImportError as error:
            what = "install it for FreeCAD's Python" + (": %s needs it." % purpose if purpose else ".")
            found.append(Finding(name, WRONG, str(error), what))
        else:
            found.append(Finding(name, RIGHT, getattr(module, "__version__", "no version")))
    return found


def _pictures():
    """Qt 6 shows no icon without its plugin for SVG."""
    QtGui = sys.modules.get("PySide6.QtGui") or sys.modules.get("PySide2.QtGui")
    if QtGui is None:
        return [Finding("icons", UNKNOWN, "no GUI here")]
    formats = {bytes(f).decode("ascii") for f in QtGui.QImageReader.supportedImageFormats()}
    if "svg" in formats:
        return [Finding("icons", RIGHT, "Qt reads SVG")]
    return [Finding("icons", WRONG, "Qt reads no SVG", "install its plugin (Debian: qt6-svg-plugins).")]


def _machines():
    if core_loader.why_absent():
        return [Finding("machine files", UNKNOWN, "they are checked by the core")]
    from patchmill.machine import machines

    found = []
    for key in machines.names():
        try:
            machines.load(key)
        except ValueError as error:
            found.append(Finding("machine file", WRONG, str(error), "mend it, or take it away."))
    return found or [Finding("machine files", RIGHT, "%d, all sound" % len(machines.names()))]


def _folder():
    """Where a wheel's core would be put."""
    target = core_loader.core_folder()
    there = [os.path.basename(f) for f in glob.glob(os.path.join(glob.escape(target), "*.so"))]
    parent = core_loader.module_root()
    if there:
        return [Finding("wheel", RIGHT, os.path.join(target, there[0]))]
    state = RIGHT if os.access(parent, os.W_OK) else UNKNOWN
    return [Finding("wheel", state, "none in %s" % target)]


LOOKS = (_host, _python, _place, _copies, _core, _opencascade, _packages, _pictures, _machines, _folder)


def report():
    """The findings as text."""
    found = findings()
    wrong = sum(f.state == WRONG for f in found)
    last = "nothing is wrong" if not wrong else "%d wrong" % wrong
    return "\n".join([f.text() for f in found] + [last])


def main():
    """Prints the report; returns 1 if something is wrong."""
    text = report()
    print(text, flush=True)  # FreeCAD may end without
    return int(not text.endswith("nothing is wrong"))


def in_freecad():
    """As main, in the FreeCADCmd that is found (FREECADCMD names another), and here where there is none."""
    program = shutil.which(os.environ.get("FREECADCMD", "freecadcmd"))
    if program is None:
        return main()
    script = "import sys; from patchmill.install import doctor; sys.exit(doctor.main())"
    words = [program, "-c", script, "-M", core_loader.module_root()]
    return subprocess.run(words, stdin=subprocess.DEVNULL).returncode


if __name__ == "__main__":
    sys.exit(main())

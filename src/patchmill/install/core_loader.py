"""Loads the compiled core, `_patchmill`, or says in one sentence why it cannot be loaded.

It is looked for beside the packages, where a build or a distribution's package puts it, and in `core/TAG`
below the add-on's folder, where a wheel is unpacked to (wheels.py). Without a core `_patchmill` is a
stand-in: our classes load, so that a document keeps its operations, and whatever would compute raises
InputError with that sentence.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import glob
import importlib
import importlib.machinery
import importlib.util
import os
import re
import sys
import types

NAME = "_patchmill"
REMEDY = "run PatchMill's workbench in FreeCAD, which offers to install it, or see docs/troubleshooting.md."


class CoreInputError(ValueError):
    """As the core's InputError: names the property, its value and the remedy."""

    def __init__(self, property, value, remedy):
        super().__init__("%s = %s: %s" % (property, value, remedy))
        self.property = property
        self.value = value
        self.remedy = remedy


CoreInputError.__name__ = CoreInputError.__qualname__ = "InputError"


class Absent:
    """What stands for anything of a core that is not there; calling it raises InputError."""

    def __init__(self, name, reason):
        self._name, self._reason = name, reason

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return Absent("%s.%s" % (self._name, name), self._reason)

    def __call__(self, *args, **kwargs):
        raise absent_error(self._reason)


def absent_error(reason):
    """The InputError of whatever cannot be computed without a core."""
    return CoreInputError("PatchMill's core", "not loaded", "%s; %s" % (reason, REMEDY))


class StandIn(types.ModuleType):
    """The module `_patchmill` where there is no core. `reason`: why, without a full stop."""

    InputError = CoreInputError

    def __init__(self, reason):
        super().__init__(NAME, reason)
        self.reason = reason

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return Absent(name, self.reason)


def tag():
    """Of the Python that runs, as in a wheel's name: 'cp313' for 3.13."""
    return "cp%d%d" % sys.version_info[:2]


def module_root(package_folder=None):
    """The add-on's folder: the nearest one above the package that has a package.xml; else the package's
    parent."""
    folder = package_folder or os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    parent = above = os.path.dirname(folder)
    for _ in range(3):
        if os.path.isfile(os.path.join(above, "package.xml")):
            return above
        above = os.path.dirname(above)
    return parent


def core_folder(root=None):
    """Where a wheel for the Python that runs is unpacked to."""
    return os.path.join(root or module_root(), "core", tag())


def version():
    """Of the Python files."""
    from patchmill._version import __version__

    return __version__


def why_absent():
    """'' if the core is loaded, else the sentence why not, without a full stop."""
    core = sys.modules.get(NAME)
    return core.reason if isinstance(core, StandIn) else ""


def load():
    """Imports the core, or puts the stand-in in its place; returns what `why_absent` does. Never raises."""
    if NAME not in sys.modules:
        folder = core_folder()
        if os.path.isdir(folder):
            reason = _try(lambda: _from_wheel(folder), folder)
        else:
            reason = _try(lambda: importlib.import_module(NAME), None)
        if reason:
            sys.modules[NAME] = StandIn(reason)
    return why_absent()


def reload():
    """Tries again, after something was installed. Modules that hold the stand-in keep it: FreeCAD is to be
    started again. Returns the sentence, '' if the core can now be loaded."""
    if why_absent():
        del sys.modules[NAME]
        importlib.invalidate_caches()
    return load()


def _try(bring, folder):
    try:
        core = bring()
    except ImportError as error:
        sys.modules.pop(NAME, None)
        return _why(str(error), folder)
    has = getattr(core, "__version__", "")
    if has != version():
        sys.modules.pop(NAME, None)
        older = "is of version %s" % has if has else "is of an older version"
        return "the compiled core %s, and PatchMill is %s" % (older, version())
    return ""


def _from_wheel(folder):
    """The core that was unpacked there. Not with RTLD_DEEPBIND: std::cout would be another than the
    program's."""
    found = _compiled_files([folder])
    matching = [f for f in found if _for_this_python(f)]
    if not matching:
        raise ModuleNotFoundError("No module named '%s'" % NAME)
    spec = importlib.util.spec_from_file_location(NAME, matching[0])
    core = importlib.util.module_from_spec(spec)
    sys.modules[NAME] = core  # the core's own errors are found by this name
    spec.loader.exec_module(core)
    return core


def _compiled_files(folders):
    names = [glob.glob(os.path.join(glob.escape(folder), NAME + ".*")) for folder in folders]
    return sorted(f for some in names for f in some if f.endswith((".so", ".pyd")))


def _for_this_python(file):
    return os.path.basename(file)[len(NAME) :] in importlib.machinery.EXTENSION_SUFFIXES


def _why(message, folder):
    """What an ImportError of the core comes from, in the words of whoever has installed it."""
    root = module_root()
    found = _compiled_files([folder] if folder else [root, *sys.path])
    mine = [f for f in found if _for_this_python(f)]
    if not found and folder is None:
        found = _compiled_files(glob.glob(os.path.join(glob.escape(root), "core", "*")))
    python = "%d.%d" % sys.version_info[:2]
    if not mine:
        others = sorted({p for p in map(_python_of, found) if p})
        if others:
            built = "for Python %s" % " and ".join(others)
            return "the compiled core is built %s, and this FreeCAD has Python %s" % (built, python)
        return "the compiled core for Python %s is not installed" % python
    library = re.match(r"(\S+): cannot open shared object file", message)
    if library and "-patchmill-" in library.group(1):  # a wheel's own: packaging/wheel/pack.py
        return "the compiled core is not whole: its %s is missing" % library.group(1)
    if library and library.group(1).startswith("libTK"):
        what = "another OpenCASCADE than is installed"
        return "the compiled core needs %s: %s is missing" % (what, library.group(1))
    if library:
        return "the compiled core needs the library %s, which is missing" % library.group(1)
    newer = re.search(r"version [`'](GLIBC(?:XX)?_[0-9.]+)' not found", message)
    if newer:
        return "the compiled core needs a newer system than this: %s is missing" % newer.group(1)
    said = message.splitlines()[0] if message else "no reason"
    return "the compiled core %s is broken (%s)" % (mine[0], said)


def _python_of(file):
    match = re.search(r"\.cpython-(\d)(\d+)|\.cp(\d)(\d+)", os.path.basename(file))
    return match and "%s.%s" % tuple(g for g in match.groups() if g is not None)

# PatchMill: runs when FreeCAD starts, with and without a GUI. Imports nothing heavy; __file__ is undefined
# here.
# SPDX-License-Identifier: LGPL-2.1-or-later
def _find_packages():
    """A clone of the repository keeps the packages in folders of their own; built or installed, they are
    beside this file. FreeCAD puts the folder of an add-on in sys.path before it runs its Init.py."""
    import os
    import sys

    for root in list(sys.path):
        if os.path.isfile(os.path.join(root, "src", "patchmill", "install", "core_loader.py")):
            # core/cp313 for Python 3.13: what was unpacked of a wheel (patchmill.install.core_loader)
            core = ("core", "cp%d%d" % sys.version_info[:2])
            sys.path += [os.path.join(root, *p) for p in (("src",), ("Gui",), ("src", "posts"), core)]


class _OldDocuments:
    """Finds the modules that documents of FreeCAD 0.20 name, where FreeCAD itself does not. Imports nothing
    before such a document is opened."""

    @staticmethod
    def find_spec(name, path=None, target=None):
        if not name.startswith("PathScripts.Path"):
            return None
        from patchmill.freecad.old_documents import FINDER

        return FINDER.find_spec(name, path, target)


_find_packages()
FreeCAD.__unit_test__ += ["TestPatchMill"]  # noqa: F821  FreeCAD gives it
__import__("sys").meta_path.append(_OldDocuments)

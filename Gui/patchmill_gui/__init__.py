"""PatchMill's GUI: commands, task panels, view providers and display. Imported only when FreeCAD has a GUI;
what it shows and does is computed by `patchmill`, which works without it.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from patchmill_gui import old_names

old_names.FINDER.install()
__getattr__ = old_names.FINDER.attribute

# PatchMill: runs when FreeCAD starts, with and without a GUI. Imports nothing heavy.
# SPDX-License-Identifier: LGPL-2.1-or-later

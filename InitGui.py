# PatchMill's workbench. Runs when FreeCAD starts with a GUI; __file__ is undefined here.
# SPDX-License-Identifier: LGPL-2.1-or-later

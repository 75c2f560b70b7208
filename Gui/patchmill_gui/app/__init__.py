"""What FreeCAD shows of PatchMill outside its panels: workbench, commands, examples, views of objects.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

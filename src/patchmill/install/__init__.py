"""How PatchMill is installed: its compiled core found and loaded, what is missing said in one sentence, and
put right. Knows nothing of textures, and needs neither the core nor FreeCAD's Path module.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

"""Batches of parts: recipes, one process a part, and an index over all of them. No FreeCAD here: the
processes that are started have it.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

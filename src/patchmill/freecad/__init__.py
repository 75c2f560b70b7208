"""What knows FreeCAD: its versions, hooks, preferences, translation, tool controllers, links, posts.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

"""What is drawn in the 3-D view: textures, paths, the tool, legends.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

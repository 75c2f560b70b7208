"""Figures and reports: of the marks of a texture, of reliefs, of dynamic contour milling.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

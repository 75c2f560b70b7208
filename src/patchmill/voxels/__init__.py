"""Voxel models of removal and of tool axes: materials, fields, slices.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

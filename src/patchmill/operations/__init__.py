"""The document objects that make paths: textures, calibration patch, copy milling, and a job for them.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

"""Areal surface texture parameters after ISO 25178-2, and the filters before them. docs/areal-parameters.md.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

"""Balls and domes: lattices that are made for spheres, instead of ones that are projected or laid on them.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

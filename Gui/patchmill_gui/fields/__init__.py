"""Editors of numbers: quantities with the user's units, plain numbers with either decimal sign.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

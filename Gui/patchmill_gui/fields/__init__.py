"""Editors of numbers: quantities with the user's units, plain numbers with either decimal sign; and what
windows share that is no widget.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

"""Height maps: reliefs written for others' programs, and measured surfaces read. docs/height-maps.md.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

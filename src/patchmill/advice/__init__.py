"""What a texture will come out as, which values suit it, and what helps where they cannot.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

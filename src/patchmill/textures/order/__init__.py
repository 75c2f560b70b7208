"""The order in which a texture's dimples are milled.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

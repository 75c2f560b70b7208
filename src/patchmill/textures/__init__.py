"""Textures without a document: input, division, plan, masks, free forms, strategies, postures, advice.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

"""Gouge and collision of a path with the tool that it has: the check without a document.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

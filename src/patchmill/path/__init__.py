"""Paths of other operations: read from the document, and with the tool tilted by A and C.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

"""The document properties of operations, and what a recompute writes into them.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

"""The document objects that change the path of another operation: dynamic contour milling.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

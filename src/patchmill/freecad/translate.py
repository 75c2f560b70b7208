"""Marks texts for translation. The core package must not import Qt, so the marker is our own; Qt's
lupdate finds it by its name.

SPDX-License-Identifier: LGPL-2.1-or-later
"""


def QT_TRANSLATE_NOOP(context, text):
    """`text`, marked for translation in `context`."""
    return text

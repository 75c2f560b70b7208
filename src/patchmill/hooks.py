"""Who wants to know of document objects that PatchMill makes: the GUI, which gives them view providers, also
when a macro made them. Headless nobody listens.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

CREATED = []  # functions of (document object)


def announce(obj):
    """Calls every listener with a document object that was just made; returns the object."""
    for listener in CREATED:
        listener(obj)
    return obj

"""Who wants to know of document objects that PatchMill makes, or that are opened: the GUI, which gives them
view providers, also when a macro made them. Headless nobody listens.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import typing

Listener = typing.Callable[[typing.Any], None]  # of a document object

CREATED: typing.List[Listener] = []
RESTORED: typing.List[Listener] = []


def announce(obj):
    """Calls every listener with a document object that was just made; returns the object."""
    for listener in CREATED:
        listener(obj)
    return obj


def announce_restored(obj):
    """Calls every listener with a document object of a file that is being opened."""
    for listener in RESTORED:
        listener(obj)

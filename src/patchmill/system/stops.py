"""Functions with a progress that stop wherever they are when it says so, not only where they tell it.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import functools
import inspect

import _patchmill as core


def stoppable(function):
    """A function with a parameter `progress` (share -> bool, or None) as one in which all long calls of the
    core, and functions of this package, ask too, at least each 100 ms; it is given one that can be called.
    What it returns is None if `progress` returned False in one of them. Where it is given none, the one of
    the stoppable function around it is asked, and that ends."""
    signature = inspect.signature(function)

    @functools.wraps(function)
    def run(*arguments, **named):
        bound = signature.bind(*arguments, **named)
        result = None
        with core.Watch(bound.arguments.get("progress")) as progress:
            bound.arguments["progress"] = progress
            result = function(*bound.args, **bound.kwargs)
        return result

    return run


def to_its_end(function):
    """A function that a stop from around it does not end: FreeCAD calls it, and would take that for a fault.
    What is around it ends after it."""

    @functools.wraps(function)
    def run(*arguments, **named):
        with core.Watch(lambda share: True):
            return function(*arguments, **named)

    return run

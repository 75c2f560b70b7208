"""Functions with a progress that stop wherever they are when it says so, not only where they tell it.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import functools
import inspect

import _patchmill as core


def stoppable(function):
    """A function with a parameter `progress` (share -> bool, or None) as one that all long calls of the core
    within ask too, at least each 100 ms; it is given one that can be called. What it returns is None if
    `progress` returned False in one of them."""
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

"""What the mesher says of a deflection, told of the value that it was taken from.

    with told_of("Tolerance", 0.25):
        part = core.solid_of_brep(brep, 0.25 * tolerance, "Model")

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import contextlib
import re

from _patchmill import InputError

LENGTH = re.compile(r"([\d.]+(?:e[+-]?\d+)?) mm")


@contextlib.contextmanager
def told_of(name, share):
    """Errors about the deflection, a `share` of what is called `name`, name that, with its lengths."""
    try:
        yield
    except InputError as error:
        if error.property != "Deflection":
            raise
        value, remedy = (
            LENGTH.sub(lambda found: "%.3g mm" % (float(found.group(1)) / share), text)
            for text in (error.value, error.remedy)
        )
        raise InputError(name, value, remedy) from None

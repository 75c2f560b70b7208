"""The values of one click for an operation in a document, without a window.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import patchmill
from _patchmill import InputError

from patchmill.advice import apply, assessment, choice


def take_for(operation):
    """Gives a texture operation the values that suit it, as a new one gets them in the GUI. Returns the
    choice.Choice; None, and nothing is changed, where the texture cannot be made whatever they are:
    patchmill.recompute says why."""
    assess = assessment.with_simulation(patchmill.simulate)
    free = apply.controller_is_free(operation)
    try:
        found = choice.choose(assess, operation.Proxy.texture_input(operation), free)
    except InputError:
        return None
    if found is not None:
        apply.set_fields(operation, found.fields)
    return found

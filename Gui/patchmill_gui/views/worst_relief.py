"""The relief of a texture's worst place: of the patches that are simulated to find out how good it is.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from _patchmill import InputError
from patchmill.advice import assessment
from patchmill.verify.simulation import simulate

from patchmill_gui.views.texture_scene import relief_of

PATCHES = 3  # besides that of the flattest place


class _Worst:
    """patchmill.simulate that keeps the worst of what it made."""

    def __init__(self):
        self.result = None

    def __call__(self, plan, **options):
        made = simulate(plan, **options)
        if self.result is None or made.quality < self.result.quality:
            self.result = made
        return made


def assess_and_draw(given, progress, whole=True):
    """(Assessment, displays of the relief of the worst place) of a TextureInput, or None if `progress`
    (share -> bool) returned False; for any thread. `whole`: as patchmill.advice.assessment takes it. Raises
    InputError where no dimple can be placed."""
    worst = _Worst()
    found = assessment.assess(worst, given, PATCHES, progress, whole=whole)
    if found is None:
        return None
    return found, relief_of(worst.result)[0] if worst.result is not None else {}


def relief_displays(given, progress):
    """Displays of the relief alone; none where it was cancelled or there is nothing to simulate."""
    try:
        made = assess_and_draw(given, progress, whole=False)
    except InputError:
        return {}
    return made[1] if made else {}

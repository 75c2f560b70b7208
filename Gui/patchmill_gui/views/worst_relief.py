"""The relief of a texture's worst place: of the patches that are simulated to find out how good it is. They
take a while; the patch at the flattest place, which mostly is the worst, is there at once.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from _patchmill import InputError
from patchmill.advice import assessment, cells
from patchmill.textures.plan import place_texture
from patchmill.verify.simulation import simulate

from patchmill_gui.views.texture_scene import relief_of

PATCHES = 3  # besides that of the flattest place


once = cells.Once(simulate)  # what helps is looked for beside what the relief was drawn of


class _Worst:
    """patchmill.simulate that keeps the worst of what it made."""

    def __init__(self):
        self.result = None

    def __call__(self, plan, **options):
        made = once.afresh(plan, **options)
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


def first_relief(given, progress, placed=None):
    """Displays of the relief of a TextureInput's flattest place; none where it was cancelled or there is
    nothing to simulate. `placed`: its PlacedTexture, if there is one."""
    try:
        placed = placed or place_texture(given, progress)
        made = placed and assessment.first_patch(simulate, given, placed, progress)
    except InputError:
        return {}
    return relief_of(made)[0] if made else {}


def relief_displays(given, progress):
    """Displays of the relief of the worst place; none where it was cancelled or there is nothing to
    simulate."""
    try:
        made = assess_and_draw(given, progress, whole=False)
    except InputError:
        return {}
    return made[1] if made else {}

"""What a DCM modifier shows in colours: a slice of its voxels, and the cutting load along its path.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import _patchmill as core
import numpy as np
from patchmill.freecad.translate import QT_TRANSLATE_NOOP
from patchmill.voxels import voxel_slices

from patchmill_gui.forms.widgets import translate, user_unit

# title, factor on the value, digits
LOADS = {
    "force": (QT_TRANSLATE_NOOP("PatchMill", "force [N]"), 1.0, 0),
    "power": (QT_TRANSLATE_NOOP("PatchMill", "power [W]"), 1.0, 0),
    "chip": (QT_TRANSLATE_NOOP("PatchMill", "chip thickness [µm]"), 1000.0, 1),
}


def load_text(load):
    """What a panel says of a cutting_load.LoadAlong."""
    text = translate("PatchMill", "Largest force {} N ({} times the median), power {} W, chips {} µm thick")
    spread = "%.1f" % load.spread("force")
    force, power, chip = load.force.max(), load.power.max(), 1000.0 * load.chip.max()
    return text.format("%.0f" % force, spread, "%.0f" % power, "%.1f" % chip)


def load_on_path(what, load, pitch):
    """(arguments of LegendPlace.show, display) of coloured squares, as seen from above, wherever something is
    cut. `what`: a key of LOADS."""
    title, factor, digits = LOADS[what]
    cuts = load.force > 0.0
    values = factor * getattr(load, what)[cuts]
    high = max(values, default=1.0)
    display = core.slice_display(load.places[cuts], list(values), 0.5 * pitch, 2, 0.0, high)
    return (translate("PatchMill", title), 0.0, high, digits), display


def slice_of(what, model, feed, limits, axis, place):
    """(arguments of LegendPlace.show, (centres, values)) of a slice."""
    if what == "feed":
        centres, values = voxel_slices.feed_slice(model, feed, axis, place)
        unit, factor = user_unit("mm/s")
        low, high = factor * limits[0] * min(model.factors), factor * limits[1] * max(model.factors)
        digits = 0 if high >= 50.0 else 2
        return (translate("PatchMill", "feed [{}]").format(unit), low, high, digits), (
            centres,
            factor * values,
        )
    if what == "tilt":
        return (translate("PatchMill", "tilt [°]"), 0.0, 90.0), voxel_slices.tilt_slice(model, axis, place)
    if what == "distance":
        centres, values = voxel_slices.distance_slice(model, axis, place)
        unit, factor = user_unit("mm")
        title = translate("PatchMill", "distance [{}]").format(unit)
        return (title, 0.0, factor * max(values, default=1.0), 2), (centres, factor * np.asarray(values))
    names = ", ".join("%d %s" % pair for pair in enumerate(model.material_names))
    last = max(1, len(model.material_names) - 1)
    return (names, 0.0, last, 0, last + 1), voxel_slices.material_slice(model, axis, place)

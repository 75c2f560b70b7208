"""Dales of a measured surface after ISO 25178-2: watershed segmentation and Wolf pruning, and what they come
to.

    found = dales(filters.smoothed(surface, 0.05))
    print(found.parameters())

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass

import _patchmill as core
import numpy as np
from _patchmill import InputError

PRUNED = 0.05  # of Sz: ISO 25178-3 has dales that are shallower as part of their neighbours
FIVE = 5


@dataclass
class Dales:
    """One entry for each dale. Lengths in mm, in the height map's frame.

    `pits` (n, 2): places of the lowest points; `bottoms`: their heights; `depths` from there to the lowest
    saddle; `closed_areas` [mm²] and `volumes` [mm³] below that saddle's height; `open`: whether that part
    meets the border, so that it is a piece of a dale. `area` [mm²]: of the known surface; `mean`: its mean
    height."""

    pits: np.ndarray
    bottoms: np.ndarray
    depths: np.ndarray
    closed_areas: np.ndarray
    volumes: np.ndarray
    open: np.ndarray
    area: float
    mean: float

    def parameters(self):
        """{symbol: value}: Svd [1/mm²] density of pits; Sda [mm²] and Sdv [mm³] mean closed area and volume
        of a dale; S5v [mm] depth of the five deepest pits below the mean; and `depth` [mm] mean depth below
        the lowest saddle, `share` of the surface that lies in closed dales, `volume` [mm³/mm²] that they
        hold. Means are of dales that do not meet the border, nan if there is none; counts are of all."""
        whole = ~self.open & np.isfinite(self.depths)
        deepest = np.sort(self.bottoms)[:FIVE]

        def mean(values):
            return float(values[whole].mean()) if whole.any() else math.nan

        return {
            "Svd": len(self.depths) / self.area,
            "Sda": mean(self.closed_areas),
            "Sdv": mean(self.volumes),
            "S5v": float(self.mean - deepest.mean()),
            "depth": mean(self.depths),
            "share": float(self.closed_areas[np.isfinite(self.depths)].sum() / self.area),
            "volume": float(self.volumes.sum() / self.area),
        }


def dales(surface, pruned=PRUNED):
    """Dales of a HeightMap whose form is taken away and whose noise is smoothed (patchmill.areal.filters).
    `pruned`: share of Sz below which a dale is part of its neighbour (Wolf pruning). Holes are filled from
    their rims, and belong to the dale that they lie in. Raises InputError naming Heights or Pruning."""
    if not (math.isfinite(pruned) and 0.0 <= pruned < 1.0):
        raise InputError("Pruning", "%g" % pruned, "give a share of Sz, 0.05 for 5 %.")
    known = surface.heights[surface.known]
    if not len(known):
        raise InputError("Heights", "none is known", "give a surface with measured points.")
    least = float(known.min())
    heights = (surface.filled() - least).astype(np.float32)  # from the lowest point: 24 bits are enough then
    told = core.dales(heights, surface.step, pruned * float(np.ptp(known)))
    rows, columns = np.divmod(told["pits"], surface.shape[1])
    each = surface.step[0] * surface.step[1]
    return Dales(
        np.column_stack([surface.x()[columns], surface.y()[rows]]),
        told["bottoms"] + least,
        told["depths"],
        told["closed_areas"],
        told["volumes"],
        told["at_edge"],
        surface.heights.size * each,
        float(known.mean()),
    )

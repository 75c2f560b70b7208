"""What simulating a texture's cutter marks gives: the relief, the dimples found in it, and the table that
compares them with the plan.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
import os
from dataclasses import dataclass

import _patchmill as core

from patchmill.surface import dimple_table, files
from patchmill.surface.height_map import HeightMap
from patchmill.textures.plan import PlannedTexture


@dataclass
class SimulatedTexture:
    """The relief of a texture, or of a window of it. Lengths in mm; places in plane coordinates.

    `found` holds arrays, one entry per dimple found in the window: places (n, 2), points (n, 3) in the
    work frame, bottoms, depths, diameters, at_edge; per planned dimple `dimple` (its number), `found`
    (index of its mark, -1: missing), `moved` (m, 2); `extra`: indices of marks that nobody planned."""

    plan: PlannedTexture
    marks: core.TextureMarks
    window: tuple  # (low, high)
    found: dict
    alignment: dict
    source: str  # where the motion comes from, a phrase
    base: object = None  # what heights are measured from: FaceSampler, Dimples, or None for the plane
    reach: float = 1.0
    untimed_moves: int = 0

    @property
    def heights(self):
        """Deviation from the base along its normal [mm], float32 (rows, columns); NaN: no base there."""
        return self.marks.heights

    @property
    def step(self):
        """Distance of cells [mm]."""
        return self.marks.step

    @property
    def origin(self):
        """Plane coordinates of cell [0, 0] [mm]."""
        return tuple(float(c) for c in self.marks.first)

    @property
    def quality(self):
        """1 for a texture as planned, 0 if no mark is nearer to its place than a quarter spacing."""
        return self.found["quality"]

    def surface(self, stride=1, rows=None, columns=None):
        """Points of the relief for a mesh: (points (r, c, 3) [mm] in the work frame, heights (r, c) [mm]).

        Every `stride`-th cell of rows[0] <= row < rows[1] and of the columns alike; all if None. Points are
        NaN where there is no base. Take large reliefs in blocks: a block is computed when it is asked for."""
        r, c = self.heights.shape
        r0, r1 = rows or (0, r)
        c0, c1 = columns or (0, c)
        return self.marks.surface(self.base, self.reach, r0, r1 - r0, c0, c1 - c0, stride)

    def height_map(self):
        """The HeightMap of the deviations from the base, over the texture plane."""
        return HeightMap(self.heights, self.step, self.origin, "Texture cut by %s" % self.source)

    def save(self, filename):
        """Writes the relief; the name's ending says the format (patchmill.surface.files): deviations from the
        base as .gsf, .sdf, .x3p, .tif, .exr, .csv, .vti; the surface itself, in the work frame, as .stl or
        .ply; the dimple table as .dimples.csv. Raises InputError naming filename or Surface."""
        if os.fspath(filename).lower().endswith(".dimples.csv"):
            dimple_table.save(filename, self)
            return
        files.save(filename, self.height_map(), _Relief(self))

    def dimple_table(self):
        """(names, rows) of the dimples, planned and found, and of the marks that nobody planned. A dimple
        that was not cut says why; of one that was not simulated or found only what is planned is there.
        Lengths in mm, volumes in mm³ of a cap of that depth and diameter."""
        return dimple_table.COLUMNS, list(dimple_table.rows(self))

    def save_dimples(self, filename):
        """Writes the dimple table as CSV, names in the first line. Raises InputError naming filename."""
        dimple_table.save(filename, self)

    def data(self):
        """The figures as a dict of plain values: lengths in mm, shares 0 to 1."""
        f = self.found
        planned, missing = len(f["dimple"]), int(f["missing"])
        inner = ~f["at_edge"]
        return {
            "source": self.source,
            "grid_mm": self.step,
            "window_mm": [[float(v) for v in corner] for corner in self.window],
            "planned": planned,
            "found": planned - missing,
            "missing": missing,
            "extra": len(f["extra"]),
            "place_rms_mm": _number(f["rms_move"]),
            "place_rms_share": _number(f["rms_move"] / self.plan.input.spacing),
            "place_largest_mm": _number(f["largest_move"]),
            "mean_move_mm": [float(v) for v in f["mean_move"]],
            "depth_mm": _number(f["mean_depth"]),
            "depth_deviation_mm": _number(f["depth_deviation"]),
            "diameter_mm": _number(f["diameters"][inner].mean()) if inner.any() else None,
            "spacing_mm": _number(f["mean_spacing"]),
            "alignment": self.alignment["state"],
            "shift": self.alignment["shift"],
            "quality": float(self.quality),
        }

    def rows(self):
        """The table: pairs of a name and what is to be said of it."""
        d = self.data()
        per_cent = lambda share: "-" if share is None else "%.1f %%" % (100.0 * share)  # noqa: E731
        yield "Motion", d["source"]
        yield "Dimples planned", "{:,}".format(d["planned"])
        yield "found", "{:,}, missing {:,}".format(d["found"], d["missing"])
        yield "marks that nobody planned", "{:,}".format(d["extra"])
        yield (
            "off their places, rms",
            "%s (%s of the spacing); at most %s"
            % (_um(d["place_rms_mm"]), per_cent(d["place_rms_share"]), _um(d["place_largest_mm"])),
        )
        yield "depth to the rim", "%s ± %s" % (_um(d["depth_mm"]), _um(d["depth_deviation_mm"]))
        yield "diameter, mean", _mm(d["diameter_mm"])
        yield "distance to the nearest, mean", _mm(d["spacing_mm"])
        yield "array", d["alignment"]
        yield "quality, 0 to 1", "%.3f" % d["quality"]

    def text(self):
        """The table as text."""
        return "\n".join("%-32s %s" % row for row in self.rows())


class _Relief:
    """The surface itself, for patchmill.surface.meshes."""

    def __init__(self, simulated):
        self.simulated, self.shape = simulated, simulated.heights.shape

    def points(self, first, end):
        return self.simulated.surface(rows=(first, end))[0]


def _number(value):
    return None if value is None or not math.isfinite(value) else float(value)


def _um(value):
    return "-" if value is None else "%.1f µm" % (1000.0 * value)


def _mm(value):
    return "-" if value is None else "%.3f mm" % value

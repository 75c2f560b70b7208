"""Slices and arrows of a removal volume's fields as plain arrays: what a display or a plot takes.

    centres, values = feed_slice(model, feed, axis=1, place=24.0)

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import _patchmill as core
import numpy as np


def slice_range(model, axis):
    """Least and greatest place [mm] of a slice at right angles to axis 0, 1 or 2 of a RemovalModel."""
    low, high = model.stock.bounds
    half = 0.5 * model.grid.pitch
    return low[axis] + half, high[axis] - half


def feed_slice(model, feed, axis, place, direction=(1.0, 0.0, 0.0)):
    """(centres (n, 3) [mm], feed (n,) [mm/s] in a direction) of the voxels of one layer."""
    section = model.grid.section(axis, place, feed=feed, direction=direction)
    return _scattered(section, axis, section["feed"])


def tilt_slice(model, axis, place):
    """(centres (n, 3) [mm], angle of the posture to Z (n,) [degrees]) of the voxels of one layer."""
    section = model.grid.section(axis, place, posture=model.posture)
    return _scattered(section, axis, tilt_of(section["axis"]))


def distance_slice(model, axis, place):
    """(centres (n, 3) [mm], distance to the product (n,) [mm]) of the voxels of one layer."""
    centres = _filled(model, axis, place)
    return centres, np.abs(model.part.signed_distances(centres))


def material_slice(model, axis, place):
    """(centres (n, 3) [mm], number of the material (n,), by model.material_names) of one layer."""
    centres = _filled(model, axis, place)
    return centres, model.attributes_at(centres)["material"].astype(float)


def is_filled(kinds):
    """Whether voxels of an array of VoxelKinds are to be removed, or hold product surface."""
    return ~np.isin(kinds, (core.VoxelKind.AIR, core.VoxelKind.PART))


def _filled(model, axis, place):
    """Centres of the voxels of one layer that are to be removed, or hold product surface."""
    section = model.grid.section(axis, place)
    return _scattered(section, axis, np.where(is_filled(section["kind"]), 1.0, np.nan))[0]


def tilt_of(axes):
    """Angle of unit axes (..., 3) to Z [degrees]; NaN stays NaN."""
    return np.degrees(np.arccos(np.clip(axes[..., 2], -1.0, 1.0)))


def _scattered(section, axis, values):
    """The cells with a value, with their centres."""
    across, up = [k for k in range(3) if k != axis]
    row, column = np.nonzero(np.isfinite(values))
    centres = np.empty((len(row), 3))
    centres[:, axis] = section["place"]
    centres[:, across] = section["origin"][0] + (column + 0.5) * section["pitch"]
    centres[:, up] = section["origin"][1] + (row + 0.5) * section["pitch"]
    return centres, values[row, column]

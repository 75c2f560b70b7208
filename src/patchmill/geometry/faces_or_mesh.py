"""What a TextureInput lies on: faces of a B-rep, or a mesh. The one place that tells them apart; what only
faces can do is refused here by name.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from math import radians

import _patchmill as core
from _patchmill import InputError


def sampler(given, plane):
    """The _patchmill.ProjectedSurface of a TextureInput, seen from a _patchmill.TexturePlane. Raises
    InputError naming Base or SteepestSlope."""
    steepest = radians(given.steepest_slope)
    if given.mesh is not None:
        return core.MeshSampler(given.mesh, plane, steepest)
    return core.FaceSampler(given.breps, plane, steepest)


def seen_best(given):
    """(the direction along which it looks largest, whether it looks to all sides alike, so that this was
    chosen). Raises InputError naming Direction or Base."""
    if given.mesh is not None:
        return given.mesh.seen_best(given.direction)
    found = core.seen_best(given.breps, given.direction)
    return found["direction"], found["even"]


def keep_off_border(given, dimples):
    """Leaves out dimples nearer than the margin to the border of the faces together, or of the mesh's region.
    Raises InputError naming Margin or Base."""
    if given.mesh is not None:
        given.mesh.keep_off_border(dimples, given.margin)
    else:
        core.keep_off_borders(dimples, given.breps, given.margin)


def require_possible(given):
    """Raises InputError naming what a TextureInput on a mesh asks for that only faces have."""
    if given.mesh is None:
        return
    if given.breps:
        raise InputError("Mesh", "beside %d faces" % len(given.breps), "give a mesh or faces, not both.")
    if given.order == "Thread":
        remedy = "a mesh has no cylinder to be turned about: choose Helix or Rows."
        raise InputError("Order", "Thread", remedy)
    if given.form == "Lattice" and given.mapping != "Projected":
        remedy = "a mesh has no face to lay a lattice on by its own lines: choose Projected."
        raise InputError("Mapping", given.mapping, remedy)

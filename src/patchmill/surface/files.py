"""Height maps and reliefs written to files and read from them; the name's ending says the format.

    surface.files.save("relief.x3p", simulated.height_map())
    measured = surface.files.load("measured.sdf")

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os

from _patchmill import InputError

from patchmill.surface import exr, gsf, meshes, scans, sdf, text_grid, tiff, x3p
from patchmill.system import files

GRIDS = {
    ".gsf": gsf.write, ".sdf": sdf.write, ".x3p": x3p.write, ".tif": tiff.write, ".tiff": tiff.write,
    ".exr": exr.write, ".csv": text_grid.write, ".vti": meshes.write_vti,
}  # fmt: skip
MESHES = {".stl": meshes.write_stl, ".ply": meshes.write_ply}
READERS = {
    ".gsf": lambda content, step, grey: gsf.read(content),
    ".sdf": lambda content, step, grey: sdf.read(content),
    ".x3p": lambda content, step, grey: x3p.read(content),
    ".tif": lambda content, step, grey: tiff.read(content, step, grey),
    ".tiff": lambda content, step, grey: tiff.read(content, step, grey),
    ".exr": lambda content, step, grey: exr.read(content, step),
    ".csv": lambda content, step, grey: text_grid.read(content, step),
    ".stl": lambda content, step, grey: scans.read_stl(content, step),
    ".ply": lambda content, step, grey: scans.read_ply(content, step),
}
MOST_BYTES = 1 << 32


def save(filename, surface, relief=None):
    """Writes a HeightMap. `relief`: what a mesh is to show instead (patchmill.surface.meshes). Raises
    InputError naming Surface, or filename if it cannot be written."""
    ending = _ending(filename, {**GRIDS, **MESHES})
    with files.replacing(filename) as file:
        if ending in MESHES:
            MESHES[ending](file, relief if relief is not None else surface)
        else:
            GRIDS[ending](file, surface)


def load(filename, step=None, each_grey=None):
    """The HeightMap in a file. `step`: distance of points [mm] where the file does not say it, and of the
    grid that a mesh is laid on; `each_grey`: height of one grey value [mm] of others' TIFFs. Raises
    InputError naming Surface, GridStep, GreyHeight, or filename if it cannot be read."""
    ending = _ending(filename, READERS)
    content = files.read_bytes(filename, most=MOST_BYTES)
    return READERS[ending](content, step, each_grey)


def _ending(filename, formats):
    ending = os.path.splitext(os.fspath(filename))[1].lower()
    if ending not in formats:
        known = ", ".join(sorted(formats))
        raise InputError("filename", repr(str(filename)), "give a name that ends with %s." % known)
    return ending

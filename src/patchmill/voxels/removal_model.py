"""The voxel model of what is to be removed: made from a job's stock and model, kept in a file beside the
document, and made anew when an input has changed (Kobayashi & Shirase 2014; docs/dcm-fields.md).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import hashlib
import math
import os
import weakref
from dataclasses import dataclass

import _patchmill as core
import numpy as np
from _patchmill import InputError

from patchmill.geometry import shapes
from patchmill.system import files
from patchmill.voxels import materials
from patchmill.voxels.materials import OWN
from patchmill.voxels.voxel_slices import is_filled
from patchmill.system.stops import stoppable

MIB = 1024.0 * 1024.0
_in_use: weakref.WeakValueDictionary = weakref.WeakValueDictionary()


@dataclass
class ModelInput:
    """What the model is made from. mm, degrees, MiB; shapes as BREP texts."""

    stock: str
    part: str
    pitch: float
    deflection: float
    memory_limit: float
    posture: bool
    form: str = "Angles"
    exterior: str = "Held"
    tilt_limit: float = 70.0
    materials: tuple = ()  # of materials.Material: other than the stock's own

    @property
    def posture_fields(self):
        """Numbers of a posture that each voxel keeps."""
        return 0 if not self.posture else 3 if self.form == "Unit vector" else 2

    def key(self, stock, part, bodies):
        """Says whether a saved model is of the same input. The shapes count by their triangles to 1e-6 mm,
        since a reopened document does not give back the same BREP texts."""
        digest = hashlib.sha256()
        for solid in (stock, part, *bodies):
            digest.update((np.round(solid.vertices, 6) + 0.0).tobytes())
            digest.update(solid.triangles.tobytes())
        digest.update(repr((self.pitch, self.posture, [m.depth for m in self.materials])).encode())
        if self.posture:
            digest.update(repr((self.form, self.exterior, self.tilt_limit)).encode())
        return "patchmill 2 " + digest.hexdigest()


class RemovalModel:
    """`grid`, `posture` and `materials` of _patchmill, the last two None if not asked for; `stock` and `part`
    as _patchmill.Solid; `loaded`: from the file; `not_saved`: why it is not kept there, or ''."""

    not_saved = ""

    def __init__(self, given, grid, posture, materials, stock, part, loaded):
        self.given, self.grid, self.posture, self.materials = given, grid, posture, materials
        self.stock, self.part, self.loaded = stock, part, loaded
        self.files = set()  # that hold it

    def keep(self, file, key):
        """Writes it to `file`, unless it is there or `file` is ''. It only spares the next one the work, so
        that a folder that cannot be written is no error."""
        self.not_saved = ""
        if not file or file in self.files:
            return
        try:
            with files.replacing(file, "voxel file") as kept:
                name = kept.name if isinstance(kept.name, str) else "/proc/self/fd/%d" % kept.fileno()
                core.save_voxels(name, key, self.grid, self.posture, self.materials)
            self.files.add(file)
        except InputError as error:
            reason = "the voxel model is not kept, and made anew next time: %s could not be written."
            self.not_saved = reason % error.value

    @property
    def material_names(self):
        """Names by the numbers that attributes_at gives."""
        return [OWN] + [m.name for m in self.given.materials]

    @property
    def factors(self):
        """On the feed, by material."""
        return [1.0] + [m.factor for m in self.given.materials]

    def feed(self, low, high, transient=()):
        """The _patchmill.FeedField between V_Lo and V_Hi [mm/s], times the factor of each voxel's material:
        steady, or after a transient diffusion of (time [s], step [s], diffusivity [mm^2/s], whether steps may
        be divided)."""
        field = self._diffused(low, high, transient)
        if self.materials is None:
            return field
        return core.scale_feed(field, self.materials, self.factors)

    def _diffused(self, low, high, transient):
        if not transient:
            return core.steady_feed(self.grid, low, high, self.given.exterior)
        names = {"time step": "TimeStep", "diffusion time": "DiffusionTime"}
        names["diffusion coefficient"] = "Diffusivity"
        try:
            time, step, diffusivity, divided = transient
            exterior = self.given.exterior
            return core.diffuse_feed(self.grid, low, high, time, step, diffusivity, divided, exterior)[0]
        except InputError as error:
            raise InputError(names.get(error.property, error.property), error.value, error.remedy) from error

    def attributes_at(self, points, feed=None, direction=(1.0, 0.0, 0.0)):
        """What the model says at (n, 3) points [mm]: a dict of kind (a VoxelKind each), distance to the
        product [mm], negative inside it, and material (core.NO_MATERIAL: nothing to remove); feed [mm/s] in
        a direction if a FeedField is given; axis (n, 3) if there is a posture. The distance is measured to
        the part's triangles when asked for, so that no voxel has to keep it."""
        points = np.asarray(points, dtype=float).reshape(-1, 3)
        out = {
            "kind": core.kinds_at(self.grid, points),
            "distance": self.part.signed_distances(points),
            "material": self._materials_at(points),
        }
        if feed is not None:
            out["feed"] = core.feed_at(self.grid, feed, points, direction)
        if self.posture is not None:
            out["axis"] = core.axes_at(self.grid, self.posture, points)
        return out

    def _materials_at(self, points):
        if self.materials is None:
            filled = is_filled(core.kinds_at(self.grid, points))
            return np.where(filled, core.STOCK_MATERIAL, core.NO_MATERIAL)
        return core.materials_at(self.grid, self.materials, points)


@stoppable
def make(given, file="", progress=None):
    """The RemovalModel of a ModelInput: one that is in use, the one in `file`, or a new one, which is then
    written to `file` (if that is not ''). None if `progress` (share -> bool) returned False. Raises
    InputError naming Stock, Model, VoxelSize, MemoryLimit or Materials."""
    _check(given)
    part = _solid(given.part, given.deflection, "Model")
    stock = _solid(given.stock, given.deflection, "Stock")
    bodies = [_solid(m.solid, given.deflection, "Materials") for m in given.materials]
    key = given.key(stock, part, bodies)
    model = _in_use.get(key)
    if model is None:
        found = core.load_voxels(file, key) if file else None
        if found is not None:
            grid, posture, materials = found
            model = RemovalModel(given, grid, posture, materials, stock, part, True)
            model.files.add(file)
        else:
            model = _new(given, stock, part, bodies, progress)
            if model is None:
                return None
    elif model.given != given:  # the same voxels, but names, factors or the rule of the exterior differ
        kept = model.grid, model.posture, model.materials
        files, model = model.files, RemovalModel(given, *kept, stock, part, model.loaded)
        model.files = files
    model.keep(file, key)
    _in_use[key] = model
    return model


def estimate(given):
    """Bytes that the model of a ModelInput will take: dict with grid, fields, solver, total; nothing is
    allocated for it yet."""
    _check(given)
    part = _solid(given.part, given.deflection, "Model")
    stock = _solid(given.stock, given.deflection, "Stock")
    return core.estimate_voxels(stock, part, given.pitch, given.posture_fields, bool(given.materials))


def file_beside(document, name):
    """Where the model of the object `name` is kept; '' for a document that was never saved."""
    if not document.FileName:
        return ""
    return "%s-%s.voxels" % (os.path.splitext(document.FileName)[0], name)


def _check(given):
    if not (math.isfinite(given.pitch) and given.pitch > 0.0):
        raise InputError("VoxelSize", "%g mm" % given.pitch, "give a size greater than zero.")
    if not given.memory_limit > 0.0:
        raise InputError("MemoryLimit", "%g MiB" % given.memory_limit, "give more than zero.")


def _new(given, stock, part, bodies, progress):
    try:
        limit = given.memory_limit * MIB
        grid = core.voxelise(
            stock, part, given.pitch, limit, given.posture_fields, bool(given.materials)
        )
    except InputError as error:  # the core's own names are not the properties'
        names = {"voxel size": "VoxelSize", "part": "Model", "stock": "Stock", "removal volume": "Stock"}
        raise InputError(names.get(error.property, error.property), error.value, error.remedy) from error
    posture = None
    if given.posture:
        posture = core.steady_posture(
            grid, part, given.form, given.exterior, math.radians(given.tilt_limit), progress=progress
        )
        if posture.cancelled:
            return None
        if not posture.converged:
            raise InputError(
                "VoxelSize",
                "%g mm" % given.pitch,
                "the posture did not converge (residual %.1e): try another size." % posture.residual,
            )
    found = None
    if bodies:
        found = core.materials_of(grid, [(b, m.depth) for b, m in zip(bodies, given.materials)])
    return RemovalModel(given, grid, posture, found, stock, part, False)


def _solid(brep, deflection, name):
    return core.solid_of_brep(brep, deflection, name)


def input_of(obj, job, posture):
    """ModelInput of an object with the voxel properties of a DressupDCM. Raises InputError naming Stock,
    Model or Materials."""
    stock, part = job_shapes(job)
    return ModelInput(
        stock,
        part,
        obj.VoxelSize.Value,
        obj.Deflection.Value,
        obj.MemoryLimit,
        posture,
        obj.PostureForm,
        obj.Exterior,
        obj.TiltLimit.Value,
        materials.of_lines(obj.Materials, obj.Document, stock),
    )


def job_shapes(job):
    """(stock, part) of a job as BREP texts. Raises InputError naming Stock or Model."""
    stock = job.Stock and shapes.drawn(job.Stock)
    if stock is None:
        raise InputError("Stock", "none", "give the job a stock.")
    return stock.exportBrepToString(), _in_one(shapes.models(job)).exportBrepToString()


def _in_one(models):
    """One shape of several. Solids that meet, also in a compound, become one: what lies in two of them would
    count as outside."""
    import Part

    solids = [solid for shape in models for solid in shape.Solids]
    if len(solids) > 1 and sum(len(s.Faces) for s in solids) == sum(len(s.Faces) for s in models):
        boxes = [solid.BoundBox for solid in solids]
        if any(a.intersect(b) for i, a in enumerate(boxes) for b in boxes[:i]):
            return solids[0].multiFuse(solids[1:])
    return models[0] if len(models) == 1 else Part.makeCompound(models)

"""Shapes of document objects where FreeCAD draws them: with the placements of the bodies and parts that they
are in, which an object's own Shape does not have; through links; of meshes as solids.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import functools

import FreeCAD
import Part
from _patchmill import InputError

MESH_TOLERANCE = 1e-3  # mm, of corners that are one
KINDS = ("ballend", "bullnose", "chamfer", "dovetail", "drill", "endmill", "probe", "reamer", "slittingsaw")


def of_brep(text):
    """The Part.Shape of a BREP text."""
    shape = Part.Shape()
    shape.importBrepFromString(text)
    return shape


def drawn(obj):
    """The Part.Shape of a document object as it is drawn, or None if it has none."""
    own = getattr(obj, "Shape", None)
    shape = own if own is not None else Part.getShape(obj)
    if shape is None or shape.isNull():
        return None
    around = placement_around(obj)
    if around.isIdentity():
        return shape
    shape = shape.copy()
    shape.Placement = around.multiply(shape.Placement)
    return shape


def is_mesh(obj):
    """Whether `obj` is a document object that is one of FreeCAD's meshes."""
    return hasattr(obj, "isDerivedFrom") and obj.isDerivedFrom("Mesh::Feature")


def placement_around(obj):
    """Placement of the body or part that an object is in, of those that this is in, and so on."""
    placement, parent = FreeCAD.Placement(), obj.getParentGeoFeatureGroup()
    while parent is not None:
        placement = parent.Placement.multiply(placement)
        parent = parent.getParentGeoFeatureGroup()
    return placement


class _Key:
    """A Part.Shape to look up by: FreeCAD hands out the same one in new objects until it is recomputed."""

    def __init__(self, shape):
        self.shape = shape

    def __hash__(self):
        return self.shape.hashCode()

    def __eq__(self, other):
        return self.shape.isEqual(other.shape)


@functools.lru_cache(maxsize=16)
def _is_inside_out(solid):
    """Of the _Key of a solid: asked at every preview, and half a second's work for a thousand faces."""
    return solid.shape.Volume < 0.0


def models(job):
    """Shapes of the job's models that have faces: sketches and curves among them bound nothing. Raises
    InputError naming Model if there is none, or for a mesh that is no closed solid."""
    found = [_of_model(job, model) for model in job.Model.Group]
    found = [shape for shape in found if shape is not None and shape.Faces]
    if not found:
        raise InputError("Model", "none", "give the job a model.")
    return found


def _of_model(job, model):
    shape = drawn(model)
    mesh = getattr(model, "Mesh", None) or getattr(job.Proxy.baseObject(job, model), "Mesh", None)
    if shape is not None and any(_is_inside_out(_Key(solid)) for solid in shape.Solids):
        remedy = "it is inside out, its faces look into it: reverse the shape, or make the solid again."
        raise InputError("Model", model.Label, remedy)
    if shape is not None or mesh is None:
        return shape
    if not mesh.isSolid():
        remedy = "the mesh is not closed: repair it, or take it out of the job."
        raise InputError("Model", model.Label, remedy)
    shape = Part.Shape()
    mesh = mesh.copy()
    mesh.Placement = FreeCAD.Placement()
    shape.makeShapeFromMesh(mesh.Topology, MESH_TOLERANCE)
    shape = Part.makeSolid(shape)
    shape.Placement = model.Placement
    return shape


class BrepTexts:
    """BREP texts that are asked for again and again: FreeCAD hands out the same shape until it is recomputed,
    and writing that of a thousand faces takes as long as a hand notices."""

    def __init__(self):
        self._known = {}  # of the last call

    def of(self, groups, make=Part.Compound):
        """The text of each list of Part.Shapes in `groups`, of which `make` makes the shape that is written;
        one that was so the last time is not written again."""
        keys = [tuple(map(_Key, group)) for group in groups]
        known = self._known
        self._known = {k: known.get(k) or make([s.shape for s in k]).exportBrepToString() for k in keys}
        return [self._known[key] for key in keys]


def kind_of_bit(kind, bit):
    """What a tool bit is: FreeCAD's kinds by name; one with a shape file of its own is a ball end mill if it
    ends in a ball of its diameter."""
    radius = float(getattr(bit, "Diameter", 0.0)) / 2.0
    shape = getattr(bit, "Shape", None)
    if kind in KINDS or shape is None or shape.isNull() or not radius > 0.0:
        return kind
    balls = [face.Surface for face in shape.Faces if type(face.Surface).__name__ == "Sphere"]
    lowest = shape.BoundBox.ZMin
    near = 1e-3 * radius
    ends = any(abs(b.Radius - radius) < near and abs(b.Center.z - radius - lowest) < near for b in balls)
    return "ballend" if ends else kind


def model_of(job, base):
    """The job's model that `base`, an object named in Base, stands for: itself, or the one that
    was made from it and may have been moved. Raises InputError naming Base for what is not of the job."""
    if base in job.Model.Group:
        return base
    for model in job.Model.Group:
        original = job.Proxy.baseObject(job, model)
        if base is original or base is getattr(original, "Tip", None):
            return model
    names = ", ".join(model.Label for model in job.Model.Group)
    remedy = "it is not in the job %s: choose faces of %s." % (job.Label, names)
    raise InputError("Base", base.Label, remedy)

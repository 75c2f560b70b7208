"""What an operation is made from besides its own properties: the job's stock and model. FreeCAD's operations
do not depend on them, so that a part or stock that changes would leave an old path, with rapids through what
is now there; ours are linked to them, and are recomputed with them.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from _patchmill import InputError

from patchmill.freecad import host
from patchmill.freecad.translate import QT_TRANSLATE_NOOP
from patchmill.geometry import shapes

NAME = "MadeFrom"
HIDDEN = 2  # FreeCAD's editor mode
SORTS = {"Face": "Faces", "Edge": "Edges", "Vertex": "Vertexes"}  # of elements: the lists of a shape


def add(obj):
    """Adds the property that holds the links; not to the prototype of a setup sheet."""
    if not hasattr(obj, "TypeId"):
        return
    if not hasattr(obj, NAME):
        tip = QT_TRANSLATE_NOOP("App::Property", "Stock and model of the job: recomputed when they change")
        obj.addProperty("App::PropertyLinkListGlobal", NAME, "Base", tip)
    obj.setEditorMode(NAME, HIDDEN)


def follow(obj, job):
    """Links `obj` to the stock and the models that `job` has now, if there is one."""
    if job is None:
        return
    wanted = [o for o in [job.Stock, *job.Model.Group] if o is not None]
    if list(getattr(obj, NAME)) != wanted:
        setattr(obj, NAME, wanted)


def job_of(obj):
    """The job of an operation or dressup, which from now on follows its stock and model. Raises InputError
    naming Job, Stock or Model if something is missing there."""
    job = host.PathUtils.findParentJob(obj)
    if job is None:
        raise InputError("Job", obj.Label, "it belongs to no job: make it in one.")
    follow(obj, job)
    if job.Stock is None or shapes.drawn(job.Stock) is None:
        raise InputError("Stock", "none", "give the job a stock.")
    shapes.models(job)
    return job


def faces_of(base, names, remedy):
    """The faces of an object that are named in Base, in that order. Raises InputError naming Base: with
    `remedy` for what is no face, and for a face that the object has no more, whose name FreeCAD 1.1 marks
    with '?'. The shape is asked once: FreeCAD walks through all of it for each face that it looks up."""
    shape = shapes.drawn(base)
    faces = [] if shape is None else shape.Faces
    found = []
    for name in names:
        plain = name.lstrip("?")
        if not plain.startswith("Face"):
            raise InputError("Base", "%s of %s" % (plain, base.Label) if plain else base.Label, remedy)
        digits = plain[len("Face") :]
        number = int(digits) if digits.isdigit() else 0
        if name != plain or not 1 <= number <= len(faces):
            raise InputError("Base", "%s of %s" % (plain, base.Label), "it is gone: choose a face again.")
        found.append(faces[number - 1])
    return found


def first_gone(shape, names):
    """The first of the names of faces, edges and so on that the shape has no more; None if it has all. Asks
    the shape once for each sort, as faces_of does."""
    counts = {}
    for name in names:
        sort = name.rstrip("0123456789")
        if sort in SORTS and sort != name:
            if sort not in counts:
                counts[sort] = len(getattr(shape, SORTS[sort]))
            has = 1 <= int(name[len(sort) :]) <= counts[sort]
        else:
            has = not name or _has_element(shape, name)
        if not has:
            return name
    return None


def _has_element(shape, name):
    try:
        shape.getElement(name)
    except Exception:  # FreeCAD's versions raise errors of different kinds
        return False
    return True

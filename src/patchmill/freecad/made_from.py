"""What an operation is made from besides its own properties: the job's stock and model. FreeCAD's operations
do not depend on them, so that a part or stock that changes would leave an old path, with rapids through what
is now there; ours are linked to them, and are recomputed with them.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from _patchmill import InputError

from patchmill.freecad import host
from patchmill.freecad.translate import QT_TRANSLATE_NOOP

NAME = "MadeFrom"
HIDDEN = 2  # FreeCAD's editor mode


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
    if not _has_shape(job.Stock):
        raise InputError("Stock", "none", "give the job a stock.")
    if not any(_has_shape(model) for model in job.Model.Group):
        raise InputError("Model", "none", "give the job a model.")
    return job


def face_of(base, name, remedy):
    """The face `name` of an object that is named in Base. Raises InputError naming Base: with `remedy` for
    what is no face, and for a face that the object has no more, whose name FreeCAD 1.1 marks with '?'."""
    plain = name.lstrip("?")
    if not plain.startswith("Face"):
        raise InputError("Base", "%s of %s" % (plain, base.Label) if plain else base.Label, remedy)
    if name != plain or int(plain[len("Face") :]) > len(base.Shape.Faces):
        raise InputError("Base", "%s of %s" % (plain, base.Label), "it is gone: choose a face again.")
    return base.Shape.getElement(plain)


def _has_shape(thing):
    shape = getattr(thing, "Shape", None)
    return shape is not None and not shape.isNull()

"""Faces of a shape by what they are, so that a macro or a recipe needs no face numbers.

    patchmill.faces(shape, "largest free-form")
    patchmill.faces(shape, {"normal": [0, 0, 1], "within": 30})     # degrees
    patchmill.faces(shape, {"nearest": [0, 0, 12]})                 # mm
    patchmill.faces(shape, {"names": ["Face2", "Face3"]})
    patchmill.faces(part, {"colour": "#ff0000"})                    # a document object, or its clone in a job
    patchmill.faces(part, {"label": "Cover"})                       # what it shares with the object so called

Of equals the face with the lowest number is taken.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from typing import Any, Callable, Dict, List, Sequence

import FreeCAD
import Part
from _patchmill import InputError

from patchmill.macros import marks

ANALYTIC = ("Plane", "Cylinder", "Cone", "Sphere", "Toroid")
WORDS = ("all", "top", "largest", "largest free-form")


RULES = ("names", "normal", "nearest", "colour", "label")


def faces(part: Any, choice: Any) -> List[str]:
    """Names ("Face3") of the faces of a Part.Shape, or of a document object that has one, that `choice` says:
    one of WORDS, a face's name, a list of names, or a dict with one of the keys names, normal (with `within`
    in degrees, 15 if not given), nearest, colour and label; the last two need an object. Raises InputError
    naming Faces if the choice is none of these or there is no such face."""
    shape = getattr(part, "Shape", part)
    if not getattr(shape, "Faces", None):
        raise InputError("Faces", "a shape without faces", "give a solid or a surface.")
    if isinstance(choice, str):
        chosen = _by_word(shape, choice)
    elif isinstance(choice, dict):
        chosen = _by_rule(part, shape, choice)
    else:
        chosen = _by_names(shape, choice)
    if not chosen:
        raise InputError("Faces", choice, "no face of the part is so: choose others.")
    return chosen


def is_free_form(face: Any) -> bool:
    """Whether a face lies on no plane, cylinder, cone, sphere or torus."""
    return type(face.Surface).__name__ not in ANALYTIC


def _name(number: int) -> str:
    return "Face%d" % (number + 1)


def _by_word(shape: Any, word: str) -> List[str]:
    if word.startswith("Face"):
        return _by_names(shape, [word])
    if word not in WORDS:
        raise InputError("Faces", repr(word), "give a face's name or one of: %s." % ", ".join(WORDS))
    numbers = list(range(len(shape.Faces)))
    if word == "all":
        return [_name(k) for k in numbers]
    if word == "top":
        return _first(shape, numbers, _highest)
    if word == "largest free-form":
        numbers = [k for k in numbers if is_free_form(shape.Faces[k])]
    return _first(shape, numbers, lambda face: face.Area)


def _first(shape: Any, numbers: Sequence[int], size: Callable[[Any], float]) -> List[str]:
    """The face with the greatest `size`; of those that differ by rounding only, the first."""
    sizes = {k: size(shape.Faces[k]) for k in numbers}
    if not sizes:
        return []
    greatest = max(sizes.values())
    slack = 1e-9 * max(1.0, abs(greatest))
    return [_name(min(k for k, s in sizes.items() if s >= greatest - slack))]


def _highest(face: Any) -> float:
    """Height of the face's centre [mm] if it looks upwards there, else nothing that can win."""
    return face.CenterOfMass.z if _normal(face).z > 0.5 else -math.inf


def _normal(face: Any) -> Any:
    """Outward unit normal in the middle of a face, on the material that the face has there."""
    u0, u1, v0, v1 = face.ParameterRange
    normal = face.normalAt((u0 + u1) / 2.0, (v0 + v1) / 2.0)
    return normal.normalize() if normal.Length > 0.0 else normal


def _by_names(shape: Any, names: Any) -> List[str]:
    if not isinstance(names, (list, tuple)) or not all(isinstance(n, str) for n in names):
        raise InputError(
            "Faces", names, "give names of faces, as Face3, or one of: %s." % ", ".join(WORDS)
        )
    known = {_name(k) for k in range(len(shape.Faces))}
    for name in names:
        if name not in known:
            remedy = "the part has Face1 to Face%d." % len(shape.Faces)
            raise InputError("Faces", name, remedy)
    return list(names)


def _by_rule(part: Any, shape: Any, rule: Dict[str, Any]) -> List[str]:
    rule = {k: v for k, v in rule.items() if not k.startswith("//")}
    keys = set(rule) - {"within"}
    if keys == {"names"}:
        return _by_names(shape, rule["names"])
    if keys == {"normal"}:
        return _facing(shape, _vector(rule["normal"]), _angle(rule.get("within", 15.0)))
    if keys == {"nearest"}:
        return _nearest(shape, _vector(rule["nearest"]))
    if keys in ({"colour"}, {"label"}) and part is shape:
        raise InputError("Faces", rule, "a shape has none: give the object of the document.")
    if keys == {"colour"}:
        return [_name(k) for k in marks.with_colour(part, rule["colour"])]
    if keys == {"label"}:
        return [_name(k) for k in marks.with_label(part, str(rule["label"]))]
    raise InputError("Faces", rule, "give one of the keys %s." % ", ".join(RULES))


def _vector(value: Any) -> Any:
    try:
        vector = FreeCAD.Vector(*(float(v) for v in value))
    except (TypeError, ValueError) as error:
        raise InputError("Faces", value, "give three numbers.") from error
    if not all(math.isfinite(v) for v in vector):
        raise InputError("Faces", value, "give three finite numbers.")
    return vector


def _angle(value: Any) -> float:
    if not isinstance(value, (int, float)) or not 0.0 < value <= 180.0:
        raise InputError("Faces", value, "give `within` in degrees, over 0 and at most 180.")
    return math.radians(value)


def _facing(shape: Any, direction: Any, within: float) -> List[str]:
    if direction.Length == 0.0:
        raise InputError("Faces", "(0, 0, 0)", "give a normal that has a length.")
    return [
        _name(k)
        for k, face in enumerate(shape.Faces)
        if _normal(face).Length > 0.0 and _normal(face).getAngle(direction) <= within
    ]


def _nearest(shape: Any, point: Any) -> List[str]:
    vertex = Part.Vertex(point)
    return _first(shape, range(len(shape.Faces)), lambda face: -face.distToShape(vertex)[0])

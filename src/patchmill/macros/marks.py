"""Colours and labels that a part's faces have in FreeCAD or in the file that they come from.

FreeCAD without its window keeps no colours. Those of a STEP or IGES file are then read from it once more, and
those of a FreeCAD document from what its window has saved in it.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import re
import struct
import xml.etree.ElementTree
import zipfile
from typing import Any, Dict, List, Optional, Tuple

import FreeCAD
import numpy as np
import Part
from _patchmill import InputError

SOURCE = "PatchMillSource"  # property with the file that a part was read from; never saved
NOT_SAVED, HIDDEN = 32, 4  # App::PropertyType
COLOUR_NEAR = 2.0 / 255.0
SAME_FACE = 1e-6  # relative, of area and perimeter; mm beside it, of the centre

Colour = Tuple[float, float, float]


def remember(part: Any, filename: str) -> None:
    """Keeps the name of the file that a part was read from, until its document is closed."""
    about = "File that the part was read from"
    part.addProperty("App::PropertyString", SOURCE, "PatchMill", about, NOT_SAVED | HIDDEN)
    setattr(part, SOURCE, os.path.abspath(filename))


def parse_colour(text: Any) -> Colour:
    """Red, green and blue, 0 to 1, of "#rrggbb". Raises InputError naming Faces."""
    if not isinstance(text, str) or not re.fullmatch(r"#[0-9a-fA-F]{6}", text):
        raise InputError("Faces", repr(text), "give a colour as #rrggbb.")
    return int(text[1:3], 16) / 255.0, int(text[3:5], 16) / 255.0, int(text[5:7], 16) / 255.0


def with_colour(part: Any, text: Any) -> List[int]:
    """Numbers, from 0, of the part's faces that have a colour. Raises InputError naming Faces, with the
    colours that there are."""
    wanted = np.asarray(parse_colour(text))
    colours = face_colours(part)
    if not colours:
        raise InputError("Faces", text, "the faces of %s have no colours." % part.Label)
    found = [k for k, c in colours.items() if np.abs(np.asarray(c) - wanted).max() <= COLOUR_NEAR]
    if not found:
        known = sorted({"#%02x%02x%02x" % tuple(round(255.0 * v) for v in c) for c in colours.values()})
        raise InputError("Faces", text, "the part's faces have the colours %s." % ", ".join(known[:20]))
    return sorted(found)


def with_label(part: Any, label: str) -> List[int]:
    """Numbers, from 0, of the part's faces that an object of that label in its document has, too, or a solid
    of that name in its STEP file. Raises InputError naming Faces, with the labels that there are."""
    shapes = {o.Label: o.Shape for o in _original(part).Document.Objects if _has_faces(o)}
    if label not in shapes and _source(part):
        shapes.update(_labelled_shapes(_source(part)))
    if label not in shapes:
        raise InputError("Faces", label, "there are: %s." % ", ".join(sorted(shapes)[:20]))
    return sorted(set(_same_faces(part.Shape, shapes[label].Faces).values()))


def face_colours(part: Any) -> Dict[int, Colour]:
    """Colours by the number of the face, from 0; those that nobody has said are missing."""
    original = _original(part)
    view = original.ViewObject
    if view is not None and hasattr(view, "DiffuseColor"):
        return _spread(list(view.DiffuseColor), len(original.Shape.Faces))
    if _source(part):
        return _colours_of_file(part)
    saved = _saved_colours(original)
    return _spread(saved, len(original.Shape.Faces))


def _original(part: Any) -> Any:
    """What a job's model was cloned from: the clone has no colours of its own."""
    while getattr(part, "Objects", None) and len(part.Objects) == 1:
        part = part.Objects[0]
    return part


def _source(part: Any) -> str:
    return str(getattr(_original(part), SOURCE, ""))


def _has_faces(obj: Any) -> bool:
    return bool(getattr(obj, "Shape", None) and obj.Shape.Faces)


def _spread(colours: List[Any], count: int) -> Dict[int, Colour]:
    """One colour for all faces, or one for each."""
    if len(colours) == 1:
        colours = colours * count
    return {k: (c[0], c[1], c[2]) for k, c in enumerate(colours)} if len(colours) == count else {}


def _colours_of_file(part: Any) -> Dict[int, Colour]:
    """As FreeCAD's importer tells them beside the objects that it makes."""
    document = FreeCAD.newDocument("colours", hidden=True)
    try:
        told = {obj.Name: list(found) for obj, found in _imported(_source(part), document) or []}
        colours: Dict[int, Colour] = {}
        for obj, shape in _placed(document):
            spread = _spread(told.get(obj.Name, []), len(shape.Faces))
            same = _same_faces(part.Shape, shape.Faces) if spread else {}
            colours.update({same[k]: colour for k, colour in spread.items() if k in same})
        return colours
    finally:
        FreeCAD.closeDocument(document.Name)


def _labelled_shapes(filename: str) -> Dict[str, Any]:
    document = FreeCAD.newDocument("labels", hidden=True)
    try:
        _imported(filename, document)
        return {obj.Label: shape.copy() for obj, shape in _placed(document)}
    finally:
        FreeCAD.closeDocument(document.Name)


def _imported(filename: str, document: Any) -> Any:
    """What the importer returns: (object, colours) for each that has any. Merging an assembly's solids ends
    FreeCAD 0.20 without its window, so they stay apart."""
    if not filename.lower().endswith((".step", ".stp", ".iges", ".igs")):
        return None
    import Import

    return Import.insert(filename, document.Name, merge=False)


def _placed(document: Any) -> List[Tuple[Any, Any]]:
    """(object, its shape where it is in the document) for all that have faces, also in groups and links."""
    found = []

    def look(root: Any, path: str) -> None:
        below = root.getSubObject(path, retType=1) if path else root
        names = below.getSubObjects()
        for name in names:
            look(root, path + name)
        shape = Part.getShape(root, path, needSubElement=False)
        if not names and not shape.isNull() and shape.Faces:
            found.append((below.getLinkedObject(True), shape))

    for root in document.Objects:
        if not root.InList:
            look(root, "")
    return found


def _same_faces(shape: Any, faces: List[Any]) -> Dict[int, int]:
    """{number in `faces`: number in `shape`} of faces that are in both: of the same area, perimeter and
    centre."""
    own = np.asarray([_figures(face) for face in shape.Faces])
    same = {}
    for number, face in enumerate(faces):
        figures = np.asarray(_figures(face))
        off = np.abs(own - figures)
        near = (off[:, :2] <= SAME_FACE * (1.0 + figures[:2])).all(axis=1)
        near &= (off[:, 2:] <= SAME_FACE * (1.0 + np.abs(figures[2:]).max())).all(axis=1)
        found = np.flatnonzero(near)
        if len(found):
            same[number] = int(found[0])
    return same


def _figures(face: Any) -> Tuple[float, ...]:
    centre = face.CenterOfMass
    return face.Area, face.Length, centre.x, centre.y, centre.z


def _saved_colours(part: Any) -> List[Colour]:
    """DiffuseColor of an object in the file of its document, as its window saved it; none if it is not
    there. Raises InputError naming Faces where the document has them in another form."""
    filename = part.Document.FileName
    if not filename or not zipfile.is_zipfile(filename):
        return []
    with zipfile.ZipFile(filename) as archive:
        if "GuiDocument.xml" not in archive.namelist():
            return []
        with archive.open("GuiDocument.xml") as file:
            root = xml.etree.ElementTree.parse(file).getroot()
        path = "ViewProviderData/ViewProvider[@name='%s']/Properties/Property" % part.Name
        properties = {p.get("name"): p for p in root.findall(path)}
        if "ShapeAppearance" in properties:
            remedy = "a document of FreeCAD 1.0 or later has them for its window only: export it as STEP."
            raise InputError("Faces", os.path.basename(filename), remedy)
        stored = _file_of(properties.get("DiffuseColor"))
        return _unpacked(archive.read(stored)) if stored else []


def _file_of(found: Any) -> Optional[str]:
    entry = None if found is None else found.find("ColorList")
    return None if entry is None else entry.get("file")


def _unpacked(raw: bytes) -> List[Colour]:
    """A PropertyColorList's file: their number, then a word with red, green, blue and transparency each."""
    (count,) = struct.unpack_from("<I", raw)
    words = struct.unpack_from("<%dI" % count, raw, 4)
    return [((w >> 24) / 255.0, (w >> 16 & 255) / 255.0, (w >> 8 & 255) / 255.0) for w in words]

"""X3P (.x3p) of ISO 25178-72: a ZIP archive with main.xml, the heights as a binary file, and MD5 sums.
Lengths are metres; y grows with the row; unknown heights are NaN, or zeros of a file of valid points.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import datetime
import hashlib
import io
import re
import zipfile
import zlib
from xml.etree import ElementTree

import numpy as np
from _patchmill import InputError

from patchmill._version import __version__
from patchmill.surface.height_map import HeightMap, require_grid

SPACE = "http://www.opengps.eu/2008/ISO5436_2"
TYPES = {"I": "<i2", "L": "<i4", "F": "<f4", "D": "<f8"}
MOST_XML = 1 << 22
MAIN, DATA, SUMS = "main.xml", "bindata/data.bin", "md5checksum.hex"


def write(file, surface):
    """Writes a HeightMap; its heights are 64-bit numbers."""
    sums = hashlib.md5(usedforsecurity=False)
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        with archive.open(DATA, "w", force_zip64=True) as data:
            for row in surface.heights:
                block = (row.astype(float) * 1e-3).astype("<f8").tobytes()
                sums.update(block)
                data.write(block)
        main = _main_xml(surface, sums.hexdigest())
        archive.writestr(MAIN, main)
        archive.writestr(SUMS, "%s *%s\n" % (hashlib.md5(main, usedforsecurity=False).hexdigest(), MAIN))


def _main_xml(surface, data_sum):
    rows, columns = surface.heights.shape
    now = datetime.datetime.now(datetime.timezone.utc).isoformat(timespec="seconds")
    root = ElementTree.Element("p:ISO5436_2", {"xmlns:p": SPACE})
    record = ElementTree.SubElement(root, "Record1")
    _leaves(record, Revision="ISO5436 - 2000", FeatureType="SUR")
    axes = ElementTree.SubElement(record, "Axes")
    for name, step, origin in zip(("CX", "CY"), surface.step, surface.origin):
        axis = ElementTree.SubElement(axes, name)
        _leaves(axis, AxisType="I", DataType="D", Increment=repr(step * 1e-3), Offset=repr(origin * 1e-3))
    _leaves(ElementTree.SubElement(axes, "CZ"), AxisType="A", DataType="D", Increment="1", Offset="0")
    record = ElementTree.SubElement(root, "Record2")
    _leaves(record, Date=now)
    instrument = ElementTree.SubElement(record, "Instrument")
    _leaves(instrument, Manufacturer="PatchMill", Model="simulation", Serial="none", Version=__version__)
    _leaves(record, CalibrationDate=now)
    _leaves(ElementTree.SubElement(record, "ProbingSystem"), Type="Software", Identification="PatchMill")
    _leaves(record, Comment=" ".join(surface.title.split()) or "Heights")
    record = ElementTree.SubElement(root, "Record3")
    _leaves(ElementTree.SubElement(record, "MatrixDimension"), SizeX=str(columns), SizeY=str(rows), SizeZ="1")
    link = ElementTree.SubElement(record, "DataLink")
    _leaves(link, PointDataLink=DATA, MD5ChecksumPointData=data_sum)
    _leaves(ElementTree.SubElement(root, "Record4"), ChecksumFile=SUMS)
    return ElementTree.tostring(root, encoding="UTF-8", xml_declaration=True)


def _leaves(parent, **texts):
    for name, text in texts.items():
        ElementTree.SubElement(parent, name).text = text


def read(content):
    """The HeightMap of a file's bytes. Raises InputError naming Surface."""
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            return _read_archive(archive)
    except (zipfile.BadZipFile, KeyError, ValueError, NotImplementedError, EOFError, OSError, RuntimeError,
            ElementTree.ParseError, OverflowError, zlib.error) as error:  # fmt: skip
        raise InputError("Surface", "X3P: %s" % error, "the file is damaged, or no X3P file.") from error


def _read_archive(archive):
    main = _member(archive, MAIN, MOST_XML)
    if re.search(rb"<!(DOCTYPE|ENTITY)", main):
        raise ValueError("main.xml declares entities")
    found = _texts(ElementTree.fromstring(main))
    columns, rows = int(found["SizeX"]), int(found["SizeY"])
    if int(found.get("SizeZ", "1")) != 1 or found.get("FeatureType", "SUR") != "SUR":
        raise ValueError("no surface of one layer")
    kind = found["CZ/DataType"]
    if kind not in TYPES or "PointDataLink" not in found:
        raise ValueError("heights that are not in a binary file")
    number = np.dtype(TYPES[kind])
    require_grid(rows, columns, "X3P")
    data = _member(archive, found["PointDataLink"], rows * columns * number.itemsize)
    require_grid(rows, columns, "X3P", len(data), number.itemsize)
    wanted = found.get("MD5ChecksumPointData", "").lower()
    if wanted and hashlib.md5(data, usedforsecurity=False).hexdigest() != wanted:
        raise ValueError("the heights do not have the checksum that main.xml says")
    heights = np.frombuffer(data, number, rows * columns).reshape(rows, columns).astype(float)
    if number.kind == "i":
        heights = heights * float(found["CZ/Increment"]) + float(found.get("CZ/Offset", "0"))
    if "ValidPointsLink" in found:
        bits = _member(archive, found["ValidPointsLink"], (rows * columns + 7) // 8)
        valid = np.unpackbits(np.frombuffer(bits, np.uint8), bitorder="little")[: rows * columns]
        heights[valid.reshape(rows, columns) == 0] = np.nan
    heights[~np.isfinite(heights)] = np.nan
    step = [float(found["C%s/Increment" % axis]) * 1e3 for axis in "XY"]
    origin = [float(found.get("C%s/Offset" % axis, "0") or 0.0) * 1e3 for axis in "XY"]
    return HeightMap(heights * 1e3, tuple(step), tuple(origin), found.get("Comment", ""))


def _member(archive, name, most):
    """Content of a member that has at most so many bytes, whatever the archive says of itself."""
    with archive.open(name) as file:
        content = file.read(most + 1)
    if len(content) > most:
        raise ValueError("%s has more than %d bytes" % (name, most))
    return content


def _texts(root):
    """Texts of all leaves by name; those of an axis as CX/Increment."""
    found = {}
    for element in root.iter():
        name = element.tag.rsplit("}", 1)[-1]
        for child in element:
            text = (child.text or "").strip()
            leaf = child.tag.rsplit("}", 1)[-1]
            found["%s/%s" % (name, leaf) if name in ("CX", "CY", "CZ") else leaf] = text
    return found

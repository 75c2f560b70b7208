"""Writes the texts of the property tables, of dimples' states, of machine files, of errors and of remarks for
Qt's lupdate, which finds only what is written in a call (see tools/translations), and a list of those of
errors and remarks, by which they are known again when they are said:

    tools/freecad tools/table_texts.py

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import pathlib
import sys

import _patchmill as core
from patchmill.machine import machine_table, machines
from patchmill.modifiers import dressup_dcm
from patchmill.operations.copy_milling import ObjectCopyMilling
from patchmill.operations.planar_texture import ObjectPlanarTexture
from patchmill.operations.pyramid_texture import ObjectPyramidTexture
from patchmill.operations.texture_operation import ObjectTexture
from patchmill.properties.property_table import ENUMERATION, label_of

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import sentence_texts  # noqa: E402

FILE = pathlib.Path(__file__).resolve().parents[1] / "Resources" / "translations" / "table_texts.js"
SENTENCES = FILE.with_name("sentences.txt")
TABLES = (
    ObjectTexture.properties(),
    ObjectPlanarTexture.OWN_PROPERTIES,
    ObjectPyramidTexture.OWN_PROPERTIES,
    ObjectCopyMilling.properties(),
    dressup_dcm.PROPERTIES,
)
RESULTS = (
    ObjectTexture.results(),
    ObjectPlanarTexture.OWN_RESULTS,
    ObjectCopyMilling.results(),
    dressup_dcm.RESULTS,
)
SIMULATED = (  # the names in SimulatedTexture.rows
    "Motion",
    "Dimples planned",
    "found",
    "marks that nobody planned",
    "off their places, rms",
    "depth to the rim",
    "diameter, mean",
    "distance to the nearest, mean",
    "array",
    "quality, 0 to 1",
    "part that is milled, seen from above",  # and in MilledSurface.rows
    "left over the part, mean",
    "left over the part, at most",
    "cut below the part, at most",
    "grid",
)
# what a machine file may say that is no name of a controller or axis
MACHINE_WORDS = ("yes", "no", "table", "head", "tip", "ball centre", "index", "at speed")
ARRAYS = ("square", "staggered", "oblique", "irregular")
HEAD = """// Texts that are shown from tables: made by tools/table_texts.py for lupdate, read by nobody else.
// SPDX-License-Identifier: LGPL-2.1-or-later
"""


def texts():
    """Pairs (context, text) in a fixed order, each once."""
    errors = [("PatchMill", sentence) for sentence in sentence_texts.sentences()]
    return list(dict.fromkeys(table_texts() + errors))


def table_texts():
    """Those of tables."""
    found = []
    for table in TABLES:
        for kind, name, group, tip, default in table:
            found += [("PatchMill", label_of(name)), ("PatchMill", group), ("App::Property", tip)]
            found += [("PatchMill", choice) for choice in default] if kind == ENUMERATION else []
    found += [("App::Property", tip) for table in RESULTS for _, _, _, tip in table]
    found += [("PatchMill", state) for state in core.state_colours()]
    found += [("PatchMill", array) for array in ARRAYS]
    found += [("PatchMill", name) for name in SIMULATED]
    found += [("PatchMill", word) for word in MACHINE_WORDS]
    for key in machines.names():
        found += [("PatchMill", row.label) for row in machine_table.rows(machines.load(key).data)]
    return found


def text_of_sentences():
    """What is in SENTENCES."""
    return "".join(sentence + "\n" for sentence in sentence_texts.sentences())


def text_of_file():
    """What is in FILE, a call to each line: lupdate reads JavaScript too, and joins no strings there."""
    return HEAD + "".join(_call(context, text) for context, text in texts())


def _call(context, text):
    return "QT_TRANSLATE_NOOP(%s, %s);\n" % tuple(json.dumps(t, ensure_ascii=False) for t in (context, text))


if __name__ == "__main__":
    FILE.parent.mkdir(exist_ok=True)
    FILE.write_text(text_of_file(), encoding="utf-8")
    SENTENCES.write_text(text_of_sentences(), encoding="utf-8")

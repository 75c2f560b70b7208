"""Writes the texts of the property tables, of dimples' states and of machine files for Qt's lupdate, which
finds only what is written in a call (see tools/translations):

    tools/freecad tools/table_texts.py

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import pathlib

import _patchmill as core
from patchmill.machine import machine_table, machines
from patchmill.modifiers import dressup_dcm
from patchmill.operations.copy_milling import ObjectCopyMilling
from patchmill.operations.planar_texture import ObjectPlanarTexture
from patchmill.operations.pyramid_texture import ObjectPyramidTexture
from patchmill.operations.texture_operation import ObjectTexture
from patchmill.properties.property_table import ENUMERATION, label_of

FILE = pathlib.Path(__file__).resolve().parents[1] / "Resources" / "translations" / "table_texts.py"
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
)
ARRAYS = ("square", "staggered", "oblique", "irregular")
HEAD = '''"""Texts that are shown from tables: made by tools/table_texts.py for lupdate, read by nobody else.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from patchmill.freecad.translate import QT_TRANSLATE_NOOP

TEXTS = (
'''


def texts():
    """Pairs (context, text) in a fixed order, each once."""
    found = []
    for table in TABLES:
        for kind, name, group, tip, default in table:
            found += [("PatchMill", label_of(name)), ("PatchMill", group), ("App::Property", tip)]
            found += [("PatchMill", choice) for choice in default] if kind == ENUMERATION else []
    found += [("App::Property", tip) for table in RESULTS for _, _, _, tip in table]
    found += [("PatchMill", state) for state in core.state_colours()]
    found += [("PatchMill", array) for array in ARRAYS]
    found += [("PatchMill", name) for name in SIMULATED]
    for key in machines.names():
        found += [("PatchMill", row.label) for row in machine_table.rows(machines.load(key).data)]
    return list(dict.fromkeys(found))


def text_of_file():
    """What is in FILE."""
    return HEAD + "".join(_call(context, text) for context, text in texts()) + ")\n"


def _call(context, text, most=80):
    """The lines that mark a text, in pieces if it is long."""
    pieces = []
    while len(text) > most:
        cut = text.rindex(" ", 0, most) + 1
        pieces.append(text[:cut])
        text = text[cut:]
    said = [json.dumps(piece, ensure_ascii=False) for piece in pieces + [text]]
    line = "    QT_TRANSLATE_NOOP(%s, %s),\n" % (json.dumps(context), said[0])
    if len(said) == 1 and len(line) <= 110:
        return line
    rest = "".join("        %s\n" % piece for piece in said[:-1])
    return "    QT_TRANSLATE_NOOP(\n        %s,\n%s        %s,\n    ),\n" % (
        json.dumps(context),
        rest,
        said[-1],
    )


if __name__ == "__main__":
    FILE.parent.mkdir(exist_ok=True)
    FILE.write_text(text_of_file(), encoding="utf-8")

"""A part family from a FreeCAD document: a spreadsheet's rows set the part's sizes, each gets a program.

    patchmill macro family.py DOCUMENT OUT

The document has a spreadsheet "Family", whose first row is "Name" and then aliases of sizes ("Length"), whose
further rows are the parts; and a spreadsheet "Sizes" with these aliases, which the part's expressions use.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import sys

import FreeCAD
import patchmill

TOOL = {"diameter": 2, "flutes": 2, "speed": 1000, "feed": 434.413}
FACES = {"normal": [0, 0, 1], "within": 45}  # degrees


def rows(sheet):
    """Dicts of a spreadsheet's rows, by its first row."""

    def cell(column, row):
        try:
            return sheet.get("%s%d" % (column, row))
        except ValueError:  # it is empty
            return None

    heads = [(c, cell(c, 1)) for c in "ABCDEFGHIJ" if cell(c, 1) is not None]
    row = 2
    while cell("A", row) is not None:
        yield {head: cell(column, row) for column, head in heads}
        row += 1


def member(document, values, out):
    """Sets the sizes of one part, mills a copy of it, and returns the number of dimples."""
    for alias, value in values.items():
        if alias != "Name":
            document.Sizes.set(alias, str(value))
    document.recompute()
    part = next(o for o in document.Objects if getattr(o, "Shape", None) and o.Shape.Solids and not o.InList)
    own = FreeCAD.newDocument("member")
    copy = own.addObject("Part::Feature", "Part")
    copy.Label, copy.Shape = str(values["Name"]), part.Shape.copy()
    job = patchmill.job(copy, tool=TOOL)
    op = patchmill.texture(job, FACES, Spacing=0.5, PatchSide=4)
    plan = patchmill.recompute(op)
    patchmill.post(job, os.path.join(out, "%s.ngc" % values["Name"]))
    FreeCAD.closeDocument(own.Name)
    return plan.counts["cut"]


def main(filename, out):
    os.makedirs(out, exist_ok=True)
    document = FreeCAD.openDocument(filename)
    for values in list(rows(document.Family)):
        print("%s: %d dimples" % (values["Name"], member(document, values, out)))
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))

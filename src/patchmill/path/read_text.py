"""FreeCAD's paths from text. FreeCAD reads numbers as the process's locale writes them: where an add-on has
set one with a decimal comma, "X1.25" would be 1 mm.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import _patchmill as core

from patchmill.freecad import host


def path_of(text):
    """Path.Path of `text`, whose numbers have decimal points in every locale."""
    return core.with_decimal_points(lambda: host.Path.Path(text))


def text_of(path):
    """The text of a Path.Path, a command in each line whatever its name holds: a comment's own line ends
    would make commands of what comes after them."""
    text = core.with_decimal_points(path.toGCode)
    if text.count("\n") == path.Size and "\r" not in text:
        return text
    commands = (core.with_decimal_points(command.toGCode) for command in path.Commands)
    return "".join("%s\n" % " ".join(command.splitlines()) for command in commands)

"""FreeCAD post-processor for LinuxCNC that keeps the words which spindle-locked paths need: K of G33, P of
G64 with six decimals, and an F on every G1. FreeCAD's own linuxcnc post drops K.

Choose `patchmill_linuxcnc` as the job's post-processor. It takes FreeCAD's usual arguments.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import argparse
import shlex

TOOLTIP = "LinuxCNC with spindle-locked moves (G33), by PatchMill"
UNITS = "G21"
ORDER = "XYZABCIJKFSTPQRLHD"
LENGTHS = "XYZABCIJ"
WHOLE = "STHDL"

parser = argparse.ArgumentParser(prog="patchmill_linuxcnc", add_help=False)
parser.add_argument("--no-header", action="store_true", help="suppress the header")
parser.add_argument("--no-comments", action="store_true", help="suppress comments")
parser.add_argument("--line-numbers", action="store_true", help="prefix lines with N words")
parser.add_argument("--no-show-editor", action="store_true", help="accepted; no editor is shown")
parser.add_argument("--precision", type=int, default=4, help="decimals of coordinates, default 4")
parser.add_argument("--preamble", default="G17 G54 G40 G49 G80 G90 G94", help="first commands")
parser.add_argument("--postamble", default="M5\nG61\nG17 G54 G90 G80 G40\nM2", help="last commands")
parser.add_argument("--inches", action="store_true", help="refused: textures are metric")
parser.add_argument("--no-tlo", action="store_true", help="suppress G43 after tool changes")
TOOLTIP_ARGS = parser.format_help()


def word(letter, value, precision):
    """One word of G-code; F comes in mm/s and goes out in mm/min."""
    if letter in WHOLE:
        return "%s%d" % (letter, value)
    if letter == "F":
        return "F%.*f" % (max(3, precision), 60.0 * value)
    return "%s%.*f" % (letter, precision if letter in LENGTHS else 6, value)


def command_lines(command, options):
    """The lines that one Path.Command makes."""
    name, parameters = command.Name, command.Parameters
    if name.startswith("("):
        return [] if options.no_comments else [name]
    rapid = name in ("G0", "G00")
    letters = [c for c in ORDER if c in parameters and not (rapid and c == "F")]
    text = " ".join([name] + [word(c, parameters[c], options.precision) for c in letters])
    if name in ("M6", "M06"):
        tool = ["G43 H%d" % parameters["T"]] if "T" in parameters and not options.no_tlo else []
        return ["M5", text] + tool
    return [text]


def object_lines(obj, options):
    """The lines of one operation, tool controller or fixture."""
    base = getattr(obj, "Base", None)
    for holder in (obj, base):
        if not getattr(holder, "Active", True):
            return
    coolant = getattr(obj, "CoolantMode", getattr(base, "CoolantMode", "None"))
    if coolant in ("Flood", "Mist"):
        yield {"Flood": "M8", "Mist": "M7"}[coolant]
    for command in obj.Path.Commands:
        yield from command_lines(command, options)
    if coolant in ("Flood", "Mist"):
        yield "M9"


def program(objects, arguments):
    """The program's text. Raises ValueError for arguments that are not understood."""
    options, unknown = parser.parse_known_args(shlex.split(arguments))
    if unknown or options.inches:
        raise ValueError("patchmill_linuxcnc: not possible: %s" % (" ".join(unknown) or "--inches"))
    lines = [] if options.no_header else ["(LinuxCNC, posted by PatchMill)"]
    lines += options.preamble.splitlines() + [UNITS]
    for obj in objects:
        if hasattr(obj, "Path"):
            lines += object_lines(obj, options)
    lines += options.postamble.splitlines()
    if options.line_numbers:
        lines = ["N%d %s" % (10 * (i + 1), line) for i, line in enumerate(lines)]
    return "\n".join(lines) + "\n"


def export(objectslist, filename, argstring):
    """FreeCAD 0.20 calls this; "-" writes no file."""
    text = program(objectslist, argstring)
    if filename != "-":
        with open(filename, "w", encoding="utf-8") as file:
            file.write(text)
    return text


try:
    from Path.Post.Processor import PostProcessor
except ImportError:
    PostProcessor = None

if PostProcessor is not None:

    class Patchmill_Linuxcnc(PostProcessor):
        """FreeCAD 1.0 and later look for this class by the post's name."""

        def __init__(self, job):
            super().__init__(job, tooltip=TOOLTIP, tooltipargs=TOOLTIP_ARGS, units="Metric")

        @property
        def tooltip(self):
            return TOOLTIP

        @property
        def tooltipArgs(self):
            return TOOLTIP_ARGS

        def export(self):
            arguments = self._job.PostProcessorArgs
            return [(name, program(objects, arguments)) for name, objects in self._buildPostList()]

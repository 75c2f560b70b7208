"""What PatchMill's own post-processors share: FreeCAD's usual arguments, and the way from the job's
objects to the core's writer. A post is a file NAME_post.py with a few lines over Dialect (src/posts).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import argparse
import re
import shlex

import _patchmill as core
from _patchmill import InputError

from patchmill.freecad import host
from patchmill.posting import program_header


class Dialect:
    """One post-processor: the core's dialect and what it has by default."""

    def __init__(self, post, dialect, controller, precision, modal=False, line_numbers=False):
        self.post, self.dialect, self.controller = post, dialect, controller
        self.tooltip = "%s, by PatchMill" % controller
        self.parser = _parser(post, precision, modal, line_numbers)

    @property
    def arguments_help(self):
        return self.parser.format_help()

    def precision(self, arguments):
        """Decimals of coordinates that the program will have with these arguments."""
        return self.options(arguments).precision

    def options(self, arguments):
        """The options of an argument string. Raises InputError for what is not understood."""
        try:
            options, unknown = self.parser.parse_known_args(shlex.split(arguments or ""))
        except (argparse.ArgumentError, ValueError, SystemExit) as error:
            raise InputError("PostProcessorArgs", arguments, "%s cannot read it: %s." % (self.post, error))
        if unknown:
            raise InputError("PostProcessorArgs", " ".join(unknown), "%s does not know it." % self.post)
        if options.inches:
            raise InputError("PostProcessorArgs", "--inches", "textures are posted in millimetres.")
        return options

    def program(self, objects, arguments):
        """The program of a list of FreeCAD objects, as FreeCAD hands them to a post."""
        options = self.options(arguments)
        objects = [o for o in objects if hasattr(o, "Path") and _active(o)]
        header = program_header.lines(objects, self.controller) if options.header else []
        smoothing = program_header.smoothing(objects)
        return core.write_program(
            [_text(o) for o in objects],
            self.dialect,
            precision=options.precision,
            line_numbers=options.line_numbers,
            comments=options.comments,
            modal=options.modal,
            axis_modal=options.axis_modal,
            tool_length=options.tlo,
            name=_name(objects),
            header=header,
            preamble=(options.preamble or "").replace("\\n", "\n"),
            postamble=(options.postamble or "").replace("\\n", "\n"),
            smoothing_on=smoothing[0],
            smoothing_off=smoothing[1],
        )

    def export(self, objects, filename, arguments):
        """FreeCAD 0.20 calls this; "-" writes no file."""
        text = self.program(objects, arguments)
        if filename != "-":
            with open(filename, "w", encoding="utf-8") as file:
                file.write(text)
        return text

    def processor(self):
        """The class that FreeCAD 1.0 and later look for, or None on older ones."""
        PostProcessor = host.post_processor_class()
        if PostProcessor is None:
            return None
        dialect = self

        class Processor(PostProcessor):
            def __init__(self, job):
                super().__init__(
                    job, tooltip=dialect.tooltip, tooltipargs=dialect.arguments_help, units="Metric"
                )

            @property
            def tooltip(self):
                return dialect.tooltip

            @property
            def tooltipArgs(self):
                return dialect.arguments_help

            def export(self):
                arguments = self._job.PostProcessorArgs
                return [(name, dialect.program(objs, arguments)) for name, objs in self._buildPostList()]

        return Processor


def _parser(post, precision, modal, line_numbers):
    parser = argparse.ArgumentParser(prog=post, add_help=False)

    def pair(word, default, text):
        name = word.replace("-", "_")
        parser.add_argument("--" + word, dest=name, action="store_true", help=text)
        parser.add_argument("--no-" + word, dest=name, action="store_false", help="the opposite")
        parser.set_defaults(**{name: default})

    pair("header", True, "what the program is and what the operator sets, at its top (default)")
    pair("comments", True, "comments of the operations (default)")
    pair("line-numbers", line_numbers, "number the blocks")
    pair("modal", modal, "leave out a G word that is in force")
    pair("axis-modal", modal, "leave out words of axes that stay where they are")
    pair("tlo", True, "tool length offset after a tool change (default)")
    pair("show-editor", False, "accepted; no editor is shown")
    parser.add_argument("--precision", type=int, default=precision, help="decimals, default %d" % precision)
    parser.add_argument("--preamble", help="first lines, instead of the dialect's own")
    parser.add_argument("--postamble", help="last lines, instead of the dialect's own")
    parser.add_argument("--inches", action="store_true", help="refused: textures are metric")
    return parser


def _active(obj):
    return getattr(obj, "Active", True) and getattr(getattr(obj, "Base", None), "Active", True)


def _text(obj):
    """An object's path with its coolant."""
    mode = getattr(obj, "CoolantMode", getattr(getattr(obj, "Base", None), "CoolantMode", "None"))
    text = obj.Path.toGCode()
    if mode in ("Flood", "Mist"):
        return "%s\n%s\nM9\n" % ({"Flood": "M8", "Mist": "M7"}[mode], text)
    return text


def _name(objects):
    """A program's name: letters, digits and underscores, as every control takes it."""
    for obj in objects:
        if hasattr(obj, "Spacing"):
            return re.sub(r"[^A-Z0-9]+", "_", obj.Label.upper()).strip("_")[:24] or "PATCHMILL"
    return "PATCHMILL"

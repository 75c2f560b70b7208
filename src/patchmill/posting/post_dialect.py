"""What PatchMill's own post-processors share: FreeCAD's usual arguments, and the way from the job's
objects to the core's writer. A post is a file NAME_post.py with a few lines over Dialect (src/posts); what
its control can do and how its words are is the core's (src/core: a file for each control).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import argparse
import re
import shlex

import _patchmill as core
from _patchmill import InputError

from patchmill import posting
from patchmill.system import files
from patchmill.freecad import host
from patchmill.path.read_text import text_of
from patchmill.posting import job_words, program_header
from patchmill.verify import posted_between

MOST_DECIMALS = 6


class Dialect:
    """One post-processor: the name of the core's control, and what it has by default."""

    def __init__(self, post, dialect, controller, precision, modal=False, line_numbers=False):
        self.post, self.dialect, self.controller = post, dialect, controller
        self.default_precision = precision
        self.tooltip = "%s, by PatchMill" % controller
        self.parser = _parser(post, precision, modal, line_numbers)

    @property
    def arguments_help(self):
        return self.parser.format_help()

    def precision(self, arguments, machine=None):
        """Decimals of coordinates that the program will have with these arguments: what they say, else those
        of the machines.Machine, else the control's usual ones."""
        said = self.options(arguments).precision
        if said is not None:
            return said
        return self.default_precision if machine is None else min(machine.data["decimals"], MOST_DECIMALS)

    def options(self, arguments):
        """The options of an argument string. Raises InputError for what is not understood."""
        try:
            options, unknown = self.parser.parse_known_args(shlex.split(arguments or ""))
        except (argparse.ArgumentError, ValueError) as error:
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
        machine = program_header.machine_of(objects)
        texts = [_text(o) for o in objects]
        try:
            return core.write_program(
                texts,
                self.dialect,
                precision=self.precision(arguments, machine),
                line_numbers=options.line_numbers,
                comments=options.comments,
                modal=options.modal,
                axis_modal=options.axis_modal,
                tool_length=options.tlo,
                name=_name(objects),
                number=options.program_number,
                header=header,
                preamble=(options.preamble or "").replace("\\n", "\n"),
                postamble=(options.postamble or "").replace("\\n", "\n"),
                stock=program_header.stock_corners(objects),
                own=[_is_own(o) for o in objects],
                **_machine_words(machine, self.dialect),
            )
        except InputError as error:
            raise _of_operation(error, objects, texts) from error

    def retract_lines(self, arguments, machine):
        """The lines by which a program comes clear of everything before tool changes, turns and its end; none
        where the machines.Machine, or None, does not say where that is."""
        plain, retracting = (
            core.write_program(
                [], self.dialect, precision=self.precision(arguments, machine), retract=retract
            ).splitlines()
            for retract in ([], _retract(machine))
        )
        return posted_between.added(plain, retracting)

    def compared(self, objects, arguments):
        """The program, read back and checked as patchmill.post() does it, which says --no-compare and does so
        itself. Raises InputError for one that does not hold the job."""
        text = self.program(objects, arguments)
        if self.options(arguments).compare:
            posting.require_holds(text, objects, self.post, arguments)
        return text

    def export(self, objects, filename, arguments):
        """FreeCAD 0.20 calls this; "-" writes no file."""
        text = self.compared(objects, arguments)
        if filename != "-":
            files.write(filename, text)
        return text

    def processor(self):
        """The class that FreeCAD 1.0 and later look for, or None on older ones."""
        PostProcessor = host.post_processor_class()
        if PostProcessor is None:
            return None
        dialect = self

        class Processor(PostProcessor):  # type: ignore  # FreeCAD gives it while it runs
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
                return [(name, dialect.compared(objs, arguments)) for name, objs in host.files_of_post(self)]

            def export2(self):  # FreeCAD 26.3, for a job with a machine of its own; its own way loses words
                return self.export()

        return Processor


class _Parser(argparse.ArgumentParser):
    """One that says what is wrong to who asks, not to the standard error, and does not end FreeCAD."""

    def error(self, message):
        raise ValueError(message)


def _parser(post, precision, modal, line_numbers):
    parser = _Parser(prog=post, add_help=False)

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
    pair("compare", True, "read the program back, and refuse one that does not hold the job (default)")
    pair("show-editor", False, "accepted; no editor is shown")
    usual = "decimals; default the machine file's, without a machine %d" % precision
    parser.add_argument("--precision", type=int, help=usual)
    parser.add_argument("--program-number", type=int, default=1, help="1 to 9999, where programs have one")
    parser.add_argument("--preamble", help="first lines, instead of the dialect's own")
    parser.add_argument("--postamble", help="last lines, instead of the dialect's own")
    parser.add_argument("--inches", action="store_true", help="refused: textures are metric")
    return parser


def _active(obj):
    """Whether an object and all that it is a dressup on are switched on."""
    while hasattr(obj, "Path"):
        if not getattr(obj, "Active", True):
            return False
        obj = getattr(obj, "Base", None)
    return True


def _is_own(obj):
    """Whether an object's path is of PatchMill's making: an operation of ours or a modifier on any."""
    return type(getattr(obj, "Proxy", None)).__module__.partition(".")[0] == "patchmill"


def _machine_words(machine, dialect):
    """The machine file's own words, as keywords of write_program: of TCP and of smoothing where it is of
    this control, and where the tool is clear of everything."""
    if machine is None:
        return {}
    words: dict = {"retract": _retract(machine)}
    controller = machine.controller
    if controller["dialect"] == dialect:
        names = ("smoothing_on", "smoothing_off", "tcp_on", "tcp_off")
        words.update((name, controller.get(name, "")) for name in names)
        for name in ("tcp_on", "tcp_off"):  # G43.4 and G49 are how a path says it; the control has its own
            if words[name][:1] == "G":
                words[name] = ""
    return words


def _retract(machine):
    """(axis, machine coordinate in mm) in the order of the moves."""
    data = {} if machine is None else machine.data.get("retract_mm", {})
    return [(axis, data[axis]) for axis in "ZXY" if axis in data]


def _text(obj):
    """An object's path with its coolant, and with F as it was planned, of which FreeCAD's text has six
    decimals."""
    mode = host.coolant_of(obj)
    text = text_of(obj.Path)
    feeds = _feeds(obj)
    if feeds:
        text = core.with_feeds(text, feeds)
    if mode in ("Flood", "Mist"):
        return "%s\n%s\nM9\n" % ({"Flood": "M8", "Mist": "M7"}[mode], text)
    if not _is_own(obj) and job_words.leaves_coolant(obj):  # the next one finds it as it was
        return text + "\nM9\n"
    return text


def _of_operation(error, objects, texts):
    """An InputError of the core's writer that names a block of a path, naming the operation that has it."""
    block = str(error.value)[1:-1]
    if error.property == "Path":
        for obj, text in zip(objects, texts):
            if block in text.splitlines():
                return InputError(obj.Label, block, error.remedy)
    return error


def _feeds(obj):
    """Every F of a planned texture's path in its order [mm/s, or 1/s]; nothing for other objects."""
    plan = getattr(getattr(obj, "Proxy", None), "planned", None)
    return [] if plan is None else core.feeds_of(str(plan.pacing.text))


def _name(objects):
    """A program's name: letters, digits and underscores, as every control takes it."""
    for obj in objects:
        if hasattr(obj, "Spacing"):
            return re.sub(r"[^A-Z0-9]+", "_", obj.Label.upper()).strip("_")[:24] or "PATCHMILL"
    return "PATCHMILL"

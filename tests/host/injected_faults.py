"""Faults injected into posted programs: one word changed at random in any copy, operation or stretch between
them. What reading back does not find is listed. Run it with a number of faults and a seed, over small jobs or
over the mould maker's:

    tools/freecad tests/host/injected_faults.py 1000 7
    tools/freecad tests/host/injected_faults.py 1000 7 mould

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import pathlib
import random
import re
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import FreeCAD  # noqa: E402
import patchmill  # noqa: E402
from mould_job import CASES, locked_machines, mould_job  # noqa: E402
from patchmill import InputError, posting  # noqa: E402
from patchmill.freecad import host  # noqa: E402
from patchmill.posting import kept_words, program_header  # noqa: E402
from patchmill.verify import checks, posted_job  # noqa: E402
from patchmill.verify.posted_texture import PostedTexture  # noqa: E402
from roof_job import custom, roof_job  # noqa: E402

LOCKED, TIMED, CONSTANT = "Spindle-locked", "Feed per move", "Constant feed"
ARCS = ["G0 Z30", "G0 X40 Y0", "G1 Z20 F10", "G2 X44 Y0 I2 J0 K0 F10", "G1 X46", "G0 Z30", "G98"]
CYCLES = ["G83 X50 Y5 Z18 R25 Q2 F5", "G82 X55 Y5 Z18 R25 P0.5 F5", "G80", "G0 Z30"]
LETTERS = "XYZABCIJKRFSTHPQGM"
WORD = re.compile(r"(?<![A-Z])[A-Z][+-]?\d+\.?\d*")


class Case:
    """A posted job whose program can be read again."""

    def __init__(self, name, post, job, arguments="--no-header --precision=3"):
        self.name, self.post, self.job = name, post, job
        self.half_unit = 0.5 * 10.0 ** -int(re.search(r"--precision=(\d)", arguments).group(1))
        own = posting.own_dialect(post)
        self.dialect, self.own = own.dialect if own else "linuxcnc", own is not None
        with tempfile.TemporaryDirectory() as folder:
            program = os.path.join(folder, "x.nc")
            patchmill.post(job, program, post, arguments)
            self.lines = pathlib.Path(program).read_text(encoding="ascii").split("\n")
        (self.objects,) = host.post_objects(job, post)
        self.known = kept_words.of_machine(program_header.machine_of(self.objects), arguments)
        machine = program_header.machine_of(self.objects)
        self.tcp = kept_words.tcp_words(machine, self.dialect)
        retract = own.retract_lines(arguments, machine) if own else ()
        self.more = {"length": self.own, "retract": retract}
        self.words = [
            (number, word)
            for number, line in enumerate(self.lines)
            for word in WORD.finditer(re.sub(r"\([^)]*\)|;.*", lambda m: " " * len(m.group()), line))
        ]

    def read(self, lines):
        """Reads a program as posting does. Raises InputError for what is found."""
        text = "\n".join(lines)
        posted = posted_job.read_back(
            text, self.objects, self.dialect, self.half_unit, self.known, self.own, self.tcp, **self.more
        )
        for one in posted:
            if isinstance(one, PostedTexture):
                checks.require_clear(one.operation, one.path, one.unplaced, blind=one.blind)

    def found(self, number, new):
        """Whether a fault, `new` in the place of a line, is found."""
        try:
            self.read(self.lines[:number] + [new] + self.lines[number + 1 :])
        except InputError:
            return True
        return False

    def fault(self, choose):
        """(number of the line, the word, what stands in its place, the line with it)."""
        while True:
            number, word = choose.choice(self.words)
            new = _changed(word.group(), choose)
            line = self.lines[number]
            spoilt = line[: word.start()] + new + line[word.end() :]
            same = (new[0], float(new[1:])) == (word.group()[0], float(word.group()[1:]))  # such as G-0
            if not same and not (word.group()[0] == new[0] == "N"):  # the number of a block
                return number, word.group(), new, spoilt


def _changed(word, choose):
    """Another word: one step of its last decimal, a digit, ten times as much, its sign, or its letter."""
    letter, number = word[0], word[1:]
    decimals = len(number.partition(".")[2])
    value, step = float(number), 10.0**-decimals
    kind = choose.randrange(6)
    if kind == 5:
        letter = choose.choice(LETTERS.replace(letter, ""))
    else:
        value += (step, -step, 0.1, 1.0, 10.0)[kind] if kind != 4 or value == 0.0 else 9.0 * value
    if kind in (2, 3) and choose.random() < 0.5:
        value = -value
    point = "." if number.endswith(".") else ""
    sign = "+" if number.startswith("+") and value >= 0.0 else ""
    return "%s%s%.*f%s" % (letter, sign, decimals, value, point)


def cases(names=None):
    """The Cases, one after the other, each with its document; those of these names alone."""
    both, all_of = ["G54", "G55"], ARCS + CYCLES
    for name, post, strategies, lines, offsets, machine in (
        ("locked, arcs and cycles, two offsets", "patchmill_linuxcnc", (LOCKED, CONSTANT), all_of, both, ""),
        ("locked along the longest axis", "patchmill_fanuc", (CONSTANT, LOCKED), all_of, both, ""),
        ("locked by I J K", "patchmill_siemens", (LOCKED,), ARCS, both, ""),
        ("feed per move", "patchmill_heidenhain", (TIMED, CONSTANT), ARCS, ["G54"], ""),
        ("constant", "patchmill_grblhal", (CONSTANT,), ARCS, both, ""),
        ("FreeCAD's own", "linuxcnc", (CONSTANT, CONSTANT), all_of, both, ""),
        ("five axes, then upright", "patchmill_linuxcnc", (TIMED,), ARCS, ["G54"], "table-table-ac"),
        ("five axes on a head", "patchmill_siemens", (TIMED,), ARCS, ["G55"], "head-table-bc"),
    ):
        if names is not None and name not in names:
            continue
        job, textures = roof_job(*strategies)
        for texture in textures:
            texture.PostUnheld = True
            if machine:
                texture.Machine, texture.FixedAxis = machine, FreeCAD.Vector(0.25, 0.1, 1)
        textures[0].CoolantMode = "Flood"
        custom(job, lines)
        job.Fixtures = offsets
        job.Document.recompute()
        yield Case(name, post, job)
        FreeCAD.closeDocument(job.Document.Name)


def not_found(case, number, seed):
    """[(line, word, new word)] of `number` random faults that reading back does not find."""
    choose = random.Random("%s %s" % (seed, case.name))
    missed = []
    for _ in range(number):
        at, word, new, spoilt = case.fault(choose)
        if not case.found(at, spoilt):
            missed.append((case.lines[at], word, new))
    return missed


def mould_cases(folder):
    """Cases of the mould maker's job by every post, with few patches; `folder`: of machine files."""
    locked_machines(folder)
    for post, machine, strategy, offsets, decimals in CASES:
        job, _ = mould_job(machine, strategy, decimals, offsets, patches=2)
        yield Case("mould, %s" % strategy, post, job, job.PostProcessorArgs)
        FreeCAD.closeDocument(job.Document.Name)


def main(number, seed, mould=""):
    total = count = 0
    with tempfile.TemporaryDirectory() as folder:
        each = -(-number // (len(CASES) if mould else 8))
        for case in mould_cases(folder) if mould else cases():
            missed = not_found(case, each, seed)
            total, count = total + len(missed), count + each
            print("%s, %s: %d of %d not found" % (case.name, case.post, len(missed), each), flush=True)
            for line, word, new in missed:
                print("    %s -> %s in %r" % (word, new, line), flush=True)
    print("%d of %d faults not found" % (total, count))


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]), *sys.argv[3:])

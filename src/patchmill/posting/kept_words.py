"""Whether a posted text has the words of an operation that posts like to lose: a G or M word beside another
(G0 G53), third linear axes, and what stands beside an M word (M62 P3).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import re

from _patchmill import InputError

from patchmill.verify import posted_milling

COMMENT = re.compile(r"\([^)]*\)|;.*")
WORD = re.compile(r"([A-Z])\s*([+-]?(?:\d+\.?\d*|\.\d+))")
ENDED_BY = {"G20": "G21", "G91": "G90", "G93": "G94", "G95": "G94", "G18": "G17", "G19": "G17"}
TCP = {"heidenhain": ("M128", "M129")}  # elsewhere they are words of a builder or a user
TOOL = ("M3", "M03", "M4", "M04", "M6", "M06")  # S and T, which are compared with the tool controller's


def of_machine(machine, arguments):
    """Words [(letter, value)] that a program has of its own: those of the machines.Machine, or None, and of
    the texts in a post's arguments."""
    texts = [arguments.replace("\\n", "\n")]
    if machine is not None:
        names = ("smoothing_on", "smoothing_off", "tcp_on", "tcp_off")
        texts += [machine.controller.get(name, "") for name in names]
        retract = machine.data.get("retract_mm", {})
        texts += ["G53 %s%r" % (axis, float(value)) for axis, value in retract.items()]
    return [word for text in texts for word in words_of(text)]


def left_by(words):
    """The first of the states that words [(letter, value)] leave on, by which what follows would be read
    otherwise; '' if none."""
    left: list[str] = []
    for letter, value in words:
        code = "%s%g" % (letter, value)
        left = [other for other in left if ENDED_BY[other] != code] + [code] * (code in ENDED_BY)
    return left[0] if left else ""


def words_of(text):
    """Words [(letter, value)] of lines of a program."""
    return [(letter, float(number)) for letter, number in WORD.findall(COMMENT.sub("", text))]


def tcp_words(machine, dialect):
    """The M words of a machines.Machine, or of None, that switch TCP on and off, or those of the `dialect`;
    '' where it says it by G43.4 or words that are no numbers."""
    controller = {} if machine is None else machine.controller
    own = TCP.get(dialect, ("", ""))
    words = [controller.get(name) or word for name, word in zip(("tcp_on", "tcp_off"), own)]
    return tuple(word if re.fullmatch(r"M\d+", word) else "" for word in words)


def require(post_name, objects, text):
    """Raises InputError naming PostProcessor if the text lacks such a word of one of a job's `objects`."""
    wanted = {word: obj for obj in objects for word in _rare(obj.Path.Commands)}
    if not wanted:
        return
    found = {
        (letter, round(float(number), 3))
        for line in text.splitlines()
        for letter, number in WORD.findall(COMMENT.sub("", line))
    }
    for (letter, value), obj in wanted.items():
        if (letter, value) not in found:
            remedy = "it does not keep %s%g of %s: use one of PatchMill's own posts."
            raise InputError("PostProcessor", post_name, remedy % (letter, value, obj.Label))


def require_labels(post_name, objects, text):
    """Raises InputError naming Label if a text has the label of one of a job's `objects`, or of its tool
    controller, and a control would not take all of it for a comment."""
    controllers = [posted_milling.controller_of(op) for op in objects]
    for obj in [*objects, *filter(None, controllers)]:
        plain = re.fullmatch(r"[ -'*-~]{0,200}", obj.Label)  # no parentheses, no more than a line
        if not plain and obj.Label in text:
            remedy = "%s writes it as it is: use letters and digits, or one of PatchMill's own posts."
            raise InputError("Label", repr(obj.Label), remedy % post_name)


def _rare(commands):
    """The words of a path that are looked for: (letter, value)."""
    for command in commands:
        name = command.Name
        if name[:1] not in ("G", "M", "N") or name in TOOL:
            continue
        for letter, value in command.Parameters.items():
            beside = letter in "GM" or (letter in "UVW" and name != "N")
            if beside or (name[0] == "M" and letter in "PQREL"):
                yield letter, round(value, 3)
        if name == "G53" or name.startswith("G54.1"):
            yield name[0], float(name[1:])

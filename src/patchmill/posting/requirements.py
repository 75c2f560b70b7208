"""What a job and a post-processor's arguments must be before a program is made of them.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import functools
import re
import shlex

import numpy as np
from _patchmill import InputError

from patchmill.freecad import host, post_probe
from patchmill.machine import calibrated
from patchmill.posting import kept_words
from patchmill.posting.control_match import own_dialect
from patchmill.system import memory
from patchmill.textures import strategies
from patchmill.verify import posted_milling

# of a path, while its program is made and read back: measured by tests/bench/jobs_memory_bench.py
BYTES_PER_COMMAND = 2200


def split_arguments(arguments):
    """The words of an argument string. Raises InputError naming PostProcessorArgs."""
    if not arguments.isascii():
        raise InputError("PostProcessorArgs", arguments, "programs are in ASCII letters: use no others.")
    try:
        return shlex.split(arguments)
    except ValueError as error:
        raise InputError("PostProcessorArgs", repr(arguments), "%s." % error) from error


def check_offsets(offsets):
    """Raises InputError naming Fixtures unless a job has work offsets, each of them one that a control has:
    FreeCAD offers G53 as well, which is the machine's own zero, and G59.4 to G59.9."""
    if not offsets:
        raise InputError("Fixtures", "none", "choose a work offset in the job's setup, such as G54.")
    for name in offsets:
        if not re.fullmatch(r"G5[4-9]|G59\.[123]|G54\.1 P[1-9]\d*", name.strip().upper(), re.ASCII):
            remedy = "it is no work offset of a control: choose G54 to G59.3 in the job's setup."
            raise InputError("Fixtures", name or "''", remedy)
        if [other.strip().upper() for other in offsets].count(name.strip().upper()) > 1:
            remedy = "it stands twice, and all would be milled twice at one place: name it once."
            raise InputError("Fixtures", name, remedy)


def check_preamble(words):
    """Raises InputError naming PostProcessorArgs if the first lines that a post's arguments give leave a
    state by which all that follows would be read otherwise."""
    for number, word in enumerate(words):
        name, _, text = word.partition("=")
        if not name.startswith("--prea"):
            continue
        left = kept_words.left_by(kept_words.words_of(text or "".join(words[number + 1 : number + 2])))
        if left:
            remedy = "all that follows would be read by it: take it out of the preamble."
            raise InputError("PostProcessorArgs", left, remedy)


def check_path(op):
    """Raises InputError for what stands among the operations and is none, such as a group of them."""
    if not hasattr(op, "Path"):
        raise InputError(op.Label, op.TypeId, "it has no path: take it out of the job's operations.")


def check_fixture(op):
    """Raises InputError for FreeCAD's Fixture operation, which writes its height as a word G03.5 and is
    invalid where there is no window."""
    if hasattr(op, "Fixture"):
        remedy = "work offsets are the job's: choose it in the job's setup, and take the operation out."
        raise InputError(op.Label, op.Fixture, remedy)


def check_placement(op):
    """Raises InputError naming Placement if an operation, a link to one, or one under dressups was moved:
    FreeCAD draws its path there, and posts write it where it was computed."""
    for part in (op, *posted_milling.with_those_under(op)):
        placement = getattr(part, "Placement", None)
        if placement is not None and not placement.isIdentity():
            base = placement.Base
            remedy = "%s is drawn there, and not milled there: set it to zero, and move the model."
            said = "X%g Y%g Z%g" % (base.x, base.y, base.z)
            raise InputError("Placement", said, remedy % part.Label)


def check_tools(operations):
    """Raises InputError naming ToolNumber if different tools have one number: one of them would mill both."""
    known: dict = {}
    for controller in filter(None, map(posted_milling.controller_of, operations)):
        bit = controller.Tool
        tool = host.tool_kind(bit), float(getattr(bit, "Diameter", 0.0))
        other = known.setdefault(controller.ToolNumber, (tool, controller))
        if other[0] != tool:
            remedy = "%s and %s have it, and are different tools: give one of them another number."
            raise InputError("ToolNumber", controller.ToolNumber, remedy % (other[1].Label, controller.Label))


def require_memory(operations, offsets):
    """Raises InputError naming Operations if there is no memory for their program at these offsets."""
    commands = len(offsets) * sum(op.Path.Size for op in operations)
    remedy = "post fewer patches or operations at a time (post_files)."
    memory.require(BYTES_PER_COMMAND * commands, "Operations", "%d commands" % commands, remedy)


def check_verdict(op, plan):
    """A plan that the machine cannot hold is not posted, unless the user says so. Where no machine is
    named nothing is known; the report says that."""
    verdict = plan.pacing.verdict
    if verdict is None or op.PostUnheld or verdict.holding in ("holds", "unknown"):
        return
    raise InputError(
        "SpindleSpeed",
        "%g rpm" % (60.0 * plan.input.spindle.speed),
        verdict.sentence + " Set PostUnheld to post it all the same.",
    )


def check_calibration(plan):
    """A start phase that was found with another controller, or counted from elsewhere, is not posted."""
    given = plan.input
    if plan.machine is None or given.calibrating or not given.keeps_phase.locked:
        return
    calibrated.require(plan.machine)


def require_millimetres(what, arguments):
    """Posts scale the F of inverse time, which are no lengths, and what is read back is in millimetres."""
    if "--inches" in arguments:
        raise InputError("PostProcessorArgs", "--inches", "%s is posted in millimetres." % what)


def check_arguments(post_name, plan, arguments, machine):
    """Raises InputError naming PostProcessorArgs or Decimals unless a texture is written as planned in a
    program for a machines.Machine, or for None."""
    require_millimetres("a texture", arguments)
    precision = decimals_of(post_name, arguments, machine)
    if precision != plan.input.decimals:
        raise InputError(
            "Decimals",
            plan.input.decimals,
            "the post writes %d decimals: give --precision=%d or change Decimals."
            % (precision, plan.input.decimals),
        )


def decimals_of(post_name, arguments, machine):
    """How many decimals a post writes with these arguments for a machines.Machine, or for None. Raises
    InputError naming PostProcessorArgs."""
    own = own_dialect(post_name)
    precision = own.precision(shlex.join(arguments), machine) if own else 3
    for i, argument in enumerate(arguments):
        said = argument.split("=", 1)[1] if argument.startswith("--precision=") else ""
        if argument == "--precision":
            said = arguments[i + 1] if i + 1 < len(arguments) else "none"
        if said and not re.fullmatch(r"\d\d?", said, re.ASCII):
            raise InputError("PostProcessorArgs", argument, "give a number of decimals, such as 3.")
        precision = int(said) if said else precision
    return precision


def check_post(post_name, plans, tilted):
    """A post that would lose words which the paths need is refused before it gets them. It is tried, once in
    a session; the program that it posts is read back all the same."""
    if own_dialect(post_name):
        return
    angles = [np.degrees(p.posture.work.joints) for p in plans if p.posture is not None]
    angles += [posted_milling.angles_in(dressup) for dressup in tilted]
    needs = {
        "rotary": bool(angles),
        "turning_far": any(np.abs(a).max() > 360.0 for a in angles),
        "locked": any(strategies.of(p.input.strategy).locked for p in plans),
        "inverse": any("G93" in str(p.pacing.text) for p in plans if p.posture is not None)
        or bool(tilted),
    }
    if not any(needs.values()):
        return
    missing = post_probe.missing(_probed(post_name), **needs)
    if missing:
        remedy = "%s: use one of PatchMill's own posts." % "; ".join(missing)
        raise InputError("PostProcessor", post_name, remedy)


@functools.lru_cache(maxsize=None)
def _probed(post_name):
    return post_probe.probe(host, post_name)

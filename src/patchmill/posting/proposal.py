"""How a job is best posted: the post-processor that writes for its machine's control, with the decimals
that its textures are planned for, and where the program goes.

    found = proposal.of(job)          # nothing is changed
    patchmill.post(job, found.filename, found.post, found.arguments)

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os
import re
from dataclasses import dataclass, field
from typing import Optional

import _patchmill as core
import FreeCAD

from patchmill.freecad import host, preferences
from patchmill.freecad.kinds import TEXTURE, kind_of
from patchmill.operations.computed import planned
from patchmill.machine import machines
from patchmill.posting import control_match, program_header
from patchmill.posting.control_match import own_dialect
from patchmill.textures import strategies

PACED = (strategies.LOCKED, strategies.FEED)  # their K and inverse times are lost by FreeCAD's own posts
PRECISION = re.compile(r"\s*--precision[= ]\S+")


@dataclass
class Proposal:
    """`plans`: the job's PlannedTextures; `seconds`: time of all operations and modifiers of ours;
    `machine`: the machines.Machine that the first of them names, or None."""

    post: str
    arguments: str
    filename: str
    plans: list = field(default_factory=list)
    seconds: float = 0.0
    machine: Optional[machines.Machine] = None


def of(job):
    """Proposal for a job, with its operations planned. Raises InputError where one cannot be."""
    operations = [op for op in job.Operations.Group if host.is_active(op)]
    plans = [planned(op) for op in operations if kind_of(op) == TEXTURE]
    machine = program_header.machine_of(operations)
    post = _post(job, plans, machine)
    seconds = sum(op.MachiningTime for op in operations if kind_of(op))
    return Proposal(post, arguments_for(job, plans), filename_for(job, post), plans, seconds, machine)


def _post(job, plans, machine):
    named = [m.controller["dialect"] for m in [p.machine for p in plans] + [machine] if m is not None]
    named = [dialect for dialect in named if dialect != control_match.ANY]
    if named:
        return "patchmill_" + named[0]
    if any(plan.input.strategy in PACED for plan in plans) and own_dialect(job.PostProcessor) is None:
        return "patchmill_linuxcnc"
    return job.PostProcessor or "patchmill_linuxcnc"


def arguments_for(job, plans):
    """The job's arguments, with the decimals of its plans."""
    said = job.PostProcessorArgs
    if not plans:
        return said
    return ("%s --precision=%d" % (PRECISION.sub("", said), plans[0].input.decimals)).strip()


def filename_for(job, post):
    """Beside the document, else in the folder of the last program, else at home."""
    own = own_dialect(post)
    folder = os.path.dirname(job.Document.FileName) or preferences.program_folder()
    folder = folder if os.path.isdir(folder) else FreeCAD.getHomePath()
    endings = {control["name"]: control["file_ending"] for control in core.controls()}
    return os.path.join(folder, "%s.%s" % (job.Label, endings[own.dialect] if own else "ngc"))

"""What there is to say of a program that FreeCAD's own Post command wrote with a post-processor of others:
that command compares nothing. PatchMill's own posts compare by themselves, and refuse.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from _patchmill import InputError

from patchmill import posting
from patchmill.freecad import host
from patchmill.freecad.kinds import TEXTURE, kind_of
from patchmill.posting.control_match import own_dialect
from patchmill.verify import posted_milling

NOT_COMPARED = "%s was not compared: the job has several files. Use patchmill.post_files().\n"
WRONG = "Do not run %s: %s FreeCAD's own Post command writes it all the same.\n"
UNREAD = "%s: %s was not compared (%s).\n"


def concerns(job):
    """Whether a program of this job is worth a word: it has operations of ours, and a post of others."""
    if own_dialect(job.PostProcessor) is not None:
        return False
    operations = [op for op in job.Operations.Group if host.is_active(op)]
    return any(kind_of(op) == TEXTURE or posted_milling.is_milling(op) for op in operations)


def findings(job, filename):
    """Sentences on what is wrong with, or not known of, the program of `job` in a file; none if it holds."""
    if job.SplitOutput:
        return [NOT_COMPARED % filename]
    try:
        posted = posting.read_back(job, filename)
    except InputError as error:
        return [WRONG % (filename, error)]
    return [
        UNREAD % (filename, one.operation.Label, one.unknown) for one in posted if getattr(one, "unknown", "")
    ]

"""Whether a post-processor writes for the control of the machine that a texture names: its machine file says
which control that is and how many decimals it takes.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import importlib

from _patchmill import InputError

from patchmill.verify import posted_milling

STOCK = {  # of FreeCAD's own posts, those that are for one of the controls known here
    "linuxcnc": "linuxcnc",
    "refactored_linuxcnc": "linuxcnc",
    "fanuc": "fanuc",
    "heidenhain": "heidenhain",
}
ANY = "freecad"  # a machine file that names no control


def own_dialect(post_name):
    """The post_dialect.Dialect of one of PatchMill's own posts, None for any other post."""
    if not post_name.startswith("patchmill_"):
        return None
    try:
        return importlib.import_module(post_name + "_post").DIALECT
    except ImportError as error:
        raise InputError("PostProcessor", post_name, "there is no such post-processor.") from error


def post_for(plans):
    """The post-processor of PatchMill's own for the control of the first machine that names one. Raises
    InputError naming PostProcessor if none does."""
    for plan in plans:
        dialect = plan.machine.controller["dialect"] if plan.machine is not None else ANY
        if dialect != ANY:
            return "patchmill_" + dialect
    raise InputError("PostProcessor", "''", "choose a post-processor for the job.")


def require_one_machine(operations):
    """Raises InputError naming Machine if operations, or those under them, name different machines: a program
    has the retract and the words for TCP of one."""
    named: dict = {}
    for op in operations:
        for part in posted_milling.with_those_under(op):
            name = getattr(part, "Machine", "")
            if isinstance(name, str) and name:
                named.setdefault(name, part)
    if len(named) > 1:
        (first, one), (second, other) = list(named.items())[:2]
        remedy = "%s names %s, and a program is for one machine: choose the same, or post %s by itself."
        raise InputError("Machine", second, remedy % (one.Label, first, other.Label))


def require(post_name, own_name, precision, plans):
    """Raises InputError naming PostProcessor if the post is for another control than a plan's machine has,
    and Decimals if the program would have more of them than it takes. `own_name`: the control of a post of
    PatchMill's own, or ''."""
    control = own_name or STOCK.get(post_name, "")
    for plan in plans:
        if plan.machine is None:
            continue
        wanted = plan.machine.controller["dialect"]
        if control and wanted not in (ANY, control):
            remedy = "the machine %s has the control %s: use patchmill_%s, or choose another machine."
            raise InputError("PostProcessor", post_name, remedy % (plan.machine.key, wanted, wanted))
        most = plan.machine.data["decimals"]
        if precision > most:
            remedy = "the control of the machine %s takes %d: give --precision=%d and the same Decimals."
            raise InputError("Decimals", precision, remedy % (plan.machine.key, most, most))

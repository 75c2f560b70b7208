"""One click without a window: what the command does, what the head of the panel says, and the first button of
those that help, as functions.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from functools import partial

import FreeCAD
import patchmill
from patchmill.advice import apply, assessment, cells, choice, companions, remedies, room, sides
from patchmill.operations import quick_setup

assess = assessment.with_simulation(cells.Once(patchmill.simulate))
choose = partial(choice.choose, assess)


def texture(shape, face, machine):
    """A texture operation on a face of a shape, in a new document, for a machine; no values are chosen."""
    document = FreeCAD.newDocument("oneclick")
    part = document.addObject("Part::Feature", "Part")
    part.Shape = shape
    document.recompute()
    operation = quick_setup.texture(patchmill.CurvedTexture, "Texture", part, [face])
    operation.Machine = machine
    return operation


def choose_for(operation):
    """Takes the values over that suit."""
    found = choose(operation.Proxy.texture_input(operation), apply.controller_is_free(operation))
    apply.set_fields(operation, found.fields)
    return found


def cutting(operation):
    """Feed and spindle of an operation's tool controller, as fields."""
    given = operation.Proxy.texture_input(operation)
    return {"feed": given.feed, "spindle": given.spindle}


def state_of(operation, count=3):
    """(state, Assessment or None, minutes of milling): 'good', 'short' as the head says amber or red."""
    try:
        plan = patchmill.recompute(operation)
    except patchmill.InputError:
        return "short", None, math.nan
    found = together(operation, plan, count)
    holds = plan.pacing.verdict is not None and plan.pacing.verdict.holding == "holds"
    return (
        "good" if found.good and holds else "short",
        found,
        plan.path.statistics()["timed_seconds"] / 60.0,
    )


def together(operation, plan, count=3):
    """Assessment of a PlannedTexture with those that share its faces, held against the job's model."""
    found = assess(plan.asked, count, whole=True)
    found = room.held_against(found, plan, apply.model_of(operation))
    return sides.with_others(assess, found, plan.asked, companions.inputs(operation))


def whole_quality(operation, most_area=1500.0):
    """Quality of a texture as its machine's model runs it, borders of patches and links included, but for the
    outermost rows: along them the tip leaves marks that no neighbour takes away. Of a square in its middle
    where its plane is larger than so many mm². NaN where there is no plan, or nothing but outermost rows."""
    plan = operation.Proxy.planned
    if plan is None:
        return math.nan
    places = plan.places()[plan.dimples.states == 0]
    low, high = places.min(axis=0) + plan.input.spacing, places.max(axis=0) - plan.input.spacing
    if (high <= low).any():
        return math.nan
    if (high - low).prod() > most_area:
        middle, half = 0.5 * (low + high), 0.5 * math.sqrt(most_area)
        low, high = middle - half, middle + half
    return patchmill.simulate(plan, machine=plan.machine, window=(tuple(low), tuple(high))).quality


def remedies_of(operation, fields, before=None):
    """The remedies for an operation whose values are `fields` of choose(), the best first; `before`: what
    cutting() was before them."""
    free, can_incline = apply.controller_is_free(operation), apply.can_incline(operation)
    model = apply.model_of(operation)
    finder = remedies.Finder(assess, choose, free, can_incline, fields, before, model)
    return finder.find(operation.Proxy.texture_input(operation))


def fix(operation, before=None):
    """Takes the first remedy over that was found; its kind, or ''."""
    found = remedies_of(operation, {"margin": operation.Margin.Value}, before)
    if not found:
        return ""
    apply.take(operation, found[0])
    return found[0].kind

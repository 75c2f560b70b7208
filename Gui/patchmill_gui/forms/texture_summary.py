"""Sentences about a texture, as rich text for panels: how many dimples, what is left out, how long.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import html

import _patchmill as core
from patchmill.machine.machining_time import in_words

from patchmill_gui.fields.known_sentences import translated
from patchmill_gui.fields.sentences import in_user_units
from patchmill_gui.forms.widgets import translate

THIN = "\u202f"  # narrow, and lines do not break there


def grouped(number):
    """12544 -> '12 544' with a narrow space."""
    return "{:,}".format(number).replace(",", THIN)


def table_of(rows):
    """Rich text of a table: pairs of a name, which is translated, and a value, in the user's units."""
    row = "<tr><td>%s </td><td><b>%s</b></td></tr>"
    made = (
        row % (html.escape(translate("PatchMill", name)), html.escape(in_user_units(value)))
        for name, value in rows
    )
    return "<table>%s</table>" % "".join(made)


def _counts(counts):
    colours = core.state_colours()
    parts = [
        '<span style="color:rgb(%d,%d,%d)">\u25a0</span>&nbsp;%s:&nbsp;%s'
        % (*colours[name], translate("PatchMill", name), grouped(number))
        for name, number in counts.items()
        if number
    ]
    return "<br>".join(parts)


def placed_summary(placed):
    """Of a PlacedTexture."""
    counts = dict(placed.dimples.counts())
    patches = len(placed.free or placed.division)
    head = translate("PatchMill", "{} dimples in {} patches")
    if patches == 1:
        head = translate("PatchMill", "{} dimples in one patch")
    head = head.format(grouped(counts["cut"]), grouped(patches))
    remarks = [html.escape(in_user_units(translated(remark))) for remark in placed.remarks]
    lines = ["<b>%s</b>" % head, _counts(counts), *remarks]
    return "<br>".join(lines)


def planned_summary(planned):
    """Of a PlannedTexture: the above, and what the timing gives."""
    statistics = planned.path.statistics()
    turns = statistics["cut_turns"] / max(1, planned.counts["cut"])
    lines = [
        placed_summary(planned),
        translate("PatchMill", "{} of milling, {:.2f} turns per dimple").format(
            in_words(planned.seconds), turns
        ),
    ]
    if planned.pacing.verdict is not None:
        lines.append(html.escape(planned.pacing.verdict.sentence))
    return "<br>".join(lines)

"""Panel that checks the path of an operation or modifier for gouges and collisions, and shows where they are.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from patchmill.verify import checks
from pivy import coin

from patchmill_gui.forms.widgets import DOUBT_COLOUR, ERROR_COLOUR, GOOD_COLOUR, noticed, translate
from patchmill_gui.views.own_view import scene_of
from patchmill_gui.views.play_scene import mark
from patchmill_gui.work.work_panel import WorkPanel

MARKS = 200  # findings that are shown in the view


class CheckPanel(WorkPanel):
    """Task panel for an operation or modifier; the check starts at once."""

    ICON = "PatchMill_Check"

    def __init__(self, operation):
        given = checks.check_input(operation)
        super().__init__(translate("PatchMill", "Check {}").format(operation.Label), operation)
        self.root = scene_of(operation)
        self.marks = coin.SoSeparator()
        self.root.addChild(self.marks)
        self.add_progress()
        self.text.setText(translate("PatchMill", "Checking …"))
        self.bar.begin()
        self.work.start(lambda progress: checks.run_check(given, progress=progress))

    def show_result(self, result):
        self.result = result
        self.bar.hide()
        self.text.setText(verdict(result))
        for finding in deepest(result):
            self.marks.addChild(mark(finding.place, 0.5 if finding is not result.worst else 1.0))

    def leave(self):
        super().leave()
        self.root.removeChild(self.marks)


def verdict(result):
    """Rich text of what a CheckResult says, on green, amber or red."""
    colour = {checks.CLEAR: GOOD_COLOUR, checks.UNKNOWN: DOUBT_COLOUR}.get(result.outcome, ERROR_COLOUR)
    return "<b>%s</b>" % noticed(result.sentence, colour)


def deepest(result):
    """The Findings of a CheckResult that are marked in the view, the deepest first."""
    return sorted(result.findings, key=lambda f: -f.depth)[:MARKS]

"""Panel that writes the report of a texture: posts the job, which FreeCAD does in the GUI thread, and then
simulates, draws and writes in the background.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import html
import os

import patchmill
from _patchmill import InputError
from patchmill.freecad import host
from patchmill.operations.texture_operation import planned
from PySide import QtCore

from patchmill_gui.forms.widgets import busy_cursor, translate
from patchmill_gui.work.work_panel import WorkPanel


def report_work(operation, folder):
    """Posts the operation's job into `folder`; returns the function of (progress) that writes the report and
    gives the names of all files, or None if it was stopped. Raises InputError."""
    plan = planned(operation)
    job = host.PathUtils.findParentJob(operation)
    gcode = os.path.join(folder, operation.Name + ".ngc")
    with busy_cursor():
        (posted,) = [p for p in patchmill.post(job, gcode) if p.operation is operation]

    def work(progress):
        simulated = patchmill.simulate(plan, path=posted.path, progress=progress)
        if simulated is None:
            return None
        return [gcode] + patchmill.write_report(posted, plan, gcode, folder, simulated)

    return work


class ReportPanel(WorkPanel):
    """Task panel; starts at once. `result`: the names of the files."""

    ICON = "PatchMill_Report"

    def __init__(self, operation, folder):
        super().__init__(translate("PatchMill", "Report"), operation)
        self.text.setOpenExternalLinks(True)
        self.add_progress()
        try:
            work = report_work(operation, folder)
        except InputError as error:
            self.show_error(error)
        else:
            self.text.setText(translate("PatchMill", "Simulating and drawing …"))
            self.bar.begin()
            self.work.start(work)

    def show_result(self, files):
        self.result = files
        self.bar.hide()
        (page,) = [name for name in files if name.endswith(".html")]
        url = QtCore.QUrl.fromLocalFile(page).toString()
        link = '<a href="%s">%s</a>' % (html.escape(url), translate("PatchMill", "Open the report"))
        rest = "<br>".join(html.escape(os.path.basename(name)) for name in files)
        self.text.setText("%s<br>%s" % (link, rest))

"""Pictures of every panel and window in each look: light, dark, German, Japanese, inches, small, large. A
look is some pictures of panels side by side; what is written with too little contrast or cut off is told.

    tests/gui/run_gui tests/gui/screens.py FOLDER [LOOK ...]
    QT_SCALE_FACTOR=1.75 PATCHMILL_GUI_SCREEN=1920x1080 tests/gui/run_gui tests/gui/screens.py FOLDER light

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import gc
import os
import sys
import tempfile

import driver
import eyes
import FreeCAD
import FreeCADGui
import Part
from patchmill_gui.forms import machine_editor, post_dialog
from patchmill_gui.panels.report_panel import ReportPanel
from patchmill_gui.work.work_panel import WorkPanel
from PySide import QtCore, QtGui

GAP, WIDEST, BESIDE = 8, 700, 4  # pixels; panels in a picture
SIZES = {"small": (1024, 768), "large": (1920, 1080)}
LANGUAGES = {"german": "German", "japanese": "Japanese"}
LOOKS = ("light", "dark", "german", "japanese", "inches", "small", "large")
THREAD = {
    "Machine": "four-axis-mill",
    "Strategy": "Spindle-locked",
    "ToolAxisMode": "Normal",
    "Order": "Thread",
}
TEXTURES = ("CurvedTexture", "PlanarTexture", "PyramidTexture", "CalibrationPatch")


def put_on(look):
    """Makes FreeCAD look so."""
    sheet = ""
    if look == "dark":
        sheets = os.path.join(FreeCAD.getResourceDir(), "Gui", "Stylesheets")
        QtCore.QDir.setSearchPaths("qss", [sheets])
        with open(os.path.join(sheets, "ProDark.qss"), encoding="utf-8") as file:
            sheet = file.read()
    QtGui.QApplication.instance().setStyleSheet(sheet)
    FreeCADGui.setLocale(LANGUAGES.get(look, "English"))
    FreeCAD.Units.setSchema(3 if look == "inches" else 0)
    window = FreeCADGui.getMainWindow()
    window.showNormal()
    window.resize(*SIZES.get(look, (1600, 1000)))
    driver.rest(1.0)


class Sheet:
    """The pictures of one look."""

    def __init__(self, folder, look):
        self.folder, self.look = folder, look
        self.pictures, self.saved = [], 0

    def take(self, title, widget):
        """A widget's picture, and a line for each sentence of it that is hard to read."""
        self.pictures.append(eyes.settled(widget))
        for said, ratio in eyes.faint(widget):
            print("%s, %s: contrast %.1f: %s" % (self.look, title, ratio, said), flush=True)
        for said, lacks in eyes.clipped(widget):
            print("%s, %s: %d pixels too narrow: %s" % (self.look, title, lacks, said), flush=True)
        for said in eyes.without_buddy(widget):
            print("%s, %s: an ampersand is shown: %s" % (self.look, title, said), flush=True)
        if len(self.pictures) == BESIDE:
            self.save()

    def save(self):
        """What was taken since the last time."""
        shots, self.pictures = self.pictures, []
        if not shots:
            return
        self.saved += 1
        name = os.path.join(self.folder, "screens_%s_%d.png" % (self.look, self.saved))
        width = sum(min(p.width(), WIDEST) + GAP for p in shots)
        height = max(p.height() for p in shots)
        image = QtGui.QImage(width, height, QtGui.QImage.Format_RGB32)
        image.fill(QtCore.Qt.magenta)
        painter, x = QtGui.QPainter(image), 0
        for each in shots:
            painter.drawImage(x, 0, each)
            x += min(each.width(), WIDEST) + GAP
        painter.end()
        image.save(name)
        print(name, flush=True)


def dock():
    return driver.task_dock()


def textures(sheet, part):
    """The panels of new textures; the operation that is kept."""
    for name in TEXTURES:
        operation, panel = driver.begin_texture(part, "PatchMill_" + name)
        if name == TEXTURES[0]:  # what the head says then is seen once
            driver.wait(lambda: not panel.advising.assessing.busy, 200)
            driver.rest(0.5)
            driver.wait(lambda: not panel.advising.helping.busy, 200)
        sheet.take(name, dock())
        if name == TEXTURES[0]:
            panel.page.advanced.heading.setChecked(True)
            for group in panel.page.properties.groups.values():
                group.heading.setChecked(True)
            driver.rest(0.3)
            sheet.take(name + ", all", panel.page.form)
            panel.page.advanced.heading.setChecked(False)
            driver.set_quantity(panel, "Spacing", 4.0)
            driver.wait(lambda: panel.error is not None)
            sheet.take(name + ", refused", dock())
            driver.set_quantity(panel, "Spacing", 0.5)
            driver.wait(lambda: panel.error is None and panel.ready_now(), 240)
            driver.accept(panel)
            kept = operation
            continue
        if name == "PlanarTexture":
            form = panel.page.properties.rows["Form"].editor
            form.setCurrentIndex(form.findData("Free"))
            driver.ready(panel)
            panel.page.advice.ask()
            sheet.take(name + ", free form", panel.page.form)
        panel.reject()
    return kept


def open_panel():
    """The WorkPanel that is shown."""
    (panel,) = [o for o in gc.get_objects() if isinstance(o, WorkPanel) and o._is_open()]
    return panel


def done(panel):
    """Waits until what a panel computes is there."""
    driver.wait(lambda: panel.result is not None or panel.error is not None, 200)


def opened(sheet, operation):
    """What is opened on a texture."""
    for command in ("PatchMill_Simulate", "PatchMill_Check", "PatchMill_Play"):
        driver.run_on(operation, command)
        panel = open_panel()
        if command == "PatchMill_Simulate":
            panel.size.setValue(2.0)
            panel.button.click()
        done(panel)
        sheet.take(command, dock())
        FreeCADGui.Control.closeDialog()
    with tempfile.TemporaryDirectory() as folder:
        panel = ReportPanel(operation, folder)
        FreeCADGui.Control.showDialog(panel)
        done(panel)
        sheet.take("Report", dock())
        FreeCADGui.Control.closeDialog()
    for title, window in (
        ("Post", post_dialog.show(operation.Document.getObject("Job"))),
        ("Machines", machine_editor.show("table-table-ac")),
    ):
        sheet.take(title, window)
        window.close()


def milling(sheet, part):
    driver.run_on(part, "PatchMill_CopyMilling")
    operation = part.Document.getObject("CopyMilling")
    panel = driver.panel_of(operation)
    panel.form_rows.rows["AxialDepth"].editor.setProperty("rawValue", 4.0)
    panel.compute(False)
    done(panel)
    sheet.take("CopyMilling", dock())
    driver.accept(panel)
    driver.run_on(operation, "PatchMill_Simulate")
    done(open_panel())
    sheet.take("What it leaves", dock())
    FreeCADGui.Control.closeDialog()
    driver.run_on(operation, "PatchMill_DressupDcm")
    panel = part.Document.getObject("DressupDCM").ViewObject.Proxy.panel
    for group in panel.form_rows.groups.values():
        group.heading.setChecked(True)
    panel.what.setCurrentIndex(panel.what.findData("force"))
    done(panel)
    sheet.take("DCM", dock())
    sheet.take("DCM, all", panel.form)
    panel.reject()


def thread(sheet):
    """A roller's panel."""
    shape = Part.makeCylinder(6, 4, FreeCAD.Vector(), FreeCAD.Vector(1, 0, 0))
    document, part = driver.new_document(shape)
    face = next(n for n, f in enumerate(shape.Faces, 1) if f.Surface.TypeId == "Part::GeomCylinder")
    driver.select(part, "Face%d" % face)
    FreeCADGui.runCommand("PatchMill_CurvedTexture")
    operation = document.getObject("CurvedTexture")
    panel = driver.panel_of(operation)
    driver.ready(panel)
    rows = panel.page.properties.rows
    for name, choice in THREAD.items():
        rows[name].editor.setCurrentIndex(rows[name].editor.findData(choice))
    driver.ready(panel)
    driver.wait(lambda: not panel.advising.assessing.busy, 200)
    panel.page.advanced.heading.setChecked(True)
    sheet.take("Thread", dock())
    box = panel.page.form.findChild(QtGui.QPushButton, "FindSpeed").parent()
    box.look()
    driver.wait(lambda: not box.work.busy, 100)
    sheet.take("Thread, all", panel.page.form)
    panel.reject()
    FreeCAD.closeDocument(document.Name)


def preferences(sheet):
    def shoot():
        for widget in QtGui.QApplication.topLevelWidgets():
            if isinstance(widget, QtGui.QDialog) and widget.isVisible():
                sheet.take("Preferences", widget)
                widget.reject()

    QtCore.QTimer.singleShot(500, shoot)
    FreeCADGui.showPreferences("PatchMill", 0)


def main():
    folder, looks = sys.argv[1], sys.argv[2:] or LOOKS
    for look in looks:
        put_on(look)
        document, part = driver.new_document(driver.wavy_block(6.0, 4.0))
        sheet = Sheet(folder, look)
        kept = textures(sheet, part)
        opened(sheet, kept)
        milling(sheet, part)
        preferences(sheet)
        FreeCAD.closeDocument(document.Name)
        thread(sheet)
        sheet.save()
    return 0

"""The pictures of the workbench in docs/images, taken from a real FreeCAD:

    tests/gui/run_gui docs/images/gui_pictures.py

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import os

import driver
import FreeCAD
import FreeCADGui
import Part
from _patchmill import DimpleState
from patchmill.freecad.preferences import remember_machine
from patchmill_gui.forms import machine_editor, resources
from patchmill_gui.panels import texture_head
from pivy import coin
from PySide import QtCore, QtGui

FOLDER = os.path.join(os.environ["PATCHMILL_GUI_ROOT"], "docs", "images")
WIDTH, QUALITY = 1200, 88  # pixels, per cent


def picture(name, seconds=1.0):
    """The whole screen, when it has come to rest."""
    driver.rest(seconds)
    shot = QtGui.QApplication.primaryScreen().grabWindow(0)
    save(shot.scaledToWidth(WIDTH, QtCore.Qt.SmoothTransformation), name)


def save(pixmap, name):
    pixmap.save(os.path.join(FOLDER, "gui_%s.jpg" % name), "JPG", QUALITY)
    print("gui_%s.jpg" % name, flush=True)


def look_at(point, height, direction=(0.55, -0.6, 0.58)):
    """The camera on a point [mm], with so much of the part in the view's height [mm]."""
    camera = FreeCADGui.activeDocument().activeView().getCameraNode()
    FreeCADGui.activeDocument().activeView().setCameraType("Orthographic")
    camera = FreeCADGui.activeDocument().activeView().getCameraNode()
    towards = coin.SbVec3f(*direction)
    towards.normalize()
    target = coin.SbVec3f(*(float(c) for c in point))
    camera.position.setValue(target + towards * 200.0)
    camera.pointAt(target, coin.SbVec3f(0, 0, 1))
    camera.focalDistance = 200.0
    camera.height = height


def begin(command, part, face, name):
    driver.select(part, face)
    FreeCADGui.runCommand(command)
    operation = FreeCAD.ActiveDocument.getObject(name)
    return operation, driver.panel_of(operation)


def block():
    """The part of the paper, its textured face, and the middle of that."""
    shape = Part.read(resources.path("recipes", "xu2016", "block.step"))
    document, part = driver.new_document(shape, "Block")
    FreeCADGui.getMainWindow().showMaximized()
    look_at((0, 0, 20), 75.0)
    return document, part, driver.top_face(shape)


def textures():
    document, part, face = block()
    driver.select(part, face)
    picture("1_face_selected")
    operation, panel = begin("PatchMill_CurvedTexture", part, face, "CurvedTexture")
    head = panel.advising.head
    assert driver.wait(lambda: head.buttons, 900)
    picture("2_curved_panel")
    head.buttons[0].click()
    assert driver.wait(lambda: head.state == texture_head.GREEN, 900), head.bar.text()
    assert driver.ready(panel)
    picture("2_fixed")
    panel.page.previews["order"].setChecked(True)
    panel.page.previews["axes"].setChecked(True)
    driver.rest(2.0)
    dimples = panel.ready.planned.dimples
    places = dimples.positions[dimples.states == DimpleState.CUT]  # the part is inclined now
    middle = places.mean(axis=0)
    look_at(places[((places - middle) ** 2).sum(axis=1).argmin()], 16.0)
    picture("3_order_and_axes")
    driver.accept(panel)
    look_at(middle, 75.0)
    operation.ViewObject.Show = "Tool path"
    picture("4_tool_path")
    operation.ViewObject.Show = "Dimples"
    simulated(operation)
    played(operation)
    checked(operation)
    operation.ViewObject.Visibility = False
    for command, name in (
        ("PatchMill_PyramidTexture", "PyramidTexture"),
        ("PatchMill_CalibrationPatch", "CalibrationPatch"),
    ):
        _, panel = begin(command, part, face, name)
        driver.ready(panel)
        picture("8_" + name.lower())
        panel.reject()
        driver.wait(lambda: not driver.panel_open())
    planar(part, face)
    FreeCAD.closeDocument(document.Name)


def planar(part, face):
    operation, panel = begin("PatchMill_PlanarTexture", part, face, "PlanarTexture")
    panel.page.properties.rows["Form"].editor.setCurrentText("Free")
    driver.ready(panel)
    panel.page.advice.ask()
    picture("8_planartexture")
    panel.reject()
    driver.wait(lambda: not driver.panel_open())


def simulated(operation):
    from patchmill_gui.panels.simulate_panel import SimulatePanel

    FreeCADGui.Selection.clearSelection()
    panel = SimulatePanel(operation)
    FreeCADGui.Control.showDialog(panel)
    panel.size.setValue(8.0)
    panel.simulate()
    assert driver.wait(lambda: panel.result is not None or panel.error is not None)
    points, _ = panel.result.surface(stride=10)
    middle = points.reshape(-1, 3)[~(points != points).any(axis=2).ravel()].mean(axis=0)
    look_at(middle, 8.0, (0.3, -0.5, 0.8))
    picture("5_relief", 2.0)
    panel.reject()
    operation.ViewObject.Show = "Dimples"


def played(operation):
    from patchmill_gui.panels.player import PlayerPanel

    panel = PlayerPanel(operation, operation.Proxy.planned.path)
    FreeCADGui.Control.showDialog(panel)
    panel.slider.setValue(30000)
    look_at(panel.tool.pose.translation.getValue().getValue(), 30.0, (0.6, -0.7, 0.4))
    picture("6_player")
    panel.reject()


def checked(operation):
    from patchmill_gui.panels.check_panel import CheckPanel

    panel = CheckPanel(operation)
    FreeCADGui.Control.showDialog(panel)
    look_at((0, 0, 20), 75.0)
    driver.wait(lambda: panel.result is not None or panel.error is not None, 300)
    picture("7_check")
    panel.reject()


def milling():
    document, part, _ = block()
    driver.run_on(part, "PatchMill_CopyMilling")
    operation = document.getObject("CopyMilling")
    panel = driver.panel_of(operation)
    panel.form_rows.rows["AxialDepth"].editor.setProperty("rawValue", 4.0)
    panel.box.button.click()
    driver.wait(lambda: panel.result is not None or panel.error is not None)
    picture("9_copy_milling")
    driver.accept(panel)
    driver.run_on(operation, "PatchMill_DressupDcm")
    dressup = document.getObject("DressupDCM")
    panel = dressup.ViewObject.Proxy.panel
    panel.form_rows.rows["VoxelSize"].editor.setProperty("rawValue", 0.8)
    panel.box.button.click()
    driver.wait(lambda: panel.result is not None or panel.error is not None)
    dressup.ViewObject.Proxy.scene.parts.switch("path", False)
    part.ViewObject.Visibility = False
    panel.form_rows.groups["DCM"].heading.setChecked(False)
    picture("10_dcm_slice")
    panel.reject()
    FreeCAD.closeDocument(document.Name)


def preferences():
    def shoot():
        for widget in QtGui.QApplication.topLevelWidgets():
            if isinstance(widget, QtGui.QDialog) and widget.isVisible():
                save(widget.grab(), "11_preferences")
                widget.reject()

    QtCore.QTimer.singleShot(150, shoot)
    FreeCADGui.showPreferences("PatchMill", 0)


def machine():
    window = machine_editor.show("table-table-ac")
    driver.rest(0.5)
    save(window.grab(), "12_machines")
    window.close()


def main():
    remember_machine("linuxcnc-mill")
    textures()
    milling()
    preferences()
    machine()
    return 0

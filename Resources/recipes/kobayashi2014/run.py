"""The two experiments of Kobayashi & Shirase 2014, Tables 1 and 2: feed over a smooth convex part, posture
over an overhanging one, each with the staircase of the paper's 2 mm voxels and with the fields interpolated.

    tools/freecad Resources/recipes/kobayashi2014/run.py out

Leaves figures like the paper's 8, 9, 12 and 13, and steps.json: the largest feed step and axis step
between moves, both ways.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import json
import math
import os
import sys

import FreeCAD
import matplotlib
import numpy as np

matplotlib.use("Agg")
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import make_parts  # noqa: E402
import matplotlib.pyplot as plt  # noqa: E402
import patchmill  # noqa: E402
from patchmill import CopyMilling, DressupDCM  # noqa: E402
from patchmill.freecad import host  # noqa: E402
from patchmill.modifiers import dcm  # noqa: E402
from patchmill.reports import dcm_plots  # noqa: E402
from patchmill.voxels import removal_model  # noqa: E402

VOXEL, DEPTH, LOW, HIGH = 2.0, 2.0, 400.0 / 60.0, 800.0 / 60.0
SECTIONS = (10, 20, 30, 40)


def job_of(shape, stock, feed, speed, name):
    """A job with a ball end mill of 6 mm and a box as stock; (document, job)."""
    document = FreeCAD.newDocument(name)
    part = document.addObject("Part::Feature", name)
    part.Shape = shape
    document.recompute()
    job = host.create_job("Job", [part])
    host.add_ball_end_controller(job, 6.0, 2, feed, speed)
    box = document.addObject("Part::Box", "StockBox")
    box.Length, box.Width, box.Height = stock
    job.Stock = box
    document.recompute()
    return document, job


def copy_and_dress(job, mode, controls):
    """A CopyMilling of the paper's depths and a DressupDCM on it: (operation, dressup)."""
    operation = CopyMilling.Create("CopyMilling", parentJob=job)
    operation.Mode, operation.RadialDepth, operation.AxialDepth = mode, DEPTH, DEPTH
    CopyMilling.recompute(operation)
    dressup = DressupDCM.Create("DressupDCM", operation)
    dressup.Controls, dressup.VoxelSize, dressup.ReadAt = controls, VOXEL, "Tip"
    dressup.FeedAtProduct, dressup.FeedAtSkin = LOW, HIGH
    dressup.KeepPlunges = False
    return operation, dressup


def both_ways(dressup):
    """(RemovalModel, {reading: Controlled})."""
    found = {}
    for reading in ("Staircase", "Smooth"):
        dressup.Reading = reading
        given = dcm.input_of(dressup)
        model = removal_model.make(given.model)
        found[reading] = dcm.control(given, model)
    return model, found


def pass_table(path, y, tolerance=1e-6):
    """The cuts in the plane y as dcm_plots takes them: run, s, z, feed [mm/min], b [degrees], x."""
    tips = np.vstack([np.array(path.start)[None], path.tips])
    axes = np.vstack([path.axes[:1], path.axes])
    centre = tips + path.tool.radius * axes
    length = np.linalg.norm(np.diff(centre, axis=0), axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        feed = np.where(path.turns > 0, 60.0 * length * path.spindle.speed / path.turns, 0.0)
    rows, run, s, lifted = [], 0, 0.0, True
    b = np.degrees(np.arctan2(axes[:, 0], axes[:, 2]))
    for i in range(len(length)):
        off = max(abs(centre[i, 1] - y), abs(centre[i + 1, 1] - y))
        if path.kinds[i] != 2 or off > tolerance:
            lifted = True
            continue
        if lifted:
            run += 1
            rows.append((run, s, centre[i, 2], feed[i], b[i], centre[i, 0]))
        lifted = False
        s += length[i]
        rows.append((run, s, centre[i + 1, 2], feed[i], b[i + 1], centre[i + 1, 0]))
    names = ["run", "s", "z", "feed", "b", "x"]
    return np.array(rows, dtype=[(n, float) for n in names])


def steps_of(found):
    """The largest steps between moves, both ways, in mm/min and degrees."""
    out = {}
    for reading, made in found.items():
        steps = patchmill.dcm.core.path_steps(made.path)
        out[reading] = {
            "moves": steps["moves"],
            "feed_step_mm_min": round(60.0 * steps["feed"], 2),
            "feed_step_at_corners_mm_min": round(60.0 * steps["feed_at_corners"], 2),
            "axis_step_degrees": round(
                math.degrees(max(steps["axis_at_rest"], steps["axis_per_move"])), 3
            ),
            "seconds": round(made.path.statistics()["timed_seconds"], 1),
            "seconds_before": round(made.planned.statistics()["timed_seconds"], 1),
        }
    return out


def section_axes(axes, section, values, low, high, colours="viridis"):
    rows, columns = section["kind"].shape
    x = section["origin"][0] + section["pitch"] * (np.arange(columns) + 0.5)
    z = section["origin"][1] + section["pitch"] * (np.arange(rows) + 0.5)
    x, z = np.meshgrid(x, z)
    flat = (x.ravel(), z.ravel(), section["kind"].ravel(), np.nan_to_num(values.ravel()))
    return dcm_plots.plot_section(axes, *flat, low, high, colours)


def feed_experiment(folder, mode, figures):
    """Table 1: the feed over the smooth convex part, in one of the two modes; returns its steps."""
    stock = (50, 50, 36)
    document, job = job_of(make_parts.convex_part(), stock, 400.0, 6000.0, "Convex")
    operation, dressup = copy_and_dress(job, mode, "Feed")
    model, found = both_ways(dressup)
    if figures:
        figure, axes = plt.subplots(figsize=(7.2, 4.6), constrained_layout=True)
        section = model.grid.section(1, 24.0, model.feed(LOW, HIGH), (1, 0, 0))
        mesh = section_axes(axes, section, 60.0 * section["feed"], 400, 800)
        figure.colorbar(mesh, ax=axes, label="feed along x [mm/min]", shrink=0.8)
        axes.set_title("Feed field $V_x$ at Y = 24 mm; dots: voxels with product surface")
        dcm_plots.save(plt, figure, folder, "fig08_feed_section.png")
        stairs, smooth = (pass_table(found[k].path, 24.0) for k in ("Staircase", "Smooth"))
        figure, (whole, part) = plt.subplots(2, 1, figsize=(8.4, 6.4), constrained_layout=True)
        end = smooth["s"][-1]
        dcm_plots.plot_pass(whole, stairs, smooth, "feed", "feed [mm/min]")
        dcm_plots.plot_pass(part, stairs, smooth, "feed", "feed [mm/min]", 0.62 * end, 0.74 * end)
        dcm_plots.head(whole, "Feed along all layers at Y = 24 mm", legend=True)
        dcm_plots.head(part, "A part of it")
        for axes in (whole, part):
            axes.set_ylim(380, 820)
        dcm_plots.save(plt, figure, folder, "fig09_feed_pass.png")
    FreeCAD.closeDocument(document.Name)
    return steps_of(found)


def posture_experiment(folder):
    """Table 2: the posture over the overhanging part; returns its steps."""
    stock = (76, 50, 40)
    document, job = job_of(make_parts.overhanging_part(), stock, 4000.0, 9000.0, "Overhanging")
    operation, dressup = copy_and_dress(job, "Scanning with undercuts", "Posture")
    dressup.ReadAt = "Ball centre"  # below an overhang the tip of an upright tool is within the part
    model, found = both_ways(dressup)
    figure, grid = plt.subplots(2, 2, figsize=(9.6, 5.8), constrained_layout=True)
    for axes, y in zip(grid.flat, SECTIONS):
        section = model.grid.section(1, y, None, (1, 0, 0), model.posture)
        b = np.degrees(np.arctan2(section["axis"][..., 0], section["axis"][..., 2]))
        mesh = section_axes(axes, section, b, -70, 70, "RdBu_r")
        axes.set_title("Y = %d mm" % y)
    figure.colorbar(mesh, ax=grid, label="posture about y [degrees]", shrink=0.8)
    dcm_plots.save(plt, figure, folder, "fig12_posture_section.png")
    figure, grid = plt.subplots(2, 2, figsize=(10.4, 6.6), constrained_layout=True)
    for axes, y in zip(grid.flat, SECTIONS):
        stairs, smooth = (pass_table(found[k].path, y) for k in ("Staircase", "Smooth"))
        dcm_plots.plot_pass(axes, stairs, smooth, "b", "B [degrees]", *dcm_plots.last_run(smooth))
        dcm_plots.head(axes, "Finishing, Y = %d mm" % y, legend=axes is grid[0, 0])
    dcm_plots.save(plt, figure, folder, "fig13_posture_pass.png")
    FreeCAD.closeDocument(document.Name)
    return steps_of(found)


def run(folder, say=print):
    """Both experiments; writes the figures and steps.json to `folder` and returns the steps."""
    os.makedirs(folder, exist_ok=True)
    steps = {
        "feed, scanning lines": feed_experiment(folder, "Scanning", True),
        "feed, contour lines": feed_experiment(folder, "Contour", False),
        "posture, scanning lines": posture_experiment(folder),
    }
    with open(os.path.join(folder, "steps.json"), "w", encoding="utf-8") as file:
        json.dump(steps, file, indent=2)
    for name, ways in steps.items():
        for reading, numbers in ways.items():
            say("%s, %s: %s" % (name, reading, numbers))
    return steps


if __name__ == "__main__":
    run(sys.argv[1])

"""A thread as a machine mills it: the tool stands beside the rotary axis so that its lead is the one asked
for, the table turns, and one linear axis feeds along the cylinder, all in a single straight move.

    q_k = 2 pi k / nu,  x_k = x_0 + v k        of tooth pass k, nu dimples in a turn
    G33 X A K                                  K = N v mm in a turn of the spindle with N teeth

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math
from dataclasses import dataclass
from typing import Any

import _patchmill as core
import numpy as np
from _patchmill import InputError

ON_AXIS = 1e-3  # mm, from the rotary axis to the cylinder's
PARALLEL = 1e-6
CLEAR = 0.1  # mm of way beside the end of the cylinder before the tool touches it
LEAD_UNIT = 1e-6  # mm: FreeCAD's paths have K in six decimals
UP = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True)
class Turning:
    """The move that mills a thread, as the controller is told it without TCP: programmed points `start` and
    `end` [mm], the rotary axis from 0 to `angle` [rad], `lead` in a turn of the spindle [mm]."""

    lattice: Any  # lattice.ThreadLattice
    cylinder: Any  # cylinder.Cylinder
    kinematics: core.Kinematics
    along: np.ndarray  # unit direction of the rotary axis
    origin: np.ndarray  # point on it in the work frame [mm]
    contact: np.ndarray  # unit normal where the tool touches, as the machine stands
    start: np.ndarray
    end: np.ndarray
    angle: float
    lead: float
    teeth: int

    @property
    def turns(self):
        """Of the spindle."""
        return float(np.linalg.norm(self.end - self.start)) / self.lead

    def places(self):
        """(positions on the cylinder [mm], unit normals, places along its axis [mm]) of all tooth passes,
        from the start of the move."""
        passes = np.arange(int(self.turns * self.teeth) + 1)
        share = passes / (self.turns * self.teeth)
        normals = _turned(self.contact, self.along, -self.angle * share)
        along = (self.start - self.origin) @ self.along + share * self.turns * self.lead
        positions = self.origin + along[:, None] * self.along + self.cylinder.radius * normals
        return positions, normals, along

    def poses(self, start, end, angles, share):
        """(tips, axes) in the work frame, (n, 3) each, on a move between two programmed points and angles
        [mm, rad] at `share` (n,) of it."""
        told = np.asarray(start) + share[:, None] * (np.asarray(end) - start)
        joints = [[angles[0] + s * (angles[1] - angles[0]), 0.0] for s in share]
        tips = [self.kinematics.in_work_frame(point, q) for point, q in zip(told, joints)]
        return np.array(tips).reshape(-1, 3), np.array([self.kinematics.tool_axis(q) for q in joints])


def turning(given, cylinder, lattice, machine, sunk):
    """The Turning of a cylinder on `machine` (a machines.Machine) with a TextureInput's tool and lead;
    `sunk`: how deep below it the dimples' bottoms lie [mm]. Raises InputError naming Machine, Base, Lead or
    SpindleSpeed."""
    axis = _one_axis(machine)
    form = core.ProgramForm(False, "tip", 1e-3, 0.0)
    kinematics = core.with_tool(machine.kinematics, 0.0, form, given.tool)
    along = np.array(axis["direction"], float)
    along /= np.linalg.norm(along)
    origin = np.array(axis["point_mm"], float) - machine.data.get("work_zero_mm", (0.0, 0.0, 0.0))
    _require_on_axis(cylinder, along, origin, axis["letter"])
    ends = np.sort((cylinder.point - origin) @ along + np.array([cylinder.low, cylinder.high])
                   * np.sign(cylinder.direction @ along))  # fmt: skip
    lean = math.radians(given.lead)
    if not abs(given.lead) < 90.0:
        raise InputError("Lead", "%g degrees" % given.lead, "give less than 90 degrees.")
    contact = math.cos(lean) * UP - math.sin(lean) * np.cross(UP, along)
    teeth = given.tool.flutes
    lead = round(lattice.up * teeth / LEAD_UNIT) * LEAD_UNIT
    rising = lattice.with_lead(lead, teeth)
    radius = given.tool.radius
    from_axis = cylinder.radius + radius - sunk
    beside = _beside(radius, sunk, lattice.spacing)
    start = origin + (ends[0] - beside) * along + from_axis * contact - radius * UP
    start = np.round(start, given.decimals)
    passes = math.ceil((ends[1] - ends[0] + 2.0 * beside) / rising.up)
    end = np.round(start + passes * rising.up * along, given.decimals)
    turns = float(np.linalg.norm(end - start)) / lead
    degrees = round(360.0 * turns * teeth / rising.round, given.decimals)
    made = Turning(
        rising, cylinder, kinematics, along, origin, contact, start, end, math.radians(degrees), lead, teeth
    )
    _require_in_reach(made, given.spindle, axis, machine)
    return made


def _one_axis(machine):
    """The rotary axis of the machine's file. Raises InputError naming Machine unless it is one table across
    the spindle, along a linear axis."""
    axes = machine.data.get("rotary_axes", [])
    good = len(axes) == 1 and axes[0]["side"] == "table"
    if good:
        direction = np.array(axes[0]["direction"], float)
        direction /= np.linalg.norm(direction)
        good = abs(direction[2]) < PARALLEL and max(abs(direction)) > 1.0 - PARALLEL
    if not good:
        remedy = "a thread needs one rotary table along X or Y and no other, as four-axis-mill has."
        raise InputError("Machine", machine.key, remedy)
    return axes[0]


def _require_on_axis(cylinder, along, origin, letter):
    across = np.cross(cylinder.direction, along)
    if np.linalg.norm(across) > PARALLEL:
        turned = math.degrees(math.asin(min(1.0, float(np.linalg.norm(across)))))
        remedy = "it is to lie along the rotary axis %s: turn the job's model." % letter
        raise InputError("Base", "a cylinder turned by %.3g degrees" % turned, remedy)
    beside = float(np.linalg.norm(np.cross(cylinder.point - origin, along)))
    if beside > ON_AXIS:
        remedy = (
            "its axis is to be the rotary axis %s, which goes through (%.4g, %.4g, %.4g) mm of the work: "
            "move the job's model, or tell the machine file's work_zero_mm." % (letter, *origin)
        )
        raise InputError("Base", "a cylinder %.4g mm beside the axis" % beside, remedy)


def _beside(radius, sunk, spacing):
    """How far from the end of the cylinder the ball is clear of the stock [mm]: the uncut surface stands over
    the dimples' bottoms by no more than a peak between them, or by their depth."""
    stock = max(sunk, radius - math.sqrt(max(radius**2 - 0.5 * spacing**2, 0.0)))
    return math.sqrt(radius**2 - max(radius - stock, 0.0) ** 2) + CLEAR


def _require_in_reach(made, spindle, axis, machine):
    rate = math.degrees(made.angle) * spindle.speed / made.turns
    if rate > axis["velocity_deg_s"]:
        most = math.floor(60.0 * spindle.speed * axis["velocity_deg_s"] / rate)
        remedy = "axis %s would have to turn at %.4g degrees/s, and does at %.4g: give %d rpm or less."
        said = "%g rpm" % (60.0 * spindle.speed)
        raise InputError("SpindleSpeed", said, remedy % (axis["letter"], rate, axis["velocity_deg_s"], most))
    low, high = axis["limits_degrees"] or (-math.inf, math.inf)
    last = math.degrees(made.angle)
    if not low <= 0.0 <= last <= high:
        remedy = (
            "axis %s has limits and would have to wind from 0 to %.0f degrees: where it can, give null "
            "as its limits_degrees." % (axis["letter"], last)
        )
        raise InputError("Machine", machine.key, remedy)
    limits = machine.data["linear_axes"].get("limits_mm", {})
    zero = machine.data.get("work_zero_mm", (0.0, 0.0, 0.0))
    for k, letter in enumerate("XYZ"):
        low, high = limits.get(letter, (-math.inf, math.inf))
        there = (made.start[k] + zero[k], made.end[k] + zero[k])
        if min(there) < low or max(there) > high:
            remedy = "axis %s would go from %.4g to %.4g mm, beyond its limits." % (letter, *there)
            raise InputError("Machine", machine.key, remedy)


def _turned(vector, axis, angles):
    """(n, 3): a vector across `axis` turned about it by each of `angles` [rad]."""
    beside = np.cross(axis, vector)
    return np.cos(angles)[:, None] * vector + np.sin(angles)[:, None] * beside

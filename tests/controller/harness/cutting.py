"""Cuts with a controller's log: where each dimple really is, and which marks nobody asked for.

A flute's edge is the meridian of the ball in the half-plane of its azimuth ψ about the tool axis.
Its deepest point under a plane with unit normal n is, with n = (sinτ(cosα', sinα'), cosτ) and
a = n·(cosψ, sinψ, 0), b = n_z,
    (c - p)·n - R √(a² + b²)   at the meridian angle φ with tan φ = -a / b (a < 0),
c the ball's centre. Time is searched by brute force around each passing.
SPDX-License-Identifier: LGPL-2.1-or-later
"""
import csv
import dataclasses

import numpy

WINDOW = 8e-3   # s before and after a passing
STEP = 1e-5     # s


@dataclasses.dataclass
class Places:
    """One entry for each dimple, mm."""
    error: numpy.ndarray  # (n, 3) of the deepest point, in the tangent plane
    depth: numpy.ndarray  # of the deepest point below the surface
    rms: float
    largest: float


@dataclasses.dataclass
class Mark:
    """A tooth that passed with the ball in reach of the surface, away from every dimple."""
    time: float
    clearance: float  # of the ball's deepest point above the surface, mm
    distance: float   # from the nearest dimple, mm


def read_surface(path):
    """Points and unit normals of the dimples from the targets' table: two arrays (n, 3)."""
    with open(path, newline='', encoding='ascii') as file:
        rows = list(csv.DictReader(file))
    column = {name: numpy.array([float(row[name]) for row in rows])
              for name in ('px', 'py', 'pz', 'nx', 'ny', 'nz')}
    return (numpy.column_stack([column[k] for k in ('px', 'py', 'pz')]),
            numpy.column_stack([column[k] for k in ('nx', 'ny', 'nz')]))


class Edge:
    """The motion of the ball and its flutes, from a log and the constant phase offset."""

    def __init__(self, log, offset, radius, flutes, sense):
        self.log, self.radius, self.flutes, self.sense = log, radius, flutes, sense
        self.offset = offset  # degrees

    def near(self, begin, end):
        """The same with the log from `begin` to `end` only [s]: of a long log little is looked at."""
        first, last = numpy.searchsorted(self.log.time, [begin, end])
        part = slice(max(first - 1, 0), last + 1)
        log = dataclasses.replace(self.log, time=self.log.time[part], tip=self.log.tip[part],
                                  turns=self.log.turns[part])
        return Edge(log, self.offset, self.radius, self.flutes, self.sense)

    def centre(self, time):
        tip = [numpy.interp(time, self.log.time, self.log.tip[:, k]) for k in range(3)]
        return numpy.column_stack(tip) + [0.0, 0.0, self.radius]

    def azimuths(self, time):
        """(flutes, n) radians."""
        turns = numpy.interp(time, self.log.time, self.log.turns)
        first = self.sense * numpy.radians(360 * turns - self.offset)
        return first + 2 * numpy.pi * numpy.arange(self.flutes)[:, None] / self.flutes

    def deepest(self, time, point, normal):
        """The deepest point of all flutes at the given times under the plane: point, height."""
        centre, best = self.centre(time), (numpy.inf, None)
        for azimuth in self.azimuths(time):
            outward = numpy.column_stack([numpy.cos(azimuth), numpy.sin(azimuth), 0 * azimuth])
            a = numpy.minimum(outward @ normal, 0.0)  # the other half belongs to another flute
            reach = numpy.hypot(a, normal[2])
            height = (centre - point) @ normal - self.radius * reach
            at = int(numpy.argmin(height))
            if height[at] < best[0]:
                on_edge = -(a[at] * outward[at] + [0, 0, normal[2]]) / reach[at]
                best = height[at], centre[at] + self.radius * on_edge
        return best[1], best[0]


def places(edge, report, points, normals):
    """Deepest point of each dimple's mark against its planned place. `report`: of phase.measure."""
    errors, depths = [], []
    for moment, point, normal in zip(report.time, points, normals):
        time = numpy.arange(moment - WINDOW, moment + WINDOW, STEP)
        found, height = edge.near(time[0], time[-1]).deepest(time, point, normal)
        miss = found - point
        errors.append(miss - (miss @ normal) * normal)
        depths.append(-height)
    size = numpy.linalg.norm(errors, axis=1)
    rms = float(numpy.sqrt(numpy.mean(size ** 2)))
    return Places(numpy.array(errors), numpy.array(depths), rms, float(size.max()))


def unwanted_marks(edge, report, points, normals, reach, spacing):
    """Teeth that pass over the surface nearer than `reach` [mm], further than a fifth of `spacing`
    from every dimple. Between rows the ball has to clear the ridges when a tooth passes."""
    lifted = points + edge.radius * normals  # ball centres on the dimples
    time = numpy.arange(report.time[0] - WINDOW, report.time[-1] + WINDOW, 2e-4)
    centre = edge.centre(time)
    marks, near = [], []
    for block in range(0, len(time), 2000):
        part = centre[block:block + 2000]
        near.append(numpy.argmin(((part[:, None] - lifted[None]) ** 2).sum(axis=2), axis=1))
    near = numpy.concatenate(near)
    contact = numpy.arctan2(-normals[near, 1], -normals[near, 0])
    tooth = 2 * numpy.pi / edge.flutes
    angle = (edge.azimuths(time)[0] - contact + tooth / 2) % tooth - tooth / 2
    passing = numpy.nonzero((angle[:-1] * angle[1:] <= 0) & (abs(numpy.diff(angle)) < tooth / 2))[0]
    for index in passing:
        offset = centre[index] - lifted[near[index]]
        clearance = offset @ normals[near[index]]
        distance = numpy.linalg.norm(offset - clearance * normals[near[index]])
        if clearance < reach and 0.2 * spacing < distance < 1.5 * spacing:
            marks.append(Mark(float(time[index]), float(clearance), float(distance)))
    return marks

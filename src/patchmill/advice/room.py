"""Where there is no room for the tool. Faces that bend in more narrowly than its ball: no value and no
inclination makes a dimple there. Faces that are too narrow for the spacing: with few dimples side by side
nearly all lie along a border, and a smaller spacing helps. Walls of the part beside the faces, which a tool
that leans, or the ball of an upright one, runs into.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import itertools
import math
from dataclasses import replace

import _patchmill as core
import Part

from patchmill.advice.found import GOOD_FRACTION
from patchmill.collision.clearance_check import VIOLATED, CheckInput, run_check
from patchmill.geometry import shapes
from patchmill.textures.order import rows
from patchmill.textures.plan import plan_texture

ACROSS = 15  # places along each parameter of a face that are looked at
PLACES = 300  # of a face, where a ball is held against the whole part
STEPS = 0.7548776662466927, 0.5698402909980532  # from one to the next: as evenly in the plane as can be
FLAT = 1e-9  # 1/mm: of less the faces do not bend
ABREAST = 5.0  # dimples side by side: a rim with 3 has quality 0.56, with 6 it is good (docs/advice.md)
# What a new operation allows [mm]: so deep below the model, so near to shank and holder
GOUGE_TOLERANCE, CLEARANCE = 0.01, 0.1
# Radii of the ball: margins that are tried where the tool runs into walls beside the faces
WALL_MARGINS = (1.15, 1.4, 1.7, 2.0, 2.3, 2.65, 3.0, 3.35, 3.75, 4.1, 4.5)
# Diameters [mm] of ball end mills that catalogues have
BALLS = (0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0)
FITS = 0.9  # of the radius with which faces bend in: a ball that touches them at one place only
SMALLER = 0.5  # of the ball, where walls are in the way
EDGES = 20.0  # radii of a ball, up to which it has edges at most; above is the shank


def least_radius(given):
    """The least radius [mm] with which a TextureInput's faces bend in, at ACROSS² places of each; None where
    they nowhere do."""
    most = 0.0
    for text in given.breps:
        for face in shapes.of_brep(text).Faces:
            u0, u1, v0, v1 = face.ParameterRange
            outward = -1.0 if face.Orientation == "Reversed" else 1.0  # curvatures are the surface's
            for i in range(ACROSS):
                for j in range(ACROSS):
                    u, v = u0 + (i + 0.5) / ACROSS * (u1 - u0), v0 + (j + 0.5) / ACROSS * (v1 - v0)
                    if face.isPartOfDomain(u, v):
                        most = max(most, *(outward * k for k in face.curvatureAt(u, v)))
    return 1.0 / most if most > FLAT else None


def ball_too_large(given):
    """least_radius, if the ball is too large for it; else None."""
    radius = least_radius(given)
    return radius if radius is not None and radius < given.tool.radius else None


def smaller_balls(given, walls):
    """Fields of a TextureInput, a dict each, with a smaller ball that is tried where its own does not fit the
    faces' hollows, or, with `walls`, the room beside them; the largest first. The spacing keeps its ratio to
    the ball, and with it the tilts that do."""
    radius, own = ball_too_large(given), given.tool.radius
    limits = [SMALLER * own] if walls else []
    if radius is not None:
        limits = [FITS * radius, SMALLER * radius]
    fitting = [max((d for d in BALLS if 0.5 * d <= limit + 1e-9), default=0.0) for limit in limits]
    return [_with_ball(given, 0.5 * d) for d in sorted(set(fitting), reverse=True) if d > 0.0]


def reached_by(given, radius, model):
    """Of the area of a TextureInput's faces, 0 to 1, where a ball of `radius` [mm] can touch them and comes
    no more than GOUGE_TOLERANCE into a `model`, BREP texts, elsewhere, however the tool leans."""
    others = [face for text in model for face in shapes.of_brep(text).Faces]
    reached = total = 0.0
    for face in (face for text in given.breps for face in shapes.of_brep(text).Faces):
        for point, normal, area in _places(face):
            centre = point + normal * radius
            ball, room = Part.Vertex(centre), radius - GOUGE_TOLERANCE
            near = (one for one in others if _is_near(one.BoundBox, centre, room))
            reached += area * all(one.distToShape(ball)[0] >= room for one in near)
            total += area
    return reached / total if total else 0.0


def _places(face):
    """Yields (point [mm], outward normal, area that it stands for [mm²]) of up to PLACES places of a face."""
    u0, u1, v0, v1 = face.ParameterRange
    cell = (u1 - u0) * (v1 - v0) / PLACES
    for k in range(PLACES):
        u, v = u0 + (0.5 + k * STEPS[0]) % 1.0 * (u1 - u0), v0 + (0.5 + k * STEPS[1]) % 1.0 * (v1 - v0)
        if face.isPartOfDomain(u, v):
            along_u, along_v = face.derivative1At(u, v)
            yield face.valueAt(u, v), face.normalAt(u, v), cell * along_u.cross(along_v).Length


def _is_near(box, centre, room):
    """Whether a point is less than `room` [mm] off a BoundBox."""
    nearest = [
        min(max(centre[k], (box.XMin, box.YMin, box.ZMin)[k]), (box.XMax, box.YMax, box.ZMax)[k])
        for k in range(3)
    ]
    return math.dist(nearest, centre) < room


def short_reach(given, walls, model):
    """[(diameter [mm], part of the faces that it reaches)] of a TextureInput's ball and of those of
    smaller_balls, as many as reach too little of them; none where its own reaches enough."""
    balls = [given.tool, *(fields["tool"] for fields in smaller_balls(given, walls))]
    made = ((2.0 * ball.radius, reached_by(given, ball.radius, model)) for ball in balls)
    return list(itertools.takewhile(lambda one: one[1] < GOOD_FRACTION, made))


def _with_ball(given, radius):
    tool = given.tool
    holder = [section[1:] for section in tool.sections if section[0] == "holder"]
    shaft = {name: getattr(tool, name) for name in ("shank_radius", "stick_out")}
    shaft["cutting_length"] = min(tool.cutting_length, EDGES * radius)
    made = {"tool": core.Tool(radius, tool.flutes, holder=holder, **shaft)}
    if given.spacing:
        made["spacing"] = round(given.spacing * radius / tool.radius, 3)
    return made


def width(face):
    """Of a face [mm]: of one border the short side of the rectangle of the same area and length of border, of
    a ring or a face with holes what is between the borders on the average."""
    length = sum(wire.Length for wire in face.Wires)
    if len(face.Wires) > 1:
        return 2.0 * face.Area / length
    half = 0.5 * length
    return 0.5 * (half - math.sqrt(max(0.0, half * half - 4.0 * face.Area)))


def too_narrow(given):
    """(least width [mm], dimples that lie side by side there) of a TextureInput's faces, if more of their
    area than may be bad lies on ones with less than ABREAST; else None."""
    if not given.spacing:
        return None
    faces = [face for text in given.breps for face in shapes.of_brep(text).Faces]
    widths = [(width(face), face.Area) for face in faces]
    narrow = [(wide, area) for wide, area in widths if wide < ABREAST * given.spacing]
    if sum(area for _, area in narrow) <= (1.0 - GOOD_FRACTION) * sum(area for _, area in widths):
        return None
    least = min(narrow)[0]
    return least, least / given.spacing


def touches(given, model):
    """Whether the path of a TextureInput, or shank or holder on it, goes where posting would refuse it in a
    `model` (BREP texts). False where nobody knows: without a model, or if that is no closed solid."""
    return bool(model) and _plan_touches(plan_texture(given, slower=False), model)


def _plan_touches(plan, model):
    asked = CheckInput(plan.path, list(model), GOUGE_TOLERANCE, CLEARANCE, plan)
    return run_check(asked).outcome == VIOLATED


def held_against(found, plan, model):
    """The Assessment of a PlannedTexture, and whether that touches a `model` as touches() says."""
    return replace(found, touches=bool(model) and _plan_touches(plan, model))


def beside_walls(given):
    """Fields of a TextureInput, a dict each, one of which may keep the tool off walls: wider margins [mm],
    the least first, each with rows as they are and across: they run in and out at their ends."""
    margins = [round(m * given.tool.radius, 4) for m in WALL_MARGINS if m * given.tool.radius > given.margin]
    across = rows.ACROSS.get(given.row_direction)
    other = [{"row_direction": across}] if across and given.order == rows.ROWS else []
    ways: list[dict] = [{}, *other]
    return [dict(turned, margin=margin) for margin in margins for turned in ways]

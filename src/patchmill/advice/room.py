"""Where there is no room for the tool. Faces that bend in more narrowly than its ball: no value and no
inclination makes a dimple there. Faces that are too narrow for the spacing: with few dimples side by side
nearly all lie along a border, and a smaller spacing helps. Walls of the part beside the faces, which a tool
that leans, or the ball of an upright one, runs into.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math

from patchmill.advice import orientation
from patchmill.advice.found import GOOD_FRACTION
from patchmill.collision.clearance_check import VIOLATED, CheckInput, run_check
from patchmill.textures.plan import plan_texture

ACROSS = 15  # places along each parameter of a face that are looked at
FLAT = 1e-9  # 1/mm: of less the faces do not bend
ABREAST = 5.0  # dimples side by side: a rim with 3 has quality 0.56, with 6 it is good (docs/advice.md)
# What a new operation allows [mm]: so deep below the model, so near to shank and holder
GOUGE_TOLERANCE, CLEARANCE = 0.01, 0.1
# Radii of the ball: margins that are tried where the tool runs into walls beside the faces
WALL_MARGINS = (1.15, 2.3, 3.0, 3.75, 4.5)


def least_radius(given):
    """The least radius [mm] with which a TextureInput's faces bend in, at ACROSS² places of each; None where
    they nowhere do."""
    most = 0.0
    for text in given.breps:
        for face in orientation.shape_of(text).Faces:
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
    faces = [face for text in given.breps for face in orientation.shape_of(text).Faces]
    widths = [(width(face), face.Area) for face in faces]
    narrow = [(wide, area) for wide, area in widths if wide < ABREAST * given.spacing]
    if sum(area for _, area in narrow) <= (1.0 - GOOD_FRACTION) * sum(area for _, area in widths):
        return None
    least = min(narrow)[0]
    return least, least / given.spacing


def touches(given, model):
    """Whether the path of a TextureInput, or shank or holder on it, goes where posting would refuse it in a
    `model` (BREP texts). False where nobody knows: without a model, or if that is no closed solid."""
    if not model:
        return False
    plan = plan_texture(given)
    asked = CheckInput(plan.path, list(model), GOUGE_TOLERANCE, CLEARANCE, plan)
    return run_check(asked).outcome == VIOLATED


def margins_beside_walls(given):
    """Margins [mm] that are wider than a TextureInput's, one of which may keep the tool off walls."""
    return [round(m * given.tool.radius, 4) for m in WALL_MARGINS if m * given.tool.radius > given.margin]

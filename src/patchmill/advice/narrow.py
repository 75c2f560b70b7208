"""Where faces are too narrow for the spacing: with few dimples side by side nearly all lie along a border. A
smaller spacing helps.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import math

from patchmill.advice import orientation
from patchmill.advice.found import GOOD_FRACTION

ACROSS = 5.0  # dimples side by side: a rim with 3 has quality 0.56, with 6 it is good (docs/advice.md)


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
    area than may be bad lies on ones with less than ACROSS; else None."""
    if not given.spacing:
        return None
    faces = [face for text in given.breps for face in orientation.shape_of(text).Faces]
    widths = [(width(face), face.Area) for face in faces]
    narrow = [(wide, area) for wide, area in widths if wide < ACROSS * given.spacing]
    if sum(area for _, area in narrow) <= (1.0 - GOOD_FRACTION) * sum(area for _, area in widths):
        return None
    least = min(narrow)[0]
    return least, least / given.spacing

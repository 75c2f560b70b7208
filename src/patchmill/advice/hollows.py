"""Where faces bend in more narrowly than the ball of the tool: no value and no inclination makes a dimple
there.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from patchmill.advice import orientation

ACROSS = 15  # places along each parameter of a face that are looked at
FLAT = 1e-9  # 1/mm: of less the faces do not bend


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


def too_narrow(given):
    """least_radius, if the ball is too large for it; else None."""
    radius = least_radius(given)
    return radius if radius is not None and radius < given.tool.radius else None

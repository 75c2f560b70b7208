"""The properties of the texture operations that say how a ball is covered (see property_table for what the
rows of the table are).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

BALL_PROPERTIES = [
    (
        "App::PropertyEnumeration",
        "BallLattice",
        "Texture",
        "Lattice of a ball: icosahedral, most even; along a Fibonacci spiral; or in rings about its pole",
        ["Icosahedral", "Fibonacci", "Rings"],
    ),
    ("App::PropertyInteger", "BallDimples", "Texture", "Dimples on the whole ball; 0: by the spacing", 0),
    (
        "App::PropertyEnumeration",
        "BallSetups",
        "Texture",
        "One: dimples no steeper than the limit; two: those of the half that looks to the tool, the others "
        "after the ball was turned over",
        ["One", "Two"],
    ),
]
